# SPDX-License-Identifier: Apache-2.0
"""Drive random programs of slow and fast parts with the precision controller.

usage: scripts/tool precision-random [--count N] [--first SEED] [--jobs N] [--program FILE]

Each program is lines and arcs from a random place. Its slow parts, at 2 to 8 mm/s, are too slow for
the estimator to learn from; fast parts at 0.1 to 0.3 m/s follow. Payload, friction, cogging, noise
of the sensors and the plant's seed are random too. Every run must follow its command within 15 um.
Programs are numbered from SEED, 0 by default; one number is always the same program.

Exit codes: 0 ok, 1 a run is above the bar, 2 usage, 3 the program is not built.
"""

import math
import random
import sys
import tempfile
from pathlib import Path

import gen_precision
from trammel_tools import python_tools

LOW, HIGH = 15, 485  # [mm] of both axes, inside the hard stops


class Programs:
    """G-code of slow and fast parts, and the keys of its plant, from a seed."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.at = [round(self.random.uniform(60, 440), 3) for _ in "xy"]  # [mm]
        self.keys = {f"path.start_{axis}_m": f"{at / 1000:.6f}" for axis, at in zip("xy", self.at)}
        self.lines = [f"G21 G90 {self.random.choice(('G61', 'G64'))}"]
        for _ in range(self.random.randint(1, 3)):
            self.part(self.random.uniform(2, 8), self.random.uniform(2, 12))
            self.part(self.random.uniform(100, 300), self.random.uniform(20, 160))
        self.lines.append("M30\n")
        self.plant()

    def part(self, speed, length):
        """`length` [mm] at `speed` [mm/s]."""
        moves = self.random.randint(1, 3)
        for _ in range(moves):
            found = None
            while found is None:
                length *= 0.98  # a part that does not fit becomes shorter
                found = self.line(length / moves) if self.random.random() < 0.6 else (
                    self.arc(length / moves))
            word, end, center = found
            self.lines.append(f"{word} F{60 * speed:.1f} X{end[0]:.3f} Y{end[1]:.3f}{center}")
            self.at = [round(one, 3) for one in end]

    def heading(self):
        if self.random.random() < 0.3:  # one axis stands
            return self.random.randrange(4) * math.pi / 2
        return self.random.uniform(0, 2 * math.pi)

    def line(self, length):
        heading = self.heading()
        end = self.at[0] + length * math.cos(heading), self.at[1] + length * math.sin(heading)
        return ("G1", end, "") if all(LOW < one < HIGH for one in end) else None

    def arc(self, length):
        heading, sweep = self.heading(), self.random.uniform(0.5, 6)
        side = self.random.choice((-1, 1))
        radius = length / sweep
        offset = -side * math.sin(heading) * radius, side * math.cos(heading) * radius
        center = self.at[0] + offset[0], self.at[1] + offset[1]
        angle = math.atan2(-offset[1], -offset[0]) + side * sweep
        end = center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)
        if radius < 0.3 or not all(LOW + radius < one < HIGH - radius for one in center):
            return None
        word = "G3" if side > 0 else "G2"
        return word, end, f" I{offset[0]:.5f} J{offset[1]:.5f}"

    def plant(self):
        pick, between = self.random.choice, self.random.uniform
        payload = pick((0, 22.5, between(0, 22.5)))
        friction = pick((0.5, 1, 1.5, between(0.5, 1.5)))
        cogging = pick((0, 3, between(0, 3)))
        self.keys.update(gen_precision.keys_of(payload, friction, cogging, False,
                                               self.random.randint(1, 1000)))
        self.keys["plant.current_noise_A"] = pick((0, 0.02, between(0, 0.02)))


def main():
    parser = python_tools.Parser(prog="scripts/tool precision-random", description=__doc__)
    parser.add_argument("--count", type=int, default=20, metavar="N")
    parser.add_argument("--first", type=int, default=0, metavar="SEED")
    arguments = gen_precision.arguments_of_runs(parser)
    if arguments is None:
        return 3
    if arguments.count < 1:
        parser.error(f"--count: {arguments.count}: at least 1 program is needed")
    bench = gen_precision.Bench(arguments.program.resolve(), arguments.jobs)
    seeds = range(arguments.first, arguments.first + arguments.count)
    with tempfile.TemporaryDirectory() as folder:
        runs = []
        for seed in seeds:
            program, file = Programs(seed), Path(folder) / f"{seed}.ngc"
            file.write_text("\n".join(program.lines), encoding="utf-8")
            runs.append((file, program.keys))
        all_figures = bench.all(runs)
    worst, above = 0, []
    for seed, figures in zip(seeds, all_figures):
        most = figures.get("error_um.max", math.inf)
        worst = max(worst, most)
        if figures["end"] != 0 or most > gen_precision.MOST:
            above.append(f"program {seed}: {most:.1f} um from the command, ends with "
                         f"{figures['end']}; at most {gen_precision.MOST:g} um are allowed")
    print(f"precision-random: {arguments.count} programs, at most {worst:.1f} um from the "
          f"command, {len(above)} above {gen_precision.MOST:g} um")
    for line in above:
        print(f"precision-random: {line}", file=sys.stderr)
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())
