# SPDX-License-Identifier: Apache-2.0
"""Which registers the assertions read that the lemmas of clock domains are asked under.

These lemmas hold the timers of one clock beside the untimed domains of another. Each assertion is
proven of one clock. It holds of such a mixture too if it reads timers only or untimed domains only,
beside pins, which may be anything, and registers that stay. Assertions that read one register of a
properties file have to hold with the same value of it, and count as one.
"""

from trammel_tools.proof.properties import PropertiesError

ASSERTIONS = ("$assert", "$check")


class Cones:
    """What bits of a netlist depend on in the same clock."""

    def __init__(self, domains, timers):
        self.cells, self.domains = domains.top["cells"], domains
        self.drivers = {}
        for name, cell in self.cells.items():
            if "dff" not in cell["type"]:
                self.drivers |= dict.fromkeys(
                    (bit for pin, bits in cell["connections"].items()
                     if cell["port_directions"][pin] == "output" for bit in bits), name)
        self.registers = {domains.nets[bit]: bit for bit in domains.of}
        self.timers = timers
        self.shadows = {bit: name for name, net in domains.top["netnames"].items()
                        if "_props." in name and not name.endswith(".live_q")
                        for bit in net["bits"] if bit in domains.clocked}
        self.reads = {bit: name for name in domains.memories
                      for bit in domains.top["ports"][f"{name}.RD_DATA"]["bits"]}

    def of(self, cell):
        """(timers, registers and memories of a domain {name: domain}, shadows) that it reads."""
        timers, others, shadows = set(), {}, set()
        seen, rest = set(), [*inputs(self.cells[cell])]
        while rest:
            bit = rest.pop()
            if bit in seen:
                continue
            seen.add(bit)
            if bit in self.registers:
                name = self.registers[bit]
                if name in self.timers:
                    timers.add(name)
                else:
                    others[name] = self.domains.of[name]
            elif bit in self.shadows:
                shadows.add(bit)
            elif bit in self.reads:
                others[self.reads[bit]] = self.domains.memories[self.reads[bit]]
                rest += self.domains.top["ports"][f"{self.reads[bit]}.RD_ADDR"]["bits"]
            elif bit in self.drivers:
                rest += inputs(self.cells[self.drivers[bit]])
        return timers, others, shadows


def inputs(cell):
    return [bit for pin, bits in cell["connections"].items()
            if cell["port_directions"][pin] == "input" for bit in bits]


def check(domains, timers, timed):
    """PropertiesError if assertions mix timers with registers of domains that are not in timed."""
    cones = Cones(domains, set(timers))
    groups = []  # (names, timers, registers of untimed domains, shadows)
    for name, cell in domains.top["cells"].items():
        if cell["type"] in ASSERTIONS:
            read, others, shadows = cones.of(name)
            free = {other for other, domain in others.items()
                    if domain is not None and domain not in timed}
            joined = ([name], read, free, shadows)
            for group in [group for group in groups if group[3] & shadows]:
                groups.remove(group)
                joined = ([*group[0], *joined[0]], *(a | b for a, b in zip(group[1:], joined[1:])))
            groups.append(joined)
    for names, read, free, _ in groups:
        if read and free:
            raise PropertiesError(
                f"{', '.join(names)}: no lemma of clock domains may rest on what reads the timers "
                f"({min(read)}) and a domain that is not timed ({min(free)})")
