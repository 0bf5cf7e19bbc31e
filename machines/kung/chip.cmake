trammel_chip(kung_xy INTERFACE KungChip)
