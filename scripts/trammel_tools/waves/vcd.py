# SPDX-License-Identifier: Apache-2.0
"""Writes a VCD of one value a clock and signal, and a view of some of its signals for GTKWave."""

import math
from dataclasses import dataclass

PERIOD = 20  # [ns]
LEAD = 20  # pixels beside the waves
PIXELS = 900  # that they get


@dataclass(frozen=True)
class Signal:
    path: str  # scopes and name, with dots
    width: int

    @property
    def scopes(self):
        return self.path.split(".")[:-1]

    @property
    def name(self):
        """As GTKWave calls it: scopes, name and range."""
        return self.path + (f"[{self.width - 1}:0]" if self.width > 1 else "")


def code(number):
    """The short name of the signal of this number in the file."""
    text = ""
    while True:
        number, digit = divmod(number, 94)
        text += chr(33 + digit)
        if number == 0:
            return text


def declarations(signals):
    """Lines that name the signals scope by scope; the order is that of the paths."""
    inside = []
    for path, signal, short in sorted((s.path.split("."), s, code(n))
                                      for n, s in enumerate(signals)):
        *scopes, name = path
        same = 0
        while same < min(len(inside), len(scopes)) and inside[same] == scopes[same]:
            same += 1
        yield from ["$upscope $end"] * (len(inside) - same)
        yield from [f"$scope module {scope} $end" for scope in scopes[same:]]
        inside = scopes
        bits = f" [{signal.width - 1}:0]" if signal.width > 1 else ""
        yield f"$var wire {signal.width} {short} {name}{bits} $end"
    yield from ["$upscope $end"] * len(inside)


def write(path, clock, columns):
    """columns {Signal: its value in each clock}; `clock` is the path of the clock itself, which
    rises as each of them begins."""
    signals = [Signal(clock, 1), *columns]
    lines = ["$timescale 1ns $end", *declarations(signals), "$enddefinitions $end"]
    shown = {}
    for n in range(len(next(iter(columns.values())))):
        lines += [f"#{n * PERIOD}", f"1{code(0)}"]
        for number, (signal, values) in enumerate(columns.items(), 1):
            if shown.get(number) != values[n]:
                shown[number] = values[n]
                lines.append(f"b{values[n]:b} {code(number)}" if signal.width > 1
                             else f"{values[n]}{code(number)}")
        lines += [f"#{n * PERIOD + PERIOD // 2}", f"0{code(0)}"]
    lines.append(f"#{(n + 1) * PERIOD}")
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_view(path, waves, title, groups, span, marker):
    """groups {heading: [Signal]}; the first and the last time to be seen, and the marker's [ns]."""
    zoom = -math.log2((span[1] - span[0]) / PIXELS)
    lines = [f"[*] {title}", f'[dumpfile] "{waves.resolve()}"', f'[savefile] "{path.resolve()}"',
             f"[timestart] {span[0]}", "[size] 1400 900", "[pos] -1 -1",
             f"*{zoom:.6f} {marker} -1", "[sst_width] 220", "[signals_width] 300",
             "[sst_expanded] 1"]
    for heading, signals in groups.items():
        if not signals:
            continue
        lines += ["@200", f"-{heading}"]
        for signal in signals:
            lines += ["@28" if signal.width == 1 else "@22", signal.name]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
