# SPDX-License-Identifier: Apache-2.0
"""The command `rewire` of Yosys, for negative controls: a named net of a module gets another value,
in every instance of the module.

  rewire NET KIND                         one change
  rewire NET KIND CUT [NET KIND CUT]...   cuts for several changes, one of which is chosen later

The module declares VALUE, what the net is to be, and BEFORE, which becomes what the sources make of
it. `value`: readers of the net see VALUE. `load`: the register loads VALUE at each edge.

At a cut they see or load a new input of the top, SEEN and the cut's number. What the sources make
of the net, and each value that a change gives it, become outputs: OLD and NEW. The module declares
BEFORE with the cut's number behind it, and VALUE with that, `_` and the change's number.

It runs on what slang made, where every name still has its own driver.
"""

import re

try:
    from pyosys import libyosys as ys
except ImportError:  # the names below are needed without it
    ys = None

VALUE, BEFORE = "trammel_value", "trammel_before"
SEEN, OLD, NEW = "trammel_seen", "trammel_old", "trammel_new"  # ports of a cut
KINDS = {"=": "value", "<=": "load"}  # by the sign of a control


def splice(module, changes):
    """(net, value, before) of each change; how many bits of each net had a driver, which drives
    `before` now. All at once, since a look at every cell takes long."""
    driven = {net.name.str(): set() for net, *_ in changes}
    old, new = ys.SigSpec(), ys.SigSpec()
    for net, _, before in changes:
        old.append(ys.SigSpec(net))
        new.append(ys.SigSpec(before, 0, net.width))
    for cell in list(module.cells_.values()) if changes else []:
        for pin, signal in list(cell.connections_.items()):
            if cell.output(pin):
                moved = ys.SigSpec(signal)
                moved.replace(old, new)
                if moved != signal:
                    for bit in signal.to_sigbit_vector():
                        if bit.is_wire() and bit.wire.name.str() in driven:
                            driven[bit.wire.name.str()].add(bit.offset)
                    cell.setPort(pin, moved)
    for net, value, _ in changes:
        if driven[net.name.str()]:
            module.connect(ys.SigSpec(net), ys.SigSpec(value, 0, net.width))
    return {name: len(bits) for name, bits in driven.items()}


def load(module, net, value, before):
    """Whether the net is a register."""
    found = False
    for cell in list(module.cells_.values()):
        if cell.type.str() != "$dff":
            continue
        held, loaded = (cell.getPort(ys.IdString(port)) for port in ("\\Q", "\\D"))
        bits = ys.SigSpec()
        for q, d in zip(held.to_sigbit_vector(), loaded.to_sigbit_vector()):
            if q.is_wire() and q.wire.name == net.name:
                module.connect(ys.SigSpec(before, q.offset, 1), ys.SigSpec(d, 1))
                bits.append(ys.SigSpec(value, q.offset, 1))
                found = True
            else:
                bits.append(ys.SigSpec(d, 1))
        cell.setPort(ys.IdString("\\D"), bits)
    return found


def places(module, wires, name, kind, cut):
    """(net, what it is to be, what the sources make of it) in each instance of the module."""
    tail, changes = BEFORE + cut, []
    for place in [path.removesuffix(tail) for path in wires
                  if path == tail or path.endswith(f".{tail}")]:
        net, before = wires.get(place + name), wires[place + tail]
        if net is None:
            refuse(name, kind)
        value = ports(module, wires, place, cut, net.width) if cut else wires[place + VALUE]
        changes.append((net, value, before))
    if not changes:
        ys.log_error(f"the block has no instance of the module of {name}\n")
    return changes


def refuse(name, kind):
    what = "net with a driver" if kind == "value" else "register"
    ys.log_error(f"{name} is no {what} of the module\n")


def ports(module, wires, place, cut, width):
    """The input SEEN of a cut, beside its outputs."""
    values = re.compile(re.escape(place + VALUE + cut) + r"(_\d+)")
    shown = {OLD + cut: wires[place + BEFORE + cut]}
    shown |= {NEW + cut + found[1]: wire for path, wire in wires.items()
              if (found := values.fullmatch(path))}
    for name, wire in shown.items():
        output = module.addWire(ys.IdString(f"\\{place}{name}"), width)
        output.port_output = True
        module.connect(ys.SigSpec(output), ys.SigSpec(wire, 0, width))
    seen = module.addWire(ys.IdString(f"\\{place}{SEEN}{cut}"), width)
    seen.port_input = True
    module.fixup_ports()
    return seen


def register():
    """Makes the command known; returns what must live as long as it."""

    class Rewire(ys.Pass):
        def __init__(self):
            super().__init__("rewire", "give a named net of a module another value")

        def execute(self, words, design):
            module = design.top_module()
            wires = {wire.name.str()[1:]: wire for wire in list(module.wires_.values())}
            words = [*words[1:], ""] if len(words) == 3 else words[1:]
            wanted = list(zip(words[::3], words[1::3], words[2::3], strict=True))
            changes = [(name, kind, cut, *place) for name, kind, cut in wanted
                       for place in places(module, wires, name, kind, cut)]
            for name, kind, _, *change in changes:
                if kind == "load" and not load(module, *change):
                    refuse(name, kind)
            driven = splice(module, [change for _, kind, _, *change in changes if kind == "value"])
            for name, kind, cut, net, _, before in changes:
                # A bit without a driver would be free at a cut, whatever change is chosen.
                if kind == "value" and driven[net.name.str()] < (net.width if cut else 1):
                    refuse(name, kind)
                if before.width > net.width:  # that of a port, whose width is not known before
                    rest = before.width - net.width
                    module.connect(ys.SigSpec(before, net.width, rest), ys.SigSpec(0, rest))

    return Rewire()
