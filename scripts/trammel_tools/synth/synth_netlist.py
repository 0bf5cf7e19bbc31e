# SPDX-License-Identifier: Apache-2.0
"""Counts the cells of a mapped netlist, in total and by the block that owns each cell.

A named bit belongs to the block that drives it, through all levels. A cell belongs to the owner of
what it drives; logic between named signals belongs to the block it feeds, and logic that feeds
several of them to the block around them.
"""

import collections
import re

MUXES = ("PFUMX", "L6MUX21")  # join lookup tables and take no cell of their own


class Count(collections.Counter):
    """Cell types; `cells` is what nextpnr makes of them: TRELLIS_COMB."""

    def table(self):
        if any(kind.startswith("SB_") for kind in self):
            return self.table_of_ice40()
        # A lookup memory takes four cells and blocks two; a carry chain takes four more than bits.
        memory = 6 * self["TRELLIS_DPR16X4"]
        carry = 2 * self["CCU2C"] + 4 * self["chain"]
        return {"cells": self["LUT4"] + carry + memory, "lut4": self["LUT4"], "carry": carry,
                "ff": self["TRELLIS_FF"], "block_ram": self["DP16KD"] + self["PDPW16KD"],
                "multipliers": self["MULT18X18D"]}

    def table_of_ice40(self):
        """As table; a cell is a lookup table, or a bit of a carry chain that has none."""
        ff = sum(n for kind, n in self.items() if kind.startswith("SB_DFF"))
        return {"cells": self["SB_LUT4"], "lut4": self["SB_LUT4"], "carry": self["SB_CARRY"],
                "ff": ff, "block_ram": self["SB_RAM40_4K"], "multipliers": self["SB_MAC16"]}


def scope_of(path):
    return path.rsplit(".", 1)[0] if "." in path else ""


def common(scopes):
    """The innermost scope around all of them."""
    parts = [scope.split(".") if scope else [] for scope in scopes]
    shared = []
    for level in zip(*parts):
        if len(set(level)) > 1:
            break
        shared.append(level[0])
    return ".".join(shared)


class Module:
    """What drives each bit of a module before flattening."""

    def __init__(self, module, instances):
        self.ids = {name: net["bits"] for name, net in module["netnames"].items()}
        self.copy_of = {}
        self.inputs, self.outputs = {}, {}  # bit -> (port, index), (instance, port, index)
        self.connections = {}
        for port, net in module["ports"].items():
            if net["direction"] == "input":
                self.inputs.update((bit, (port, n)) for n, bit in enumerate(net["bits"]))
        for name, cell in module["cells"].items():
            wires = cell["connections"]
            if cell["type"] == "$buf":
                self.copy_of.update(zip(wires["Y"], wires["A"]))
            if cell["type"] in instances:
                self.connections[name] = wires
                for port, bits in wires.items():
                    if instances[cell["type"]]["ports"][port]["direction"] == "output":
                        self.outputs.update((bit, (name, port, n)) for n, bit in enumerate(bits))
        self.names = {}  # bit -> its best name: a register's, which ends in _q, then a short one
        for name, net in module["netnames"].items():
            order = (not name.endswith("_q"), len(name), name)
            for bit in net["bits"]:
                if not net.get("hide_name") and order < self.names.get(bit, (2,)):
                    self.names[bit] = order

    def driver(self, bit):
        while bit in self.copy_of:
            bit = self.copy_of[bit]
        return bit


class Netlist:
    def __init__(self, modules, mapped, top):
        self.top = top
        self.cells = mapped["modules"][top]["cells"]
        self.module_of = {}  # instance path -> Module
        self.block_of = {}  # instance path -> layer/block
        self._made = {}
        self._walk(modules["modules"], top, "")
        self.names = {}  # bit -> (owner, signal)
        for name, net in mapped["modules"][top]["netnames"].items():
            if not net.get("hide_name"):
                self._name(name, net["bits"])
        self.sinks = collections.defaultdict(list)  # bit -> cells that read it
        self.drivers = {}
        for name, cell in self.cells.items():
            for port, bits in cell["connections"].items():
                for bit in bits:
                    if cell["port_directions"].get(port) == "input":
                        self.sinks[bit].append(name)
                    else:
                        self.drivers[bit] = name
        self._owners = {}

    def _walk(self, modules, module, path):
        if module not in self._made:
            self._made[module] = Module(modules[module], modules)
        self.module_of[path] = self._made[module]
        source = modules[module]["attributes"].get("src", "")
        found = re.search(r"rtl/(\w+)/(?:\w+/)?(\w+)\.sv", source)
        self.block_of[path] = "/".join(found.groups()) if found else module.split("$")[0]
        for name, cell in modules[module]["cells"].items():
            if cell["type"] in modules:
                self._walk(modules, cell["type"], f"{path}.{name}" if path else name)

    def _name(self, name, bits):
        scope = scope_of(name)
        while scope not in self.module_of:  # a name may have dots that are no levels
            scope = scope_of(scope)
        inside = self.module_of[scope].ids.get(name[len(scope) + 1:] if scope else name, [])
        for bit, before in zip(bits, inside):
            found = self._driver(scope, before)
            if found and found > self.names.get(bit, ("", "")):  # of merged ones: any, but the same
                self.names[bit] = found

    def _driver(self, scope, bit):
        """(instance path, signal) that drives a bit of the module at scope; None: a constant."""
        while True:
            module = self.module_of[scope]
            bit = module.driver(bit)
            if isinstance(bit, str):
                return None
            if bit in module.outputs:
                instance, port, index = module.outputs[bit]
                scope = f"{scope}.{instance}" if scope else instance
                bit = self.module_of[scope].ids[port][index]
            elif bit in module.inputs and scope:
                port, index = module.inputs[bit]
                parent = scope_of(scope)
                while parent not in self.module_of:
                    parent = scope_of(parent)
                instance = scope[len(parent) + 1:] if parent else scope
                scope, bit = parent, self.module_of[parent].connections[instance][port][index]
            else:
                return scope, module.names.get(bit, ("", 0, ""))[2]

    def outputs(self, name):
        cell = self.cells[name]
        return [bit for port, bits in cell["connections"].items() for bit in bits
                if cell["port_directions"].get(port) == "output"]

    def signal(self, name):
        """(owner, register) of a flip-flop, multiplier or memory."""
        for bit in self.outputs(name):
            if bit in self.names:
                return self.names[bit]
        return self.owner(name), ""

    def owner(self, name):
        """Instance path; without recursion, since chains of cells are long."""
        pending = [name]
        begun = set()
        while pending:
            cell = pending[-1]
            if cell in self._owners:
                pending.pop()
                continue
            outputs = self.outputs(cell)
            named = [self.names[bit][0] for bit in outputs if bit in self.names]
            readers = {sink for bit in outputs for sink in self.sinks[bit]}
            if named:
                self._owners[cell] = common(named)
            elif cell in begun:
                self._owners[cell] = common([self._owners[sink] for sink in readers
                                             if sink in self._owners])
            else:
                begun.add(cell)
                pending += [sink for sink in readers
                            if sink not in self._owners and sink not in begun]
        return self._owners[name]

    def heads_chain(self, cell):
        """A carry cell whose input comes from no other one."""
        driver = self.drivers.get(cell["connections"]["CIN"][0])
        return driver is None or self.cells[driver]["type"] != "CCU2C"

    def count(self):
        """Instance path -> Count of what it owns itself."""
        counts = collections.defaultdict(Count)
        for name, cell in self.cells.items():
            kind = cell["type"]
            if kind.startswith("$") or kind in MUXES:
                continue
            counts[self.owner(name)][kind] += 1
            if kind == "CCU2C" and self.heads_chain(cell):
                counts[self.owner(name)]["chain"] += 1
        return counts

    def by_block(self):
        """Block -> (instances, Count of all of them with what they contain)."""
        own = self.count()
        totals = {}
        for path, block in self.block_of.items():
            inside = Count()
            for other, count in own.items():
                if other == path or not path or other.startswith(f"{path}."):
                    inside.update(count)
            instances, total = totals.get(block, (0, Count()))
            total.update(inside)
            totals[block] = (instances + 1, total)
        return totals

    def total(self):
        whole = Count()
        for count in self.count().values():
            whole.update(count)
        return whole
