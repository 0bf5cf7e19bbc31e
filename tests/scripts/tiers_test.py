#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that every test is of the tier that docs/verification.md says, and of one only.

usage: tiers_test.py BUILD      asks CTest for the tests of this build folder

A test without the label `full` is of the first tier. No test of the first tier waits for one of the
full tier, whose programs are not built for it.
"""

import json
import re
import subprocess
import sys
from fnmatch import fnmatchcase
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "verification.md"
TIERS = ("first", "full")


def patterns(text):
    """{tier: patterns of its tests} of the table in the page."""
    rows = dict(re.findall(r"^\| (first|full) \| (.*) \|$", text, re.M))
    return {tier: re.findall(r"`([^`]+)`", rows[tier]) for tier in TIERS}


def label(test, name):
    return next((p["value"] for p in test.get("properties", []) if p["name"] == name), [])


def problems(tests, table):
    tier_of = {t["name"]: TIERS["full" in label(t, "LABELS")] for t in tests}
    for test in tests:
        name, tier = test["name"], tier_of[test["name"]]
        named = [t for t in TIERS if any(fnmatchcase(name, p) for p in table[t])]
        if named != [tier]:
            yield f"{name}: of tier {tier}, the page says {' and '.join(named) or 'none'}"
        if tier == "first":
            yield from (f"{name}: of tier first, but waits for {other}"
                        for other in label(test, "DEPENDS") if tier_of[other] == "full")
    for tier in TIERS:
        for pattern in table[tier]:
            if not any(fnmatchcase(name, pattern) for name in tier_of):
                yield f"{pattern}: no test has such a name"


def made(name, *labels, waits=()):
    return {"name": name, "properties": [{"name": "LABELS", "value": list(labels)},
                                         {"name": "DEPENDS", "value": list(waits)}]}


def check_itself():
    """The check finds what it must find."""
    table = {"first": ["unit.*"], "full": ["proof.*", "slow"]}
    right = [made("unit.a"), made("proof.a", "full"), made("slow", "full", waits=["unit.a"])]
    assert not list(problems(right, table))
    for wrong in (right + [made("new")], right + [made("proof.b")], right[:2],
                  right + [made("unit.b", "full")], right + [made("unit.b", waits=["slow"])]):
        assert len(list(problems(wrong, table))) == 1, wrong


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    check_itself()
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=sys.argv[1], check=True,
                            capture_output=True, text=True).stdout
    tests = json.loads(listed)["tests"]
    wrong = list(problems(tests, patterns(PAGE.read_text(encoding="utf-8"))))
    for line in wrong:
        print(f"tiers: {line}", file=sys.stderr)
    print(f"tiers: {len(tests)} tests")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
