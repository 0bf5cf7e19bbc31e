trammel_chip(gantry INTERFACE GantryChip SETUP ChipSetup TRACE_ARRAYS 16)
