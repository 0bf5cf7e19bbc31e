trammel_with_part(lm628)
set(how INTERFACE McafeeChip TRACE_ARRAYS 64
  VISIBLE ${PROJECT_SOURCE_DIR}/parts/lm628/verilated/public.vlt)
trammel_chip(mcafee_xy ${how} FUNCTION make_chip_of_6MHz)
trammel_chip(mcafee_xy ${how} FUNCTION make_chip_of_8MHz KIND 8mhz PARAMETERS Inc=4)
