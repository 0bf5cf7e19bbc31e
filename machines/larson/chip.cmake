trammel_chip(larson_xy INTERFACE LarsonChip SETUP ChipSetup)
