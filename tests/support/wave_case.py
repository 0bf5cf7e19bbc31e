# SPDX-License-Identifier: Apache-2.0
"""A test case that runs the program for its wave files, and what holds for each of them."""

import itertools
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools
from trammel_tools.paths import TOOL
from trammel_tools.waves.wave_file import WaveFile

PROGRAM = Path(sys.argv[1] if len(sys.argv) > 1 else "trammel").resolve()


def level(changes, time):
    return [value for at, value in changes if at <= time][-1]


def pulses(changes, active=0):
    """Begin and end of each time at which the line is active."""
    edges = [(time, value) for n, (time, value) in enumerate(changes)
             if n == 0 or changes[n - 1][1] != value]
    return [(a[0], b[0]) for a, b in itertools.pairwise(edges) if a[1] == active]


class WaveCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(dir=Path.cwd()))
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    @classmethod
    def trammel(cls, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True,
                              check=False)
        if done.returncode != code:
            raise AssertionError(f"{words}: exit {done.returncode}\n{done.stdout}{done.stderr}")
        return done

    @classmethod
    def run_to(cls, name, words, *more, code=0):
        out = cls.folder / name
        cls.trammel(*words, "--no-report", "-o", out, *more, code=code)
        return out

    def check_refused(self, cases):
        """Exit code and words of the one line that each command ends with."""
        for code, says, words in cases:
            done = self.trammel(*words, "--json", code=code)
            self.assertIn(says, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def wave(self, *words, code=0):
        done = subprocess.run([sys.executable, TOOL, "wave", *map(str, words)],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def check_view(self, fst):
        """The view beside a file names signals of it, as wide as they are; its text."""
        view = (fst.parent / "waves.gtkw").read_text(encoding="ascii")
        file = WaveFile(fst)
        # An element of a memory is m[3] to GTKWave and a scope of its own, m.[3], to the reader.
        bits = {re.sub(r"\.(?=\[\d+\]$)", "", name): file.bits(name) for name in file.names}
        top = file.names[0].split(".")[0]
        shown = re.findall(rf"^(?:\+\{{[^}}]*\}} )?({top}\.\S+)$", view, re.M)
        for signal in shown:
            name, high, low = re.fullmatch(r"(.*?)(?:\[(\d+):(\d+)\])?", signal).groups()
            self.assertEqual(bits.get(name), int(high or 0) - int(low or 0) + 1, signal)
        commands = (fst.parent / "waves.sucl").read_text(encoding="ascii")
        self.assertLessEqual(set(re.findall(r"variable_add (.*)", commands)), set(file.names))
        groups = re.findall(r'divider_add "(.+)"', commands)
        self.assertGreater(len(groups), 3)
        for group in groups:
            self.assertEqual(view.count(f"\n-{group}\n"), 2, group)  # its begin and its end
        self.assertGreater(len(shown), 50)
        self.assertEqual(sorted(set(shown)), sorted(shown))  # each signal stands once
        return view


def main():
    python_tools.need("pywellen", Path(sys.argv[0]).name)
    unittest.main(argv=sys.argv[:1])
