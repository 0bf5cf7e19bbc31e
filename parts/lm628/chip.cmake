# Its memory has 64 words. The clock of a part is a parameter of the RTL.
set(how INTERFACE Lm628Chip TRACE_ARRAYS 64 SETUP PartOptions)
trammel_chip(lm628 ${how} FUNCTION make_chip_of_8MHz)
trammel_chip(lm628 ${how} FUNCTION make_chip_of_6MHz KIND 6mhz PARAMETERS Inc=3)
