# SPDX-License-Identifier: Apache-2.0
"""What tests of sweeps and studies share: a folder, and of long ones a plan, and a start whose rows
are written as they come."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EAGER = ("import sys; from trammel.sweep import main as m; m.FLUSH_S = 0; "
         "from trammel.{0} import main; sys.exit(main.main())")


class Case(unittest.TestCase):
    """In a folder of its own, with a name for an output folder in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"

    def written(self, name, text):
        """A file in the folder."""
        file = self.folder / name
        file.write_text(text)
        return file


def plan(runs, seconds):
    """Circles with random payloads, each simulated for so long."""
    return f"""scenario = "circle"
[keys]
"run.max_s" = {seconds}
[random]
count = {runs}
"plant.payload_kg" = [0.0, 20.0]
"""


def begin(verb, *words, **options):
    """`trammel sweep` or `trammel tune`, started."""
    return subprocess.Popen([sys.executable, "-c", EAGER.format(verb), *map(str, words)],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
