# SPDX-License-Identifier: Apache-2.0
"""Adds to an AIGER model what makes induction mutual: the memory that something has failed."""


def number(data, place):
    """A number in groups of seven bits from `place` on, the lowest first; and the place behind."""
    value = shift = 0
    while True:
        byte = data[place]
        value |= (byte & 0x7F) << shift
        place, shift = place + 1, shift + 7
        if byte < 0x80:
            return value, place


def coded(value):
    groups = bytearray()
    while value >= 0x80:
        groups.append(value & 0x7F | 0x80)
        value >>= 7
    groups.append(value)
    return bytes(groups)


def guard(source, target, members):
    """Writes target: outputs as in source, but those of `members` only rise while none of them has
    been high at an earlier clock. What is never the first to fail never fails.

    Binary AIGER: inputs, latches and gates are numbered in this order, so the new latch comes
    between and the gates move up by one.
    """
    data = source.read_bytes()
    head, _, rest = data.partition(b"\n")
    _, inputs, latches, outputs, gates, bad = map(int, head.split()[1:7])
    lines = rest.split(b"\n", latches + outputs + bad)
    place = len(data) - len(lines.pop())
    words = [int(line.split()[0]) for line in lines]
    last = 2 * (inputs + latches) + 1  # the highest literal that stays

    def moved(literal):
        return literal + 2 if literal > last else literal

    failed = last + 1  # the new latch
    nexts = [moved(word) for word in words[:latches]]
    tests = [moved(word) for word in words[latches:]]
    pairs = []
    for gate in range(gates):
        left = 2 * (inputs + latches + 1 + gate)
        delta, place = number(data, place)
        high = left - delta
        delta, place = number(data, place)
        pairs.append((moved(high), moved(high - delta)))

    def both(a, b):
        pairs.append((max(a, b), min(a, b)))
        return failed + 2 * len(pairs)

    intact = failed ^ 1
    for member in members:
        intact = both(intact, tests[member] ^ 1)
    for member in members:
        tests[member] = both(tests[member], failed ^ 1)
    text = f"aig {inputs + latches + 1 + len(pairs)} {inputs} {latches + 1} 0 {len(pairs)} " \
           f"{len(tests)}\n"
    text += "".join(f"{word}\n" for word in [*nexts, intact ^ 1, *tests])
    body = b"".join(coded(failed + 2 * n - high) + coded(high - low)
                    for n, (high, low) in enumerate(pairs, 1))
    target.write_bytes(text.encode() + body)
