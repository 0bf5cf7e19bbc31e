# SPDX-License-Identifier: Apache-2.0
"""Test RTL blocks alone: lint and unit test side by side, then the proof.

usage: trammel test layer/block ...

Nothing but the unit tests of these blocks is built. Each result is printed as it comes; what a
failed check said stands before it. A chip that leaps is also asked the lemmas of its leap.

Exit codes: 0 all passed, 1 a check failed, 2 no such block, 3 a tool is missing.
"""

import difflib
import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

from trammel_tools import python_tools
from trammel_tools.paths import ROOT, RTL, block_file
from trammel_tools.rtl import lint

BUILD = ROOT / "build"
MISSING = 3
# Lines of ninja that say what it does, not what went wrong; the line after FAILED is the command.
PROGRESS = re.compile(r"\[\d+/\d+\] |ninja: |FAILED: ")


def blocks():
    """{layer/block: its unit test or None}; boards are a layer too."""
    names = [*lint.blocks(), *(f"boards/{path.stem}" for path in RTL.glob("boards/*/*.sv"))]
    tests = {name: ROOT / "tests" / f"{name}_test.cpp" for name in names}
    return {name: test if test.exists() else None for name, test in sorted(tests.items())
            if test.exists() or not name.startswith("boards/")}


def suggestion(name, every):
    """The block somebody may have meant: its stem alone, or one of nearly that name."""
    stem = name.rpartition("/")[2].removesuffix(".sv")
    near = [b for b in every if b.endswith(f"/{stem}")] or difflib.get_close_matches(name, every, 1)
    if not near:
        stems = {b.partition("/")[2]: b for b in every}
        near = [stems[s] for s in difflib.get_close_matches(stem, stems, 1)]
    return f"did you mean {near[0]}?" if near else "see docs/README.md"


def call(command):
    """(exit code, what it said)"""
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace", check=False)
    return done.returncode, done.stdout


def report(kind, block, code, begin, said=""):
    """Prints a result; returns the exit code that it stands for."""
    if code == python_tools.SKIPPED:
        code = MISSING
    verdict = {0: "passed", MISSING: "skipped"}.get(code, "failed")
    if code:
        print(said.strip("\n") or f"exit code {code}")
    print(f"{kind:<7}{block:<26}{verdict:<9}{time.monotonic() - begin:6.1f} s", flush=True)
    return code if code in (0, MISSING) else 1


def check_lint(block):
    begin = time.monotonic()
    code, said = call([sys.executable, ROOT / "scripts" / "tool", "lint", block])
    return "lint", block, code, begin, said


def build(tested):
    """(exit code, what went wrong) of the unit tests' build."""
    targets = [test.stem for test in tested.values()]
    if not targets:
        return 0, ""
    code, said = call(["flock", BUILD / ".lock", "ninja", "-C", BUILD, *targets])
    lines = said.split("\n")
    return code, "\n".join(line for before, line in zip(["", *lines], lines)
                           if not PROGRESS.match(line) and not before.startswith("FAILED: "))


def check_unit(block, test, built, begin):
    code, said = built.result()
    if code == 0:
        code, said = call([BUILD / "tests" / test.stem])
    return "unit", block, code, begin, said


def check_proof(block):
    """Exit code of all that is proven of a block; the prover prints what it finds as it goes."""
    source = block_file(block, ".sv")
    questions = []
    if source.with_name(f"{source.stem}_props.sv").exists():
        questions.append(("proof", []))
    if source.with_name(f"{source.stem}_leap.toml").exists():
        questions += [("leap", ["--leap"]), ("leap", ["--leap", "--broken"])]
    worst = 0
    for kind, options in questions:
        begin = time.monotonic()
        done = subprocess.run([sys.executable, ROOT / "scripts" / "tool", "prove", *options, block],
                              cwd=ROOT, env=os.environ | {"PYTHONUNBUFFERED": "1"}, check=False)
        worst = max(worst, report(kind, block, done.returncode, begin, "see above"),
                    key=[0, MISSING, 1].index)
    return worst


def check(wanted):
    """The exit code of all checks of {block: unit test or None}."""
    codes = []
    begin = time.monotonic()  # a unit test's time is that of its build too
    tested = {block: test for block, test in wanted.items() if test}
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        built = pool.submit(build, tested)
        running = [pool.submit(check_lint, b) for b in wanted if not b.startswith("boards/")]
        running += [pool.submit(check_unit, b, test, built, begin) for b, test in tested.items()]
        codes += [report(*done.result()) for done in as_completed(running)]
    codes += [check_proof(block) for block in wanted]
    return 1 if 1 in codes else max(codes, default=0)


def main():
    parser = python_tools.Parser(prog="trammel test", description=__doc__)
    parser.add_argument("--names", action="store_true", help="only check the names")
    parser.add_argument("blocks", nargs="+", metavar="layer/block")
    options = parser.parse_args()
    every = blocks()
    for block in options.blocks:
        if block not in every:
            return python_tools.refuse("trammel: test", f"{block}: no such block; "
                                                        f"{suggestion(block, every)}")
    return 0 if options.names else check({block: every[block] for block in options.blocks})
