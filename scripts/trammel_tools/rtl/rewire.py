# SPDX-License-Identifier: Apache-2.0
"""The command `rewire NET KIND` of Yosys, for negative controls: a named net of a module gets
another value, in every instance of the module.

The module declares VALUE, what the net is to be, and BEFORE, which becomes what the sources make of
it. `value`: readers of the net see VALUE. `load`: the register loads VALUE at each edge.

It runs on what slang made, where every name still has its own driver.
"""

try:
    from pyosys import libyosys as ys
except ImportError:  # the names below are needed without it
    ys = None

VALUE, BEFORE = "trammel_value", "trammel_before"
KINDS = {"=": "value", "<=": "load"}  # by the sign of a control


def splice(module, net, value, before):
    """Whether the net had a driver, which drives `before` now."""
    found, old, new = False, ys.SigSpec(net), ys.SigSpec(before, 0, net.width)
    for cell in list(module.cells_.values()):
        for port, signal in list(cell.connections_.items()):
            if cell.output(port):
                moved = ys.SigSpec(signal)
                moved.replace(old, new)
                if moved != signal:
                    cell.setPort(port, moved)
                    found = True
    if found:
        module.connect(old, ys.SigSpec(value, 0, net.width))
    return found


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


def register():
    """Makes the command known; returns what must live as long as it."""

    class Rewire(ys.Pass):
        def __init__(self):
            super().__init__("rewire", "give a named net of a module another value")

        def execute(self, words, design):
            _, name, kind = words
            module = design.top_module()
            wires = {wire.name.str()[1:]: wire for wire in list(module.wires_.values())}
            places = [path.removesuffix(VALUE) for path in wires
                      if path == VALUE or path.endswith(f".{VALUE}")]
            for place in places:
                net = wires.get(place + name)
                change = splice if kind == "value" else load
                what = "net with a driver" if kind == "value" else "register"
                before, value = wires[place + BEFORE], wires[place + VALUE]
                if net is None or not change(module, net, value, before):
                    ys.log_error(f"{name} is no {what} of the module\n")
                if before.width > net.width:  # that of a port, whose width is not known before
                    rest = before.width - net.width
                    module.connect(ys.SigSpec(before, net.width, rest), ys.SigSpec(0, rest))
            if not places:
                ys.log_error(f"the block has no instance of the module of {name}\n")

    return Rewire()
