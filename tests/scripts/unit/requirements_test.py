# SPDX-License-Identifier: Apache-2.0
"""The pins are what the tools use and what that needs, no more and no less."""

import importlib.metadata as metadata
import re
import unittest

from trammel_tools.paths import ROOT

FILE = ROOT / "scripts" / "requirements.txt"
NEED = re.compile(r"([\w.-]+)(?:\[([\w,.-]+)\])?([^;]*)(?:;\s*(.*))?")


def plain(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def needs(name, extras):
    """(package, its extras) of what an installed package needs with these extras."""
    for line in metadata.requires(name) or []:
        found = NEED.match(line)
        extra = re.search(r"""extra\s*==\s*['"]([\w.-]+)['"]""", found[4] or "")
        if extra is None or plain(extra[1]) in extras:
            yield plain(found[1]), frozenset(map(plain, (found[2] or "").split(",")))


def closure(names):
    """What is installed of the packages and all that they need."""
    found, pending = set(), [(name, frozenset()) for name in names]
    seen = set()
    while pending:
        one = pending.pop()
        if one in seen:
            continue
        seen.add(one)
        try:
            pending += needs(*one)
        except metadata.PackageNotFoundError:
            continue  # for another system or Python
        found.add(one[0])
    return found


class RequirementsTest(unittest.TestCase):
    def setUp(self):
        lines = FILE.read_text(encoding="utf-8").splitlines()
        pins = [(plain(line.split("==")[0]), "  # " in line) for line in lines
                if not line.startswith("#")]
        self.used = {name for name, used in pins if used}
        self.pinned = {name for name, _ in pins}

    def test_every_package_has_one_version(self):
        text = FILE.read_text(encoding="utf-8")
        for line in text.splitlines():
            self.assertRegex(line, r"^#|^[\w.-]+==[\w.]+(  +# .*)?$")
        self.assertEqual(len(re.findall("==", text)), len(self.pinned))

    def test_the_pins_are_what_is_used_and_what_that_needs(self):
        missing = [name for name in self.used if not closure([name])]
        if missing:
            self.skipTest(f"not installed: {', '.join(sorted(missing))}")
        self.assertEqual(self.pinned, closure(self.used))
