# SPDX-License-Identifier: Apache-2.0
"""A test case that runs the program for its wave files, and what holds for each of them."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import python_tools  # noqa: E402  pylint: disable=wrong-import-position

python_tools.need("pywellen", Path(sys.argv[0]).name)
from wave_file import WaveFile  # noqa: E402  pylint: disable=wrong-import-position

PROGRAM = Path(sys.argv[1] if len(sys.argv) > 1 else "trammel").resolve()


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

    def wave(self, *words, code=0):
        done = subprocess.run([sys.executable, ROOT / "scripts" / "wave.py", *map(str, words)],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def check_view(self, fst, tracked, groups):
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
        for group in groups:
            self.assertEqual(view.count(f"\n-{group}\n"), 2, group)  # its begin and its end
        text = (ROOT / "waves" / tracked).read_text(encoding="ascii")
        self.assertEqual(view.split("[*]")[1], text.split("[*]")[1])
        self.assertGreater(len(shown), 50)
        return view
