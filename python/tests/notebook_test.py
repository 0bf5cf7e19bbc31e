# SPDX-License-Identifier: Apache-2.0
"""The cells of examples/*.ipynb run from top to bottom, as in a notebook, and the Python blocks of
docs/one-to-a-million.md in their order: notebook_test.py PROGRAM (which is not used)."""

import importlib.util
import json
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "one-to-a-million.md"


def execute(name, cells):
    """Cells, each (place, text), in one name space and a folder of their own."""
    space, before = {"__name__": "__main__"}, os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for place, text in cells:
                exec(compile(text, f"{name}: {place}", "exec"), space)
        finally:
            os.chdir(before)
    return space


class Notebooks(unittest.TestCase):
    def test_every_cell_of_a_notebook(self):
        books = sorted((ROOT / "examples").glob("*.ipynb"))
        self.assertTrue(books)
        for book in books:
            cells = [(cell["id"], "".join(cell["source"]))
                     for cell in json.loads(book.read_text())["cells"]
                     if cell["cell_type"] == "code"]
            space = execute(book.name, cells)
            self.assertIn("result", space)

    def test_blocks_of_the_page(self):
        text = PAGE.read_text(encoding="utf-8")
        blocks = [(f"line {text.count(chr(10), 0, found.start()) + 1}", found[1])
                  for found in re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S)]
        # One needs a sweep before; one draws, with a package that need not be here.
        other = ["sweep.read"]
        if not importlib.util.find_spec("matplotlib"):
            other.append("matplotlib")
        ours = [b for b in blocks if not any(word in b[1] for word in other)]
        self.assertGreaterEqual(len(ours), 2)
        execute(PAGE.name, ours)


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
