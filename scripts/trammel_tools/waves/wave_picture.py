# SPDX-License-Identifier: Apache-2.0
"""A clock range of a wave file as a WaveDrom picture."""

import json
import re

from trammel_tools import picture as pictures
from trammel_tools.output_file import Refused
from trammel_tools.text import one_line
from trammel_tools.waves.wave_file import time_text, within

MOST_CELLS = 120  # clocks and gaps; a wider picture is none
LONGEST = 200000  # clocks
MOST_BYTES = 16 << 20  # of WaveJSON
FORMATS = {"d", "u", "x", "b"}


def split_name(text):
    """[LABEL=]NAME[:FORMAT]"""
    label, _, rest = text.rpartition("=")
    name, _, kind = rest.rpartition(":")
    if not name:
        name, kind = rest, ""
    elif kind not in FORMATS:
        raise Refused(f"--signals {text}: format {kind} is none of d, u, x, b")
    return label or name.rpartition(".")[2], name, kind


def value_text(value, bits, kind):
    if not isinstance(value, int):
        return "?" if value is None else str(value)
    if kind == "d":
        return str(value - (1 << bits) if value >> (bits - 1) else value)
    if kind == "b":
        return f"{value:0{bits}b}"
    return f"{value:x}" if kind in ("x", "") else str(value)


def at_clocks(changes, window, clocks):
    """The value that stands after each of the clock edges."""
    value, inside = within(changes, window)
    values = []
    for time in clocks:
        while inside and inside[0][0] <= time:
            value = inside.pop(0)[1]
        values.append(value)
    return values


def drawn_cells(rows, around):
    """The clocks that are drawn, those near a change, with None where clocks are left out."""
    count = len(rows[0])
    keep = [False] * count
    for i in range(count):
        if i == 0 or any(row[i] != row[i - 1] for row in rows):
            for j in range(max(0, i - around), min(count, i + around + 1)):
                keep[j] = True
    cells = []
    i = 0
    while i < count:
        run = i
        while run < count and not keep[run]:
            run += 1
        if run - i > around + 1:
            cells.append(None)
            i = run
        elif run > i:  # a gap costs a cell and says less
            keep[i:run] = [True] * (run - i)
        else:
            cells.append(i)
            i += 1
    return cells


def lane(label, values, cells, letter, text=None):
    """One row; `letter` gives the wave's letter of a value and `text` what stands in it."""
    wave, data = "", []
    before = None
    for i in cells:
        if i is None:
            wave += "|"
            continue
        same = wave and values[i] == before
        wave += "." if same else letter(values[i])
        if not same and text:
            data.append(text(values[i]))
        before = values[i]
    return {"name": label, "wave": wave, **({"data": data} if text else {})}


def signal_lane(wave_file, label, name, kind, values, cells):
    bits = wave_file.bits(name)
    if bits == 1:
        return lane(label, values, cells, lambda value: str(value) if value in (0, 1) else "x")
    return lane(label, values, cells, lambda value: "=",
                lambda value: value_text(value, bits, kind))


def clock_lanes(name, cells, first_clock):
    """The clock itself, and at the begin and behind each gap the number of the clock."""
    starts = [i for place, i in enumerate(cells)
              if i is not None and (place == 0 or cells[place - 1] is None)]
    newest = {i: max(s for s in starts if s <= i) for i in cells if i is not None}
    numbers = lane("clock", newest, cells, lambda start: "3",
                   lambda start: f"+{start}" if start else str(first_clock))
    return [numbers, lane(name, dict.fromkeys(newest, 0), cells, lambda value: "p")]


def changes_after(values, begin):
    return next((i for i in range(begin, len(values)) if values[i] != values[i - 1]), None)


def measure(lanes, picked, cells, pairs):
    """Arrows from the first change of one signal to the next one of another, in clocks."""
    rows = {label: values for label, _, _, values in picked}
    nodes = {label: ["."] * len(cells) for label in rows}
    edges = []
    for one, two in pairs:
        for label in (one, two):
            if label not in rows:
                raise Refused(f"--measure: {label} is none of the drawn: {', '.join(rows)}")
        begin = changes_after(rows[one], 1)
        end = changes_after(rows[two], begin + 1) if begin is not None else None
        if end is None:
            raise Refused(f"--measure {one} {two}: they do not change after each other in --window")
        ends = []
        for label, clock in ((one, begin), (two, end)):
            place = cells.index(clock)
            if nodes[label][place] == ".":
                nodes[label][place] = chr(ord("A") + sum(
                    c != "." for row in nodes.values() for c in row))
            ends.append(nodes[label][place])
        edges.append(f"{ends[0]}<~>{ends[1]} {end - begin} clk")
    for one in lanes:
        if "".join(nodes.get(one["name"], "")).strip("."):
            one["node"] = "".join(nodes[one["name"]])
    return edges


def printable(part):
    """Names, values and titles as they can stand in XML."""
    if isinstance(part, dict):
        return {key: printable(value) for key, value in part.items()}
    if isinstance(part, list):
        return [printable(value) for value in part]
    return one_line(part) if isinstance(part, str) else part


def wave_json(wave_file, args):
    clock_name, rising = wave_file.clock(args.clock)
    period = rising[1] - rising[0]
    begin, end = wave_file.window(args.window, args.clock)
    clocks = [time for time in rising if begin <= time < end]
    if not clocks:
        raise Refused(f"--window: {args.window} lies outside the waves of {wave_file.path}, which "
                      f"hold {time_text(rising[0] * wave_file.step)} to "
                      f"{time_text(rising[-1] * wave_file.step)}, perhaps with gaps")
    if clocks[-1] - clocks[0] != (len(clocks) - 1) * period:
        raise Refused(f"--window: {args.window}: in between the waves of {wave_file.path} have a "
                      "gap")
    if not 2 <= len(clocks) <= LONGEST:
        raise Refused(f"--window: {args.window} is {len(clocks)} clocks; 2..{LONGEST} can be drawn")
    picked = []
    for text in args.signals:
        label, name, kind = split_name(text)
        full = wave_file.one(name)
        picked.append((label, full, kind,
                       at_clocks(wave_file.changes(full), (clocks[0], clocks[-1] + 1), clocks)))
    labels = [label for label, *_ in picked]
    if len(set(labels)) < len(labels):
        raise Refused(f"--signals: two are called {max(labels, key=labels.count)}: give LABEL=NAME")
    cells = drawn_cells([values for *_, values in picked], max(1, args.around))
    if len(cells) > MOST_CELLS:
        raise Refused(f"--window: {args.window}: {len(cells)} clocks with changes are more than "
                      f"{MOST_CELLS}: fewer signals, or a shorter window")
    lanes = clock_lanes(clock_name.rpartition(".")[2], cells, round(clocks[0] / period))
    rows = [signal_lane(wave_file, label, name, kind, values, cells)
            for label, name, kind, values in picked]
    picture = {"signal": lanes + rows, "config": {"hscale": 1}}
    edges = measure(rows, picked, cells, args.measure)
    if edges:
        picture["edge"] = edges
    if args.title:
        picture["head"] = {"text": args.title}
    return printable(picture)


def json_text(picture):
    """One lane a line."""
    lanes = ",\n  ".join(json.dumps(one) for one in picture["signal"])
    rest = {key: value for key, value in picture.items() if key != "signal"}
    return f'{{"signal": [\n  {lanes}],\n {json.dumps(rest)[1:]}\n'


def is_own(path):
    """Whether a file is a picture's WaveJSON as `json_text` writes it."""
    if path.stat().st_size > MOST_BYTES:
        return False
    try:
        text = path.read_text(encoding="utf-8")
        return json_text(json.loads(text)) == text
    except (ValueError, TypeError, KeyError, RecursionError):
        return False


def svg(picture):
    import wavedrom
    text = wavedrom.render(json.dumps(picture)).tostring()
    # The words on arrows are drawn too small to read.
    text = re.sub(r'(translate\([^)]*\))("><rect height="10")', r"\1 scale(1.4)\2", text)
    # A ground of its own: black lines on a dark page are not seen.
    return pictures.slim(re.sub(
        r"(<svg[^>]*>)", r'\1<rect width="100%" height="100%" fill="white"/>', text, count=1))
