trammel_chip(@name@_pwm INTERFACE cosim::PinnedChip)
