# SPDX-License-Identifier: Apache-2.0
"""Draw a board's connectors from its pins, and the floor plan of a placed design.

usage: scripts/tool board-picture [BOARD] [--check]
       scripts/tool board-picture BOARD --placed FOLDER

Writes docs/pictures/board_<board>.svg, the connectors, of one board or of all; with --check they
must be as written. With --placed FOLDER, of trammel synth --board, it writes
docs/pictures/floor_<board>.svg: each tile of the FPGA in the colour of the blocks that most of its
cells belong to.

Exit codes: 0 written or as it should be, 1 the picture is stale, 2 usage.
"""

import argparse
import collections
import itertools
import json
import re
import sys
from pathlib import Path

from trammel_tools import machines
from trammel_tools.paths import ROOT
from trammel_tools.synth import board, synth_flow, synth_report
from trammel_tools.synth.synth_netlist import Netlist

PICTURES = ROOT / "docs" / "pictures"
TILE, HIGH = 9, 9  # [px]
COLOURS = {"gate": "#f4a7a3", "driver_en": "#f9d48b", "driver_fault": "#f9e9a9", "adc": "#a9cdee",
           "enc": "#bfe3b4", "pwm": "#f4a7a3", "d_io": "#a9cdee"}
STYLE = ("<style>text{font:11px sans-serif;fill:#222}.h{font-weight:bold}"
         ".s{font-size:9px;fill:#555}</style>")


def notes(path):
    """{port: what the constraints file says of its place}."""
    found = {}
    for line in path.read_text(encoding="utf-8").split("\n"):
        placed = re.match(r'(?:LOCATE COMP "([^"]+)"|set_io (?:-pullup yes )?(\S+) \S+).*#\s*(.*)',
                          line)
        if placed:
            found[placed[1] or placed[2]] = placed[3]
    return found


def places(path):
    """{connector: {(row, column): (port, mark)}}; rows of a header, or of a Pmod's pins."""
    found = collections.defaultdict(dict)
    for port, note in notes(path).items():
        header = re.fullmatch(r"(J\d+)_(\d+)([+-]) (\w+)", note)
        pmod = re.fullmatch(r"(?:Pmod )?(\w+) pin (\d+)", note)
        if header:
            found[header[1]][int(header[2]), header[3] == "-"] = (port, f"{header[4]}")
        elif pmod:
            pin = int(pmod[2])
            found[f"Pmod {pmod[1]}"][(pin - 1) % 6 + 1, pin > 6] = (port, str(pin))
    return found


def colour(port):
    return next((value for start, value in COLOURS.items() if port.startswith(start)), "#eee")


def text(x, y, words, kind="", anchor="start"):
    shown = f' class="{kind}"' if kind else ""
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}"{shown}>{words}</text>'


def connectors(on):
    """The picture: a box for each pin, in two columns a connector, a pin a line."""
    lines, x, height = [], 10, 0
    for name, pins in sorted(places(on.constraints).items()):
        lines.append(text(x + 150, 22, name, "h", "middle"))
        for at, row in enumerate(sorted({row for row, _ in pins})):
            y = 32 + 24 * at
            for column in (False, True):
                if (row, column) not in pins:
                    continue
                port, mark = pins[row, column]
                left = x + (152 if column else 0)
                lines.append(f'<rect x="{left}" y="{y}" width="146" height="20" rx="3" '
                             f'fill="{colour(port)}" stroke="#666"/>'
                             + text(left + 6, y + 14, port)
                             + text(left + 140, y + 14, mark, "s", "end"))
            height = max(height, y + 30)
        x += 320
    head = f"{on.chip} on {on.name}: " + ("the mark + of a row at the left, - at the right"
                                          if "J1" in places(on.constraints) else
                                          "pins 1 to 4 at the left, 7 to 10 at the right")
    return svg(x, height + 20, [*lines, text(10, height + 12, head, "s")])


def svg(width, height, lines):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}"><rect width="100%" height="100%" fill="white"/>{STYLE}'
            "\n" + "\n".join(lines) + "\n</svg>\n")


def changed(was, now):
    """The first words that differ between two pictures."""
    words = (re.findall(r">([^<>\n]+)</text>", picture) for picture in (was, now))
    for old, new in itertools.zip_longest(*words, fillvalue="nothing"):
        if old != new:
            return f"{old} became {new}"
    return "a shape or colour changed"


def group_of(owner, groups):
    """The number of the first group that an instance path belongs to."""
    return next(n for n, group in enumerate(groups) if re.search(group["path"], owner))


def tiles(folder, top, groups):
    """{(x, y): Counter of groups}, and the blocks of memory and multipliers by place."""
    netlist = Netlist(*synth_flow.read_netlist(top, folder), top)
    placed = json.loads((folder / f"{top}.placed.json").read_text(encoding="utf-8"))
    cells, blocks = collections.defaultdict(collections.Counter), {}
    for name, cell in next(iter(placed["modules"].values()))["cells"].items():
        spot = re.match(r"X(\d+)/Y(\d+)/", cell["attributes"].get("NEXTPNR_BEL", ""))
        base = synth_report.of_netlist(netlist, name)
        if not spot or base not in netlist.cells:
            continue
        owner = netlist.owner(base)
        group = group_of(owner, groups)
        place = int(spot[1]), int(spot[2])
        cells[place][group] += 1
        if cell["type"] in ("DP16KD", "MULT18X18D"):
            blocks[place] = cell["type"]
    return cells, blocks


def groups_of_plans():
    return [group for path in sorted(board.FOLDER.glob("*/floor_plan.toml"))
            for group in machines.read(path)["group"]]


def floor_plan(on, folder):
    groups = groups_of_plans()
    cells, blocks = tiles(folder, on.top, groups)
    wide, high = max(x for x, _ in cells) + 1, max(y for _, y in cells) + 1
    lines, shares = [], collections.Counter()
    for number, group in enumerate(groups):
        mine = [(x, y) for (x, y), count in cells.items() if count.most_common(1)[0][0] == number]
        shares[number] = sum(count[number] for count in cells.values())
        path = "".join(f"M{10 + TILE * x} {10 + HIGH * y}h{TILE - 1}v{HIGH - 1}h-{TILE - 1}z"
                       for x, y in sorted(mine))
        lines.append(f'<path fill="{group["colour"]}" d="{path}"/>')
    for kind, frame in ("DP16KD", "#000"), ("MULT18X18D", "#c00"):
        path = "".join(f"M{9 + TILE * x} {9 + HIGH * y}h{TILE}v{HIGH}h-{TILE}z"
                       for (x, y), what in sorted(blocks.items()) if what == kind)
        lines.append(f'<path fill="none" stroke="{frame}" d="{path}"/>')
    below = 10 + HIGH * high + 8
    whole = sum(shares.values())
    for number, group in enumerate(groups):
        x, y = 10 + 230 * (number % 3), below + 18 * (number // 3)
        lines.append(f'<rect x="{x}" y="{y}" width="12" height="12" fill="{group["colour"]}"/>')
        lines.append(text(x + 17, y + 10, f"{group['name']} {100 * shares[number] / whole:.0f} %"))
    foot = below + 18 * ((len(groups) + 2) // 3)
    lines.append(text(10, foot + 10, f"{on.chip} on {on.device.name}, as placed: a tile has the "
                      "colour of most of its cells; framed black block RAM, red multiplier", "s"))
    return svg(max(20 + TILE * wide, 700), foot + 20, lines)


def main():
    parser = argparse.ArgumentParser(prog="scripts/tool board-picture", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("board", nargs="?")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--placed", type=Path, metavar="FOLDER")
    wanted = parser.parse_args()
    if wanted.placed and not wanted.board:
        parser.error("--placed: of which board?")
    try:
        boards = [board.find(name) for name in ([wanted.board] if wanted.board else
                                                board.names())]
        pictures = {PICTURES / f"floor_{wanted.board}.svg": floor_plan(boards[0], wanted.placed)
                    } if wanted.placed else {PICTURES / f"board_{on.name}.svg": connectors(on)
                                             for on in boards}
    except board.BoardError as error:
        parser.error(str(error))
    except (OSError, synth_flow.FlowError) as error:
        parser.error(f"--placed {wanted.placed}: {error}")
    stale = 0
    for target, picture in pictures.items():
        if not wanted.check:
            target.write_text(picture, encoding="utf-8")
            print(f"wrote {target.relative_to(ROOT)}")
        elif not target.exists() or target.read_text(encoding="utf-8") != picture:
            was = target.read_text(encoding="utf-8") if target.exists() else ""
            print(f"board-picture: {target.relative_to(ROOT)} is stale, {changed(was, picture)}: "
                  "if that is meant, scripts/tool board-picture", file=sys.stderr)
            stale = 1
    return stale
