# SPDX-License-Identifier: Apache-2.0
"""Coverage of the RTL and of the C++ code by the tests, against floors.

usage: trammel coverage [--keep] [--check rtl|cpp]
       scripts/tool coverage --count LAYER/BLOCK --program FILE

Without --check it runs the tests that count (--keep: uses the counts that are there), prints both
tables and writes sources with counts to build/coverage: rtl/annotated, cpp/index.html. With --check
it is a test of one kind; CTest runs the tests that count before it. Floors are in
scripts/coverage.toml and coverage.toml of each machine and part.

RTL, counted by the unit tests: --count runs one, and its counts are a kept result.
Every line and branch is executed, or it is listed in coverage.toml with a reason; signal toggles,
and the states that a `cover` of the properties names, stay above a floor for each block. Generated
register blocks are exempt.
C++, counted by the unit tests and runs of the sanitized build (scripts/tool sanitize), in whose
kept results the counts are: lines of each folder from host to testbench stay above its floor. A
line of a template counts once; generated files and the tests themselves do not count.

Exit codes: 0 all above their floors, 1 something is not, 2 no counts, 3 a tool is missing.
"""

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

from trammel_tools import machines, python_tools
from trammel_tools.check import coverage_cpp, rtl_counts, sanitize
from trammel_tools.check.rtl_counts import KINDS, Block
from trammel_tools.evidence import evidence, record
from trammel_tools.paths import ROOT
from trammel_tools.rtl import lint

FLOORS = ROOT / "scripts" / "coverage.toml"
COUNTS = ROOT / "build" / "coverage" / "rtl"
NO_COUNTS = 2


class CoverageError(Exception):
    """No counts, or floors that cannot be read."""


def count(block, program):
    """Runs a unit test that counts and prints what it covers: of its block, and of files without a
    test of their own, all; of the blocks inside, the lines. Returns its exit code."""
    files = COUNTS / f"{block.replace('/', '.')}.dat"
    COUNTS.mkdir(parents=True, exist_ok=True)
    for stale in COUNTS.glob(f"{files.name}.*"):
        stale.unlink()
    done = subprocess.run([program], env=os.environ | {"TRAMMEL_COVERAGE": str(files)},
                          stdout=subprocess.PIPE, text=True, errors="replace", check=False)
    if done.returncode != 0:
        print(done.stdout, end="", file=sys.stderr)
        return 1
    written = sorted(COUNTS.glob(f"{files.name}.*"))
    for path in written or [files]:
        if not rtl_counts.whole(path):
            raise CoverageError(f"{path.relative_to(ROOT)}: it holds no counts, or not all: is the "
                                "disk full? Make room and test again")
    blocks = rtl_counts.read_blocks(*written)
    inside = {name for name in blocks if name != block and counted_alone(name)}
    covered = {name: Block(lines=one.lines) if name in inside else one
               for name, one in blocks.items()}
    print("\n".join(rtl_counts.short(covered)))
    return 0


def counted_alone(block):
    layer, stem = block.split("/")
    return (ROOT / "tests" / layer / f"{stem}_test.cpp").exists()


def counted():
    """{block: counts} of the kept results of all tests that count."""
    names = [path.stem for path in sorted(record.KEPT.glob("coverage.*.*.txt"))]
    reasons = [reason for name in names if (reason := evidence.stale(name))]
    if reasons or not names:
        raise CoverageError(f"{(reasons or ['no counts in evidence/'])[0]}; run `trammel test -R "
                            "coverage`")
    return rtl_counts.read_short(*(record.read(name).result for name in names))


def annotate():
    files = sorted(COUNTS.glob("*.dat.*"))
    target = COUNTS.parent / "rtl.dat"
    subprocess.run(["verilator_coverage", "--write", target, *files], check=True,
                   capture_output=True)
    subprocess.run(["verilator_coverage", "--annotate", COUNTS / "annotated", "--annotate-all",
                    target], check=True, capture_output=True, cwd=ROOT)


def line_text(block, line):
    text = (ROOT / "rtl" / f"{block}.sv").read_text(encoding="utf-8").split("\n")
    return text[line - 1].strip()


def has_unit_test(block):
    """False of chips in the plain form, which the tests of their machine run whole: their layout
    asks for none."""
    layer, stem = block.split("/")
    return bool(list((ROOT / "tests" / layer).glob(f"{stem}_test.cpp"))) or layer != "chips"


def check_lines(blocks, exceptions):
    """What is not executed and not excepted, and exceptions that nothing needs. An exception is of
    one line, whatever points that has: another of the same text needs its own."""
    left = Counter((e["file"], e["branch"], e["text"]) for e in exceptions)
    excepted = set()
    for block, counts in blocks.items():
        for (line, _, branch), count in sorted(counts.lines.items()):
            if count > 0:
                continue
            name = f"rtl/{block}.sv"
            text = line_text(block, line)
            if (name, branch, line) in excepted:
                continue
            if left[name, branch, text] > 0:
                left[name, branch, text] -= 1
                excepted.add((name, branch, line))
            else:
                yield f"{name}:{line}: never executed ({branch}): {text}"
    for block in lint.blocks():
        if block not in blocks and has_unit_test(block):
            yield f"rtl/{block}.sv: no test counts it"
    for (name, branch, text), count in left.items():
        if count > 0:
            yield f"{FLOORS.name}: stale exception: {name} ({branch}): {text}"


def floor_of(floors, block):
    return floors.get(block, floors["default"])


def check_floors(blocks, what, floors, share):
    for block, counts in blocks.items():
        got, floor = share(counts), floor_of(floors, block)
        if got < floor:
            yield f"{block}: {what} {got:.1f} %, below its floor of {floor} %"
    for block in floors.keys() - blocks.keys() - {"default"}:
        yield f"{FLOORS.name}: {what}: no block {block}"


def print_rtl(blocks):
    print(f"{'RTL block':<24}{'lines':>14}{'toggles':>17}{'covers':>15}")
    total = Block()
    for name, counts in blocks.items():
        print(f"{name:<24}", *(cell(points, width) for points, width in (
            (counts.lines, 14), (counts.toggles, 17), (counts.covers, 15))), sep="")
        for kind in KINDS:
            getattr(total, kind).update(
                {(name, key): n for key, n in getattr(counts, kind).items()})
    print(f"{'all':<24}{cell(total.lines, 14)}{cell(total.toggles, 17)}{cell(total.covers, 15)}")


def cell(points, width):
    if not points:
        return " " * (width - 1) + "-"
    return f"{Block.share(points):.1f} % of {len(points)}".rjust(width)


def check_rtl(floors):
    blocks = counted()
    print_rtl(blocks)
    return [*check_lines(blocks, floors["exception"]),
            *check_floors(blocks, "toggles", floors["toggles"], lambda b: b.share(b.toggles)),
            *check_floors(blocks, "covers", floors["covers"], lambda b: b.share(b.covers))]


def check_cpp(floors):
    return coverage_cpp.check(floors, coverage_cpp.counted(sanitize.groups()))


def run_tests():
    done = subprocess.run([ROOT / "trammel", "test", "--fresh", "-R", "^coverage\\."], check=False,
                          stdout=sys.stderr)
    return done.returncode


def report(wrong):
    for line in wrong:
        print(f"coverage: {line}", file=sys.stderr)
    return 1 if wrong else 0


def main():
    parser = python_tools.Parser(prog="trammel coverage", description=__doc__)
    parser.add_argument("--keep", action="store_true", help="use the counts that are there")
    parser.add_argument("--check", choices=("rtl", "cpp"), help="only check the floors of one kind")
    parser.add_argument("--count", metavar="LAYER/BLOCK",
                        help="run the unit test of one block, the program of --program")
    parser.add_argument("--program", type=Path, metavar="FILE")
    options = parser.parse_args()
    try:
        if options.count:
            return count(options.count, options.program)
        floors = machines.tables("coverage.toml", FLOORS)
        if options.check == "rtl":
            return report(check_rtl(floors["rtl"]))
        if options.check == "cpp":
            return report(check_cpp(floors["cpp"]))
        if not options.keep and run_tests() not in (0, 1):
            return NO_COUNTS
        wrong = check_rtl(floors["rtl"])
        annotate()
        print(f"sources with counts: {(COUNTS / 'annotated').relative_to(ROOT)}")
        wrong += check_cpp(floors["cpp"])
        if coverage_cpp.annotate():
            print(f"sources with counts: {coverage_cpp.PAGES.relative_to(ROOT)}/index.html")
        return report(wrong)
    except (CoverageError, coverage_cpp.NoCounts, machines.MachineError) as error:
        print(f"coverage: {error}", file=sys.stderr)
        return NO_COUNTS
    except FileNotFoundError as error:
        print(f"coverage: {error.filename} is missing (trammel doctor)", file=sys.stderr)
        return 3
