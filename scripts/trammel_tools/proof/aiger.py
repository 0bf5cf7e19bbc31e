# SPDX-License-Identifier: Apache-2.0
"""Binary AIGER models; and what makes induction mutual: the memory that something has failed."""

from dataclasses import dataclass


@dataclass
class Model:
    """Literals are 2 * variable + inverted; inputs, latches and gates in this order."""

    inputs: int
    nexts: list[int]  # of the latches
    outputs: list[int]
    bad: list[int]
    gates: list[tuple[int, int]]
    symbols: str = ""  # the text behind the gates


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


def read(source):
    data = source.read_bytes()
    head, _, rest = data.partition(b"\n")
    _, inputs, latches, outputs, count, *more = map(int, head.split()[1:7])
    bad = more[0] if more else 0
    lines = rest.split(b"\n", latches + outputs + bad)
    place = len(data) - len(lines.pop())
    words = [int(line.split()[0]) for line in lines]
    gates = []
    for gate in range(count):
        left = 2 * (inputs + latches + 1 + gate)
        delta, place = number(data, place)
        high = left - delta
        delta, place = number(data, place)
        gates.append((high, high - delta))
    return Model(inputs, words[:latches], words[latches:latches + outputs],
                 words[latches + outputs:], gates, data[place:].decode())


def write(target, model):
    latches, gates = len(model.nexts), len(model.gates)
    head = f"aig {model.inputs + latches + gates} {model.inputs} {latches} {len(model.outputs)} " \
           f"{gates}" + (f" {len(model.bad)}" if model.bad else "") + "\n"
    head += "".join(f"{word}\n" for word in [*model.nexts, *model.outputs, *model.bad])
    first = 2 * (model.inputs + latches + 1)
    target.write_bytes(head.encode() + b"".join(
        coded(first + 2 * n - max(pair)) + coded(max(pair) - min(pair))
        for n, pair in enumerate(model.gates)))


def guard(source, target, members):
    """Writes target: outputs as in source, but those of `members` only rise while none of them has
    been high at an earlier clock. What is never the first to fail never fails.

    The new latch comes between inputs and gates, and the gates move up by one.
    """
    model = read(source)
    inputs, latches = model.inputs, len(model.nexts)
    last = 2 * (inputs + latches) + 1  # the highest literal that stays

    def moved(literal):
        return literal + 2 if literal > last else literal

    failed = last + 1  # the new latch
    nexts = [moved(word) for word in model.nexts]
    tests = [moved(word) for word in model.outputs + model.bad]
    pairs = [(moved(high), moved(low)) for high, low in model.gates]

    def both(a, b):
        pairs.append((a, b))
        return failed + 2 * len(pairs)

    intact = failed ^ 1
    for member in members:
        intact = both(intact, tests[member] ^ 1)
    for member in members:
        tests[member] = both(tests[member], failed ^ 1)
    write(target, Model(inputs, [*nexts, intact ^ 1], [], tests, pairs))
