#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check that every test is of the tier that docs/verification.md says, and of one only.

usage: tiers_test.py BUILD      asks CTest for the tests of this build folder

A test without a label is of the first tier. No test of the first tier waits for one of the full
tier, whose programs are not built for it. CTest knows a campaign as a configuration alone, so that
no other choice starts it. Each block that has mutants has a campaign of them.
"""

import json
import re
import subprocess
import sys
from fnmatch import fnmatchcase
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools.mutation import mutant_tests
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "verification.md"
TIERS = ("first", "full", "campaign")


def patterns(text):
    """{tier: patterns of its tests} of the table in the page."""
    rows = dict(re.findall(r"^\| (first|full|campaign) \| (.*) \|$", text, re.M))
    return {tier: re.findall(r"`([^`]+)`", rows[tier]) for tier in TIERS}


def label(test, name):
    return next((p["value"] for p in test.get("properties", []) if p["name"] == name), [])


def problems(tests, table):
    tier_of = {t["name"]: (label(t, "LABELS") or ["first"])[0] for t in tests}
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


def campaigns(names, plain, blocks):
    """What is wrong with the campaigns, of all tests and of those that a plain choice knows."""
    yield from (f"{name}: it is started without --campaign" for name in plain
                if name.startswith("campaign."))
    begin = "campaign.mutants."
    there = {name.removeprefix(begin) for name in names if name.startswith(begin)}
    needed = {block.replace("/", ".") for block in blocks}
    yield from (f"{begin}{name}: either the test or the block is missing"
                for name in sorted(there ^ needed))


def asked(build, *more):
    """The tests of a build folder, as CTest describes them."""
    listed = subprocess.run(["ctest", "--show-only=json-v1", *more], cwd=build, check=True,
                            capture_output=True, text=True).stdout
    return json.loads(listed)["tests"]


def made(name, *labels, waits=()):
    return {"name": name, "properties": [{"name": "LABELS", "value": list(labels)},
                                         {"name": "DEPENDS", "value": list(waits)}]}


def check_itself():
    """The check finds what it must find."""
    table = {"first": ["unit.*"], "full": ["proof.*", "slow"], "campaign": []}
    right = [made("unit.a"), made("proof.a", "full"), made("slow", "full", waits=["unit.a"])]
    assert not list(problems(right, table))
    for wrong in (right + [made("new")], right + [made("proof.b")], right[:2],
                  right + [made("unit.b", "full")], right + [made("unit.b", waits=["slow"])]):
        assert len(list(problems(wrong, table))) == 1, wrong
    whole = "campaign.mutants.drive.pwm"
    assert not list(campaigns([whole], [], ["drive/pwm"]))
    for wrong in (([whole], [whole], ["drive/pwm"]), ([whole], [], []), ([], [], ["drive/pwm"])):
        assert len(list(campaigns(*wrong))) == 1, wrong


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    check_itself()
    tests = asked(sys.argv[1], "-C", "campaign")
    wrong = list(problems(tests, patterns(PAGE.read_text(encoding="utf-8"))))
    wrong += campaigns([one["name"] for one in tests], [one["name"] for one in asked(sys.argv[1])],
                       mutant_tests.mutated())
    for line in wrong:
        print(f"tiers: {line}", file=sys.stderr)
    print(f"tiers: {len(tests)} tests")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
