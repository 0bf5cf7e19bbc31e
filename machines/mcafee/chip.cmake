trammel_chip(mcafee_xy INTERFACE McafeeChip TRACE_ARRAYS 64
  VISIBLE ${PROJECT_SOURCE_DIR}/parts/lm628/verilated/public.vlt)
