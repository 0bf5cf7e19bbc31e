# SPDX-License-Identifier: Apache-2.0
"""Cases that start the trammel program in a folder of their own.

Each machine names runs of less than a second in its tests/runs.toml.
"""

import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import machines

RUNS = [["run", case["scenario"], *case["arguments"]]
        for name in machines.folders() for case in machines.runs(name).get("files", [])]
WITH_WAVES = next(run for run in RUNS if "--wave" in run)


def limited(size):
    """No file may grow beyond size, as on a disk that is full."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


def lines(text):
    return [line for line in text.split("\n") if line]


class Case(unittest.TestCase):
    program = None  # of main()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def trammel(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.run([self.program, *arguments], cwd=self.folder, text=True, check=False,
                              timeout=60, **options)

    def run_to(self, out, *more, run=0, **options):
        return self.trammel(*RUNS[run], "-o", str(out), *more, **options)

    def good(self, done):
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(lines(done.stderr)), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def nothing_else(self, *names):
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), sorted(names))


def main():
    """Runs the cases of the script with the program that its first argument names."""
    Case.program = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
