# SPDX-License-Identifier: Apache-2.0
"""A netlist as nextpnr-ecp5 has placed it, as Verilog that Verilator runs.

Lookup tables become expressions, flip-flops one block for each enable and reset, block RAMs stay
instances of rtl/boards/cells/ecp5_models.v. Pads, clock buffers and the PLL become wires: the clock
pin is the chip's clock, and the PLL has locked. What the netlist has beyond this is refused.

The top has an input more, flip_i: with {n, 1, i} bit i of the lookup table n (1 to 7) is flipped,
to show that a comparison finds it. These tables stand in front of registers behind output pins.
"""

import functools
import itertools
import json
import re

from trammel_tools.synth.synth_flow import FlowError

FLIPS = 7
LUT_PINS = "ABCD"
LOW = "1'b0"  # what a pin without a wire is, but for those of lookup tables


def expression(bits, names):
    """The shortest form that splitting by one variable after the other gives."""
    value = set(bits)
    if value == {"0"}:
        return "1'b0"
    if value == {"1"}:
        return "1'b1"
    *rest, name = names
    low, high = bits[:len(bits) // 2], bits[len(bits) // 2:]
    if low == high:
        return expression(low, rest)
    opposite = "".join("1" if b == "0" else "0" for b in low)
    if high == opposite:
        return f"({name} ^ {expression(low, rest)})" if set(low) != {"0"} else name
    forms = {("0", None): "({n} & {h})", (None, "0"): "(~{n} & {l})",
             ("1", None): "(~{n} | {h})", (None, "1"): "({n} | {l})"}
    for (a, b), form in forms.items():
        if (a is None or set(low) == {a}) and (b is None or set(high) == {b}):
            return form.format(n=name, h=expression(high, rest), l=expression(low, rest))
    return f"({name} ? {expression(high, rest)} : {expression(low, rest)})"


@functools.cache
def shortest(bits):
    """(expression of a table, bit 0 first, in {A} to {D}) over all orders of its variables."""
    best = None
    for order in itertools.permutations(range(4)):
        table = ["0"] * 16
        for n in range(16):
            place = sum((n >> variable & 1) << at for at, variable in enumerate(order))
            table[place] = bits[n]
        found = expression("".join(table), ["{" + LUT_PINS[v] + "}" for v in order])
        if best is None or len(found) < len(best):
            best = found
    return best


def read_contents(path):
    """{number: the 2048 words of 9 bits of a block RAM} of a configuration."""
    found, words = {}, None
    for line in path.read_text(encoding="ascii").split("\n"):
        if line.startswith("."):
            number = re.fullmatch(r"\.bram_init (\d+)", line)
            words = found.setdefault(int(number[1]), []) if number else None
        elif words is not None:
            words += [int(word, 16) for word in line.split()]
    return {number: tuple(words) for number, words in found.items()}


class Placed:
    def __init__(self, path, top, contents=None):
        """contents: {words of a block RAM as placed: those in their place}."""
        design = json.loads(path.read_text(encoding="utf-8"))["modules"]
        self.module = next(iter(design.values()))
        self.top = top
        self.contents = contents or {}
        self.cells = self.module["cells"]
        self.lines = []
        self.by_output = {}
        for name, cell in self.cells.items():
            for port, bits in cell["connections"].items():
                if cell["port_directions"].get(port) == "output":
                    self.by_output.update((bit, name) for bit in bits)
        self.flips = self.choose_flips()

    def pin(self, cell, port, default):
        bits = self.cells[cell]["connections"].get(port, [])
        if not bits:
            return default
        return f"n{bits[0]}" if isinstance(bits[0], int) else f"1'b{bits[0]}"

    def wired(self, cell, port):
        """A pin of a multiplier or memory: high without a wire, inverted or constant by its mux."""
        mux = self.parameter(cell, f"{port}MUX")
        value = self.pin(cell, port, "1'b1")
        return {"0": "1'b0", "1": "1'b1", "INV": f"~{value}"}.get(mux, value)

    def out(self, cell, port):
        bits = self.cells[cell]["connections"].get(port, [])
        return f"n{bits[0]}" if bits else None

    def parameter(self, cell, name, default=""):
        return self.cells[cell]["parameters"].get(name, default).strip()

    def pads(self):
        """{port and index: the pad's cell}."""
        by_net = {cell["connections"]["B"][0]: name for name, cell in self.cells.items()
                  if cell["type"] == "TRELLIS_IO"}
        return {(port, n): by_net.get(bit) for port, net in self.module["ports"].items()
                for n, bit in enumerate(net["bits"])}

    def choose_flips(self):
        """{lookup table: its number}; those before registers behind the first pins of a port."""
        found = {}
        for (port, n), pad in sorted(self.pads().items()):
            if n or pad is None or self.module["ports"][port]["direction"] != "output":
                continue
            register = self.by_output.get(next(iter(self.cells[pad]["connections"]["I"]), None))
            if register is None or self.cells[register]["type"] != "TRELLIS_FF":
                continue
            table = self.by_output.get(self.cells[register]["connections"]["DI"][0])
            if (table and self.cells[table]["type"] == "TRELLIS_COMB" and table not in found
                    and self.parameter(table, "MODE", "LOGIC") == "LOGIC" and len(found) < FLIPS):
                found[table] = (len(found) + 1, port)
        return found

    def comb(self, name):
        mode = self.parameter(name, "MODE", "LOGIC")
        bits = self.parameter(name, "INITVAL", "0" * 16)[::-1]
        pins = {p: self.pin(name, p, "1'b1") for p in LUT_PINS}  # a pin without a wire is high
        out, wide, carry = (self.out(name, p) for p in ("F", "OFX", "FCO"))
        table = shortest(bits).format(**pins)
        if mode == "LOGIC":
            if name in self.flips:
                number = self.flips[name][0]
                index = ", ".join(pins[p] for p in reversed(LUT_PINS))
                table = f"{table} ^ (flip_i[7:4] == {{3'd{number}, 1'b1}} && " \
                        f"flip_i[3:0] == {{{index}}})"
            if out:
                self.lines.append(f"assign {out} = {table};")
        elif mode == "CCU2":
            begins = self.parameter(name, "CCU2_INJECT1") == "YES"
            carry_in = "1'b0" if begins else self.pin(name, "FCI", LOW)
            two = shortest(bits[:4] * 4).format(**pins)
            if out:
                self.lines.append(f"assign {out} = {table} ^ {carry_in};")
            if carry:
                given = "1'b0" if begins else two
                self.lines.append(f"assign {carry} = {table} ? {self.pin(name, 'FCI', LOW)} : "
                                  f"{given};")
        elif mode == "DPRAM":
            self.memory(name, out, pins)
        elif mode != "RAMW_BLOCK":  # one that a memory's write port takes the place of
            raise FlowError(f"{name}: mode {mode} is not known")
        if wide:
            m = self.pin(name, "M", LOW)
            if self.cells[name]["connections"].get("FXA"):
                high, low = self.pin(name, "FXB", LOW), self.pin(name, "FXA", LOW)
            else:
                high, low = self.pin(name, "F1", LOW), out
            self.lines.append(f"assign {wide} = {m} ? {high} : {low};")

    def memory(self, name, out, pins):
        """One bit wide and 16 deep, of the lookup table's cell."""
        tag = f"m{len(self.lines)}"
        write = ", ".join(self.pin(name, f"WAD{n}", LOW) for n in (3, 2, 1, 0))
        enable = self.pin(name, "WRE", LOW)
        if self.parameter(name, "WREMUX", "WRE") == "INV":
            enable = f"~{enable}"
        self.lines += [
            f"reg [15:0] {tag} = 16'd0;",
            f"always @(posedge {self.pin(name, 'WCK', '')}) "
            f"if ({enable}) {tag}[{{{write}}}] <= {self.pin(name, 'WD', '')};",
            f"assign {out} = {tag}[{{{pins['A']}, {pins['C']}, {pins['B']}, {pins['D']}}}];"]

    def registers(self):
        groups = {}
        for name, cell in self.cells.items():
            if cell["type"] != "TRELLIS_FF":
                continue
            data = "M" if self.parameter(name, "SD", "1") == "0" else "DI"
            if self.parameter(name, "CLKMUX", "CLK") != "CLK":
                raise FlowError(f"{name}: an inverted clock")
            if self.parameter(name, "SRMODE", "LSR_OVER_CE") != "LSR_OVER_CE":
                raise FlowError(f"{name}: an asynchronous reset")
            enable, reset = self.pin(name, "CE", "1'b1"), self.pin(name, "LSR", LOW)
            mux = self.parameter(name, "CEMUX", "CE")
            enable = {"1": "1'b1", "0": "1'b0", "INV": f"~{enable}"}.get(mux, enable)
            mux = self.parameter(name, "LSRMUX", "LSR")
            reset = {"1": "1'b1", "0": "1'b0", "INV": f"~{reset}"}.get(mux, reset)
            begin = "1'b1" if self.parameter(name, "REGSET") == "SET" else "1'b0"
            q = self.out(name, "Q")
            if q is None:
                continue
            self.lines.append(f"reg {q}_q = {begin};\nassign {q} = {q}_q;")
            key = (self.pin(name, "CLK", ""), reset, enable)
            groups.setdefault(key, []).append((q, begin, self.pin(name, data, LOW)))
        for (clock, reset, enable), ones in groups.items():
            sets = " ".join(f"{q}_q <= {begin};" for q, begin, _ in ones)
            moves = " ".join(f"{q}_q <= {d};" for q, _, d in ones)
            move = f"if ({enable}) begin {moves} end" if enable != "1'b1" else f"begin {moves} end"
            whole = move if reset == "1'b0" else f"if ({reset}) begin {sets} end else {move}"
            self.lines.append(f"always @(posedge {clock}) {whole}")

    def multiplier(self, name):
        for key, value in self.cells[name]["parameters"].items():
            if key.startswith("REG_") and key.endswith("_CLK") and value.strip() != "NONE":
                raise FlowError(f"{name}: a register in a multiplier")
        a, b = (", ".join(self.wired(name, f"{side}{n}") for n in range(17, -1, -1))
                for side in "AB")
        tag = f"p{len(self.lines)}"
        signed = [self.wired(name, f"SIGNED{side}") for side in "AB"]
        self.lines += [f"wire [17:0] {tag}a = {{{a}}};", f"wire [17:0] {tag}b = {{{b}}};",
                       f"wire signed [37:0] {tag} = $signed({{{signed[0]} & {tag}a[17], {tag}a}})"
                       f" * $signed({{{signed[1]} & {tag}b[17], {tag}b}});"]
        self.lines += [f"assign {out} = {tag}[{n}];" for n in range(36)
                       if (out := self.out(name, f"P{n}"))]

    def block_ram(self, name):
        cell = self.cells[name]
        rows = [cell["parameters"].get(f"INITVAL_{n:02X}", "0" * 320)[::-1].replace("x", "0")
                for n in range(64)]
        words = tuple(int(row[20 * j + at:20 * j + at + 9][::-1], 2)
                      for row in rows for j in range(16) for at in (0, 9))
        if self.contents and any(words):
            if words not in self.contents:
                raise FlowError(f"{name}: its words are not in the configuration")
            words = self.contents[words]
        parameters = []
        for n in range(64):
            pairs = zip(words[32 * n:32 * n + 32:2], words[32 * n + 1:32 * n + 32:2])
            value = sum((low | high << 9) << 20 * j for j, (low, high) in enumerate(pairs))
            parameters.append(f".INITVAL_{n:02X}(320'h{value:x})")
        for side in "AB":
            width = int(cell["parameters"].get(f"DATA_WIDTH_{side}", f"{18:032b}"), 2)
            parameters.append(f".DATA_WIDTH_{side}({width})")
            mode = self.parameter(name, f"WRITEMODE_{side}", "NORMAL")
            parameters.append(f'.WRITEMODE_{side}("{mode}")')
            if self.parameter(name, f"REGMODE_{side}", "NOREG") != "NOREG":
                raise FlowError(f"{name}: a register behind a block RAM")
        pins = []
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] == "output":
                if bits:
                    pins.append(f".{port}(n{bits[0]})")
            else:
                pins.append(f".{port}({self.wired(name, port)})")
        self.lines.append(f"DP16KD #({', '.join(parameters)}) r{len(self.lines)} "
                          f"({', '.join(pins)});")

    def wires(self, name, kind):
        """Cells that a simulation of one clock sees as wires."""
        ways = {"DCCA": [("CLKO", "CLKI")],
                "EHXPLLL": [("CLKOP", "CLKI"), ("CLKOS", "CLKI"), ("LOCK", None)],
                "TRELLIS_RAMW": [("WADO0", "D0"), ("WADO1", "B0"), ("WADO2", "C0"),
                                 ("WADO3", "A0"), ("WDO0", "C1"), ("WDO1", "A1"), ("WDO2", "D1"),
                                 ("WDO3", "B1")]}
        for out, source in ways[kind]:
            if self.out(name, out):
                value = self.pin(name, source, LOW) if source else "1'b1"
                self.lines.append(f"assign {self.out(name, out)} = {value};")

    def ports(self):
        """The module's header, and the pads as wires."""
        header = ["input [7:0] flip_i"]
        for port, net in sorted(self.module["ports"].items()):
            width = f"[{len(net['bits']) - 1}:0] " if len(net["bits"]) > 1 else ""
            header.append(f"{net['direction']} {width}{port}")
        for (port, n), pad in self.pads().items():
            net = self.module["ports"][port]
            bit = f"{port}[{n}]" if len(net["bits"]) > 1 else port
            if pad is None:
                if net["direction"] == "output":
                    raise FlowError(f"{bit}: an output without a pad")
            elif net["direction"] == "input":
                if self.out(pad, "O"):
                    self.lines.append(f"assign {self.out(pad, 'O')} = {bit};")
            else:
                self.lines.append(f"assign {bit} = {self.pin(pad, 'I', LOW)};")
        return header

    def verilog(self):
        header = self.ports()
        self.registers()
        for name, cell in self.cells.items():
            kind = cell["type"]
            if kind == "TRELLIS_COMB":
                self.comb(name)
            elif kind == "MULT18X18D":
                self.multiplier(name)
            elif kind == "DP16KD":
                self.block_ram(name)
            elif kind not in ("TRELLIS_FF", "TRELLIS_IO"):
                if kind not in ("DCCA", "EHXPLLL", "TRELLIS_RAMW"):
                    raise FlowError(f"{name}: a {kind} is not known")
                self.wires(name, kind)
        text = "\n".join(self.lines)
        nets = sorted(set(re.findall(r"\bn\d+\b", text)), key=lambda n: int(n[1:]))
        declared = "\n".join(f"wire {n};" for n in nets)
        return f"module {self.top} (\n{', '.join(header)}\n);\n{declared}\n{text}\nendmodule\n"
