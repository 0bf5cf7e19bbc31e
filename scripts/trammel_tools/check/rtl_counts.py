# SPDX-License-Identifier: Apache-2.0
"""What a unit test covers of the RTL: counts that Verilator wrote, and their short form."""

import re
from collections import Counter, defaultdict
from dataclasses import dataclass, field
from pathlib import Path

KINDS = ("lines", "toggles", "covers")


@dataclass
class Block:
    """Counts of one RTL file and its properties, whatever instances it has in whatever model."""
    lines: Counter = field(default_factory=Counter)  # (line, column, kind) -> executions
    toggles: Counter = field(default_factory=Counter)  # (line, signal) -> changes
    covers: Counter = field(default_factory=Counter)  # label -> times reached

    @staticmethod
    def share(points):
        return 100 * sum(n > 0 for n in points.values()) / len(points) if points else 100.0


def read_points(path):
    """Fields and count of every point of a file that Verilator wrote: f file, l line, n column,
    page kind and module, o comment."""
    for line in path.read_text(encoding="utf-8", errors="replace").split("\n"):
        if line.startswith("C '"):
            text, count = line[3:].rsplit("' ", 1)
            yield dict(f.split("\2", 1) for f in text.split("\1")[1:]), int(count)


def whole(path):
    """Whether a file holds points, the last of them to its end."""
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return False
    return re.search(r"\nC '[^\n]+' \d+\n\Z", text) is not None


def read_blocks(*paths):
    """{block: counts} of all files together."""
    blocks = defaultdict(Block)
    for point, count in (one for path in paths for one in read_points(path)):
        source = Path(point["f"])
        kind = point["page"].split("/")[0]
        if source.suffix != ".sv" or "generated" in source.parts:
            continue
        block = blocks[f"{source.parent.name}/{source.stem.removesuffix('_props')}"]
        place = int(point["l"]), int(point["n"])
        if kind == "v_user":
            block.covers[point["o"]] += count
        elif source.stem.endswith("_props"):
            continue
        elif kind == "v_toggle":
            block.toggles[place[0], point["o"]] += count
        else:
            block.lines[*place, point["o"]] += count
    return dict(sorted(blocks.items()))


def point_text(point):
    return point if isinstance(point, str) else ":".join(map(str, point))


def short(blocks):
    """Lines of text: of each block the points that were reached and those that never were; of
    toggles, which are many, the number of the first."""
    for name, block in blocks.items():
        yield name
        for kind in KINDS:
            points = getattr(block, kind)
            reached = [point_text(one) for one in sorted(points) if points[one] > 0]
            never = [point_text(one) for one in sorted(points) if points[one] == 0]
            counted = [f"{len(reached)}"] if kind == "toggles" else reached
            yield " ".join([f"  {kind}:", *counted])
            yield " ".join([f"  {kind} never:", *never])


def point_of(kind, text):
    if kind == "covers":
        return text
    parts = text.split(":", 2 if kind == "lines" else 1)
    return *map(int, parts[:-1]), parts[-1]


def read_short(*texts):
    """{block: counts} of the lines that `short` makes; a point counts once for each text."""
    blocks = defaultdict(Block)
    for text in texts:
        block = None
        for line in text.split("\n"):
            found = re.fullmatch(r"  (\w+)( never)?:(.*)", line)
            if re.fullmatch(r"\w+/\w+", line):
                block = blocks[line]
            elif found and block is not None:
                kind, never, points = found.groups()
                counts = getattr(block, kind)
                if kind == "toggles" and not never:
                    counts.update({(0, f"{n}"): 1 for n in range(int(points))})
                    continue
                for one in points.split():
                    counts[point_of(kind, one)] += 0 if never else 1
    return dict(sorted(blocks.items()))
