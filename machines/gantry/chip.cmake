trammel_chip(gantry_tau INTERFACE GantryChip SETUP ChipSetup TRACE_ARRAYS 16)
