trammel_chip(lm628 INTERFACE Lm628Chip TRACE_ARRAYS 64)  # its memory has 64 words
