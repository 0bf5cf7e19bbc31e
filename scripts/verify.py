#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Verify RTL blocks: prove their promises, or measure how well their tests would see a fault; or
whole runs: the twin engine against the RTL.

usage: verify.py [layer/block ...]               the promises, as trammel prove
       verify.py --mutants [layer/block ...]     the whole campaign; writes the table of a block
       verify.py --sample [layer/block ...]      mutants that were refused must still be refused
       verify.py --check                         every block has a table, not stale, over its floor
       verify.py --page                          writes docs/mutation.md from the tables
       verify.py --engines [scenario ...]        whole scenarios with both engines: the same events

A campaign makes 200 mutants of a block, runs its unit test against each, and proves what it can of
those the test accepts: refuted by a promise, or equivalent. --afresh proves again what the table
already holds. Logs and models stay in build/mutants/<block>.

Exit codes: 0 reached, 1 under the floor, stale or different, 2 no such block or scenario, 3 a tool
is missing.
"""

import shutil
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import engines  # noqa: E402
import lint  # noqa: E402
import mutant_proofs  # noqa: E402
import mutant_tables  # noqa: E402
import mutant_tests  # noqa: E402
import mutants  # noqa: E402
import properties  # noqa: E402
import prove  # noqa: E402
import python_tools  # noqa: E402
import yosys  # noqa: E402

# Small blocks that stand between a fault and the hardware; their models compile in seconds.
SAMPLED = ["drive/gate_leg", "drive/pwm", "drive/supervisor", "sense/adc_if", "motion/watchdog",
           "math/timer"]


def stopwatch():
    begin = time.monotonic()
    return lambda: time.monotonic() - begin


def judge(block, mutant, limit):
    """(kind of row, row) for a mutant that the unit test accepts."""
    row = {"number": mutant.number, "mutation": mutant.words}
    verdict, detail = mutant_proofs.compare(block, mutant.number, limit)
    if verdict == "equivalent":
        return "equivalent", {**row, "proof": detail}
    label = mutant_proofs.refuted_by(block, mutant.number, limit)
    if label:
        return "promise", {**row, "label": label}
    return "left", {**row, "why": detail}


def campaign(block, limit, afresh):
    """Writes the table of a block; returns it."""
    clock = stopwatch()
    found = mutants.make(block)
    program = mutant_tests.build(block)
    built = clock()
    accepted = mutant_tests.survivors(block, program, [m.number for m in found])
    tested = clock()
    mutant_proofs.write_netlists(block)
    if mutant_proofs.compare(block, 0, limit)[0] != "equivalent":
        raise mutants.MutationError("control: the netlist without a mutant is not the block, or "
                                    "that takes longer: --limit")
    table = mutant_tables.Table(block, mutants.source_hash(block), len(found))
    before = mutant_tables.read(block)
    known = {}
    if before and not afresh and before.source == table.source:
        known = {(row["number"], row["mutation"]): row for row in before.equivalent}
    for number in accepted:
        mutant = found[number - 1]
        row = known.get((number, mutant.words))
        kind, row = ("equivalent", row) if row else judge(block, mutant, limit)
        getattr(table, kind).append(row)
        if kind == "left":
            print(f"  {number} {mutant.where}: {mutant.words}: {row['why']}", flush=True)
    refused = [m.number for m in found if m.number not in accepted]
    table.sample = refused[::max(1, len(refused) // mutant_tables.SAMPLE)][:mutant_tables.SAMPLE]
    mutant_tables.write(table)
    print(f"{block}: {table.score:.1f} % of at least {table.floor:.0f} %: {len(found)} mutants, "
          f"{len(refused)} refused by the test, {len(table.promise)} by promises, "
          f"{len(table.equivalent)} equivalent, {len(table.left)} left; build {built:.0f} s, "
          f"test {tested - built:.0f} s, proofs {clock() - tested:.0f} s", flush=True)
    return table


def sample(block):
    """Lines of what went wrong with the mutants of a block's sample."""
    table = mutant_tables.read(block)
    if table is None or table.source != mutants.source_hash(block):
        return []  # --check says so
    clock = stopwatch()
    mutants.make(block)
    program = mutant_tests.build(block)
    accepted = mutant_tests.survivors(block, program, table.sample)
    print(f"{block}: {len(table.sample) - len(accepted)} of {len(table.sample)} mutants refused "
          f"in {clock():.0f} s", flush=True)
    wrong = [f"{block}: the unit test accepts mutant {n}, which it refused before"
             for n in accepted]
    for row in table.promise:
        if mutant_proofs.refuted_by(block, row["number"], 30) is None:
            wrong.append(f"{block}: no promise is broken by mutant {row['number']}, which "
                         f"{row['label']} refused before")
    return wrong


def parse(every):
    parser = python_tools.Parser(prog="trammel verify", description=__doc__)
    what = parser.add_mutually_exclusive_group()
    for name in ("mutants", "sample", "check", "page", "engines"):
        what.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--afresh", action="store_true")
    parser.add_argument("--limit", type=int, default=60, metavar="SECONDS",
                        help="for one proof (default 60)")
    parser.add_argument("blocks", nargs="*", metavar="layer/block", help="or scenario")
    arguments = parser.parse_args()
    if arguments.engines:
        for name in arguments.blocks:
            if name not in engines.scenarios():
                parser.error(f"{name}: no such scenario; there are "
                             f"{', '.join(engines.scenarios())}")
        return arguments
    for block in arguments.blocks:
        if block not in every:
            parser.error(f"rtl/{block}.sv: no such block; there are {', '.join(every)}")
    if arguments.limit < 1:
        parser.error("--limit: at least 1 second")
    return arguments


def run(arguments, every):
    """Lines of what went wrong."""
    wrong = []
    if arguments.mutants or arguments.sample:
        for block in arguments.blocks or (every if arguments.mutants else SAMPLED):
            try:
                if arguments.sample:
                    wrong += sample(block)
                else:
                    campaign(block, arguments.limit, arguments.afresh)
            except (properties.PropertiesError, mutants.MutationError,
                    yosys.YosysError) as error:
                wrong.append(f"{block}: {error}")
    if arguments.mutants or arguments.page:
        print(f"wrote {mutant_tables.write_page(every).relative_to(properties.ROOT)}")
    if not arguments.page:
        wrong += mutant_tables.problems(arguments.blocks or every)
    return wrong


def main():
    every = [b for b in lint.blocks() if mutant_tests.test_of(b).exists()]
    arguments = parse(every)
    if arguments.engines:
        try:
            wrong = engines.compare(arguments.blocks or engines.scenarios())
        except engines.EngineError as error:
            wrong = [str(error)]
        for line in wrong:
            print(f"verify: {line}", file=sys.stderr)
        return 1 if wrong else 0
    if not (arguments.mutants or arguments.sample or arguments.check or arguments.page):
        sys.argv[1:] = [f"--limit={arguments.limit}", *arguments.blocks]
        return prove.main()
    if arguments.mutants or arguments.sample:
        python_tools.need("pyosys", "verify")
        if shutil.which("verilator") is None:
            print("verify: verilator is missing (trammel doctor)", file=sys.stderr)
            return 3
    wrong = run(arguments, every)
    for line in wrong:
        print(f"verify: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
