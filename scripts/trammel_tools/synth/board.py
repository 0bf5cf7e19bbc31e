# SPDX-License-Identifier: Apache-2.0
"""FPGA boards, as rtl/boards/<board>/board.toml describes them, and rules for their pins.

A board's folder has for each chip that it carries the top <chip>_<board>.sv with its pins in
<chip>_<board>.lpf (ECP5) or .pcf (iCE40). Every bit of every port must have a site and a pull, a
clock its frequency; what a driver sees must be pulled to its safe level; a connector's pin that
the comment behind a site names must be there. Checked before place and route.
"""

import dataclasses
import re

from trammel_tools import machines
from trammel_tools.paths import ROOT, RTL
from trammel_tools.synth import synth_flow

FOLDER = RTL / "boards"


class BoardError(Exception):
    """What the user named is not there; one line."""


@dataclasses.dataclass(frozen=True)
class Pin:
    """What a constraints file says of one bit of a port; None: nothing."""

    site: str | None = None
    io_type: str | None = None
    pull: str | None = None  # UP, DOWN, NONE
    mhz: float | None = None
    line: int = 0
    note: str | None = None  # the comment behind its site


@dataclasses.dataclass(frozen=True)
class Board:
    name: str
    chip: str
    size: int | None
    table: dict  # board.toml

    @property
    def folder(self):
        return FOLDER / self.name

    @property
    def top(self):
        return f"{self.chip}_{self.name}"

    @property
    def family(self):
        return self.table["family"]

    @property
    def device(self):
        base = synth_flow.ECP5 if self.family == "ecp5" else synth_flow.ICE40
        size = [f"--{self.size}k"] if self.size else []
        shown = self.table["device"].format(size=self.size)
        return dataclasses.replace(base, name=shown, options=(*size, *self.table["placer"]),
                                   target_mhz=self.table.get("target_mhz"))

    @property
    def constraints(self):
        return self.folder / f"{self.top}.{'lpf' if self.family == 'ecp5' else 'pcf'}"

    @property
    def memory(self):
        """Words of the memory for a firmware, or 0."""
        return self.table.get("memory", {}).get(self.chip, 0)

    @property
    def app(self):
        """The firmware, a folder of sw_nios/apps, or None."""
        return self.table.get("firmware", {}).get(self.chip)

    @property
    def load(self):
        return self.table["load"]


def names():
    return sorted(path.parent.name for path in FOLDER.glob("*/board.toml"))


def find(name, chip=None, size=None):
    """The board with a chip on it, the first of its chips when none is named."""
    if name not in names():
        raise BoardError(f"--board {name}: no such board; there are {', '.join(names())}")
    table = machines.read(FOLDER / name / "board.toml")
    chips = table["chips"]
    if chip is not None and chip not in chips:
        raise BoardError(f"{chip} --board {name}: the board carries {', '.join(chips)}")
    sizes = table.get("sizes", [])
    if size is not None and size not in sizes:
        has = f"{', '.join(map(str, sizes))}" if sizes else "one size"
        raise BoardError(f"--size {size}: the {name} has {has}")
    return Board(name, chip or chips[0], size or (sizes[0] if sizes else None), table)


def bits(ports):
    """{bit of a port: direction}; as the placers name them, a vector's by index."""
    found = {}
    for name, port in ports.items():
        if len(port["bits"]) == 1 and "offset" not in port:
            found[name] = port["direction"]
        else:
            first = port.get("offset", 0)
            found.update((f"{name}[{first + n}]", port["direction"])
                         for n in range(len(port["bits"])))
    return found


def number(text, path, line):
    try:
        return float(text)
    except ValueError as error:
        raise BoardError(f"{path.relative_to(ROOT)}:{line}: {text}: no frequency") from error


def read_lpf(path):
    """{port: Pin} of an LPF file; what else it may say is not used here and refused."""
    pins = {}
    for at, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        text, _, note = (part.strip() for part in line.partition("#"))
        if not text:
            continue
        located = re.fullmatch(r'LOCATE COMP "([^"]+)" SITE "(\w+)";', text)
        buffered = re.fullmatch(r'IOBUF PORT "([^"]+)"((?: \w+=\w+)+);', text)
        timed = re.fullmatch(r'FREQUENCY PORT "([^"]+)" (\S+) MHZ;', text)
        found = located or buffered or timed
        if not found:
            raise BoardError(f"{path.relative_to(ROOT)}:{at}: not understood: {text}")
        pin = pins.get(found[1], Pin(line=at))
        if located:
            if pin.site is not None:
                raise BoardError(f"{path.relative_to(ROOT)}:{at}: {found[1]} has a site already")
            pin = dataclasses.replace(pin, site=located[2], note=note or None)
        elif buffered:
            words = dict(word.split("=") for word in buffered[2].split())
            pin = dataclasses.replace(pin, io_type=words.get("IO_TYPE"),
                                      pull=words.get("PULLMODE"))
        else:
            pin = dataclasses.replace(pin, mhz=number(timed[2], path, at))
        pins[found[1]] = pin
    return pins


def read_pcf(path):
    """{port: Pin} of a PCF file. The iCE40 has no pull but one up, and one voltage a bank."""
    pins = {}
    for at, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        text, _, note = (part.strip() for part in line.partition("#"))
        words = text.split()
        if not words:
            continue
        if (words[0] == "set_io" and len(words) == 3) or (words[:2] == ["set_io", "-pullup"] and \
                len(words) == 5 and words[2] == "yes"):
            port, site = words[-2:]
            pin = pins.get(port, Pin(line=at))
            if pin.site is not None:
                raise BoardError(f"{path.relative_to(ROOT)}:{at}: {port} has a site already")
            pins[port] = dataclasses.replace(pin, site=site, io_type="LVCMOS", note=note or None,
                                             pull="UP" if len(words) == 5 else "NONE")
        elif words[0] == "set_frequency" and len(words) == 3:
            pins[words[1]] = dataclasses.replace(pins.get(words[1], Pin(line=at)),
                                                 mhz=number(words[2], path, at))
        else:
            raise BoardError(f"{path.relative_to(ROOT)}:{at}: not understood: {line.strip()}")
    return pins


def port_of(bit):
    return bit.partition("[")[0]


def misplaced(sites, pins):
    """Pins that are not where the connector has the one that their comment names: lines."""
    for name, pin in pins.items():
        if not sites or pin.note is None:
            continue
        if pin.note not in sites:
            yield f"{name}: no connector of board.toml has {pin.note}"
        elif pin.site != sites[pin.note]:
            yield f"{name}: {pin.note} is at site {sites[pin.note]}, not {pin.site}"


def findings(board, ports, pins):
    """What is wrong with the pins of a top with these ports: lines."""
    table, wanted = board.table, bits(ports)
    clocks = table["clocks"]  # port: MHz
    low = table.get("pulled_down", [])  # outputs that are 0 when nothing drives them
    other = table.get("pulls", {})  # inputs that are not pulled up, by their circuit on the board
    for bit, direction in wanted.items():
        port = port_of(bit)
        pin = pins.get(bit)
        if pin is None or pin.site is None:
            yield f"{bit}: no site (LOCATE, set_io)"
            continue
        if pin.io_type is None:
            yield f"{bit}: no voltage (IOBUF with IO_TYPE)"
        if pin.pull is None:
            yield f"{bit}: no pull (PULLMODE)"
        elif port in low and board.family == "ecp5" and pin.pull != "DOWN":
            yield f"{bit}: must be pulled down, is {pin.pull}: a driver would see it float"
        elif direction != "output" and port not in clocks:
            right = other.get(port, "UP")
            if pin.pull != right:
                yield f"{bit}: must have PULLMODE {right}, has {pin.pull}"
        if port in clocks and pin.mhz is None:
            yield f"{bit}: a clock without FREQUENCY"
        elif port in clocks and pin.mhz != clocks[port]:
            yield f"{bit}: {pin.mhz:g} MHz, on the board are {clocks[port]:g}"
        if port in low and pin.site in table.get("shared_sites", []):
            yield f"{bit}: {pin.site} is shared with another chip on the board"
    yield from misplaced(table.get("sites", {}), pins)
    sites = {}
    for name, pin in pins.items():
        if name not in wanted:
            yield f"{name}: the top has no such port"
        if pin.site is not None and sites.setdefault(pin.site, name) != name:
            yield f"{name}: site {pin.site} is that of {sites[pin.site]}"
    for port in [*clocks, *low, *other]:
        if not any(port_of(bit) == port for bit in wanted):
            yield f"{port}: named in board.toml, but the top has no such port"


def check(board, ports):
    """Raises FlowError with the first lines of what is wrong with the board's pins."""
    path = board.constraints
    if not path.exists():
        raise BoardError(f"{path.relative_to(ROOT)} is missing")
    read = read_lpf if board.family == "ecp5" else read_pcf
    found = list(findings(board, ports, read(path)))
    if found:
        more = f"; and {len(found) - 3} more" if len(found) > 3 else ""
        raise synth_flow.FlowError(f"{path.relative_to(ROOT)}: {'; '.join(found[:3])}{more}")
