# SPDX-License-Identifier: Apache-2.0
"""A test case with a folder that goes away, which may be a repository."""

import contextlib
import io
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock


class Scratch(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(dir=Path.cwd()))
        self.addCleanup(shutil.rmtree, self.folder)

    def init(self):
        """Makes the folder a repository, so that git looks no further up."""
        subprocess.run(["git", "init", "-q", "--template=", self.folder], check=True)

    def write(self, path, text):
        target = self.folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
        return target

    def patch(self, module, **values):
        """Other values for names of a module, until the test ends."""
        for name, value in values.items():
            patch = mock.patch.object(module, name, value)
            patch.start()
            self.addCleanup(patch.stop)


def call(main, *words):
    """Exit code, standard output and standard error of a main with these arguments."""
    out, err = io.StringIO(), io.StringIO()
    with mock.patch.object(sys, "argv", ["tool name", *map(str, words)]), \
            contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code = main()
        except SystemExit as end:
            code = end.code
    return code, out.getvalue(), err.getvalue()
