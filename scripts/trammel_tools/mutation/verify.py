# SPDX-License-Identifier: Apache-2.0
"""Verify RTL blocks: their promises, or their tests by mutants; whole runs, keys, faults, gains.

usage: trammel verify [layer/block ...]            the promises, as trammel prove
       trammel verify --mutants [layer/block ...]  the whole campaign, against the block's floor
       trammel verify --sample [layer/block ...]   some of the mutants: none may survive unexplained
       trammel verify --check                      the floors and docs/mutation.md agree
       trammel verify --page                       writes the tables of docs/mutation.md
       trammel verify --engines [scenario ...]     whole scenarios, both engines: the same events
       trammel verify --engines --short            one short scenario per machine, as in the tests
       trammel verify --keys [--seed N]            each numeric key, at both ends and between
       trammel verify --keys --short               twelve keys of each machine, as in the tests
       trammel verify --faults [--page]            faults at three times of a run: what notices them
       trammel verify --faults --short             some of them, as in the tests
       trammel verify --sensitivity [--page]       calibrated values, 20 % less and more
       trammel verify --sensitivity --short        some of them, as in the tests
       trammel verify --acceptance                 whole specifications: all combinations of a grid

A campaign makes 200 mutants of a block, runs its unit test against each, and proves what it can of
those the test accepts: refuted by a promise, or equivalent. Its result, logs and models stay in
build/mutants/<block>; --afresh proves again what the result of this source already holds. Floors
and what is known of survivors stand in tests/mutants.toml and mutants.toml of machines and parts.

A fault is injected with the machine's monitors and without (runs.toml, too): 95 % of the dangerous
ones are noticed, and the outputs are off at once. --page writes docs/generated/faults.md.

A calibrated value is tried in the runs of runs.toml, and the change of their figures compared with
docs/generated/sensitivity.md, which --page writes.

Acceptance runs what runs.toml of a machine names: what a specification promises, measured beside
its bars, in minutes.

A key's value is tried in a short run of its machine (machines/<m>/tests/runs.toml): the run does
what was asked, or says why not, or the value is refused; RTL and twin give the same events.

Exit codes: 0 reached, 1 below the floor, not explained or different, 2 no such block or scenario,
3 a tool is missing.
"""

import shutil
import sys
import time

from trammel_tools import machines, python_tools
from trammel_tools.check import acceptance, engines, faults, keys, sensitivity
from trammel_tools.mutation import mutant_floors, mutant_proofs, mutant_tests, mutants
from trammel_tools.paths import ROOT
from trammel_tools.proof import properties, prove
from trammel_tools.rtl import yosys

# Small blocks that stand between a fault and the hardware; their models compile in seconds.
SAMPLED = ["drive/gate_leg", "drive/pwm", "drive/supervisor", "sense/adc_if", "motion/watchdog",
           "math/timer"]
SAMPLE = 20  # mutants of a block
BRIEF = 2  # [s]


def stopwatch():
    begin = time.monotonic()
    return lambda: time.monotonic() - begin


def judge(block, mutant, limit, assertions=True):
    """(kind of row, row) for a mutant that the unit test accepts."""
    row = {"number": mutant.number, "mutation": mutant.words}

    def refuted_by(seconds):
        return assertions and mutant_proofs.refuted_by(block, mutant.number, seconds)

    # A brief search of the promises first: some mutants are long in proving that they differ.
    label = refuted_by(min(BRIEF, limit))
    if not label:
        verdict, detail = mutant_proofs.compare(block, mutant.number, limit)
        if verdict == "equivalent":
            return "equivalent", {**row, "proof": detail}
        label = refuted_by(limit)
    if label:
        return "promise", {**row, "label": label}
    return "left", {**row, "why": detail}


def explain(block, accepted, limit):
    """(kind of row, mutant, row) of each mutant that the unit test accepts."""
    if not accepted:
        return
    mutant_proofs.write_netlists(block)
    if mutant_proofs.compare(block, 0, limit)[0] != "equivalent":
        raise mutants.MutationError("control: the netlist without a mutant is not the block, or "
                                    "that takes longer: --limit")
    # Properties that see a memory see it nowhere in the flat netlist.
    label = mutant_proofs.refuted_by(block, 0, limit)
    if label:
        print(f"  {block}: no promise is asked: {label} fails without a mutant", flush=True)
    for mutant in accepted:
        yield (mutant, *judge(block, mutant, limit, assertions=not label))


def campaign(block, limit, afresh, floors):
    """Lines of what went wrong; writes the result of a block."""
    clock = stopwatch()
    found = mutants.make(block)
    program = mutant_tests.build(block)
    built = clock()
    accepted = mutant_tests.survivors(block, program, [m.number for m in found])
    tested = clock()
    before = {} if afresh else mutant_floors.proven_before(block)
    result = mutant_floors.Result(block, len(found))
    result.equivalent = [before[key] for n in accepted
                         if (key := (n, found[n - 1].words)) in before]
    fresh = [found[n - 1] for n in accepted if (n, found[n - 1].words) not in before]
    for mutant, kind, row in explain(block, fresh, limit):
        getattr(result, kind).append(row)
        if kind == "left":
            print(f"  {left(block, mutant, row, floors)}", flush=True)
    path = mutant_floors.write(result)
    print(f"{block}: {result.score:.1f} % of at least {floors.of(block):.0f} %: {len(found)} "
          f"mutants, {len(found) - len(accepted)} refused by the test, {len(result.promise)} by "
          f"promises, {len(result.equivalent)} equivalent, {len(result.left)} left; build "
          f"{built:.0f} s, test {tested - built:.0f} s, proofs {clock() - tested:.0f} s; "
          f"{path.relative_to(ROOT)}", flush=True)
    if result.score >= floors.of(block):
        return []
    return [f"{block}: {result.killed} of {result.counted} mutants refused, {result.score:.1f} %: "
            f"at least {floors.of(block):.0f} %"]


def left(block, mutant, row, floors):
    """What is printed of a mutant that nothing refutes."""
    known = "" if mutant.words in floors.known(block) else "; not among its known survivors"
    return f"{mutant.number} {mutant.where}: {mutant.words}: {row['why']}{known}"


def sample(block, limit, floors):
    """Lines of what went wrong: each mutant of the sample that nobody can explain."""
    clock = stopwatch()
    found = mutants.make(block)
    program = mutant_tests.build(block)
    chosen = [m.number for m in found][::max(1, len(found) // SAMPLE)][:SAMPLE]
    accepted = [found[n - 1] for n in mutant_tests.survivors(block, program, chosen)]
    known = [mutant for mutant in accepted if mutant.words in floors.known(block)]
    kinds, wrong = dict.fromkeys(mutant_floors.KINDS, 0), []
    for mutant, kind, row in explain(block, [m for m in accepted if m not in known], limit):
        kinds[kind] += 1
        if kind == "left":
            wrong.append(f"{block}: mutant {left(block, mutant, row, floors)}: better the test or "
                         "say in its mutants.toml why")
    print(f"{block}: {len(chosen)} mutants, {len(chosen) - len(accepted)} refused by the test, "
          f"{kinds['promise']} by promises, {kinds['equivalent']} equivalent, {len(known)} known, "
          f"{kinds['left']} not explained in {clock():.0f} s", flush=True)
    return wrong


def parse(every):
    parser = python_tools.Parser(prog="trammel verify", description=__doc__)
    what = parser.add_mutually_exclusive_group()
    for name in ("mutants", "sample", "check", "page", "engines", "keys", "acceptance"):
        what.add_argument(f"--{name}", action="store_true")
    for name in ("faults", "sensitivity"):  # with --page: of them
        parser.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--afresh", action="store_true")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of --keys (default 1)")
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
    wrong, floors = [], mutant_floors.read(every)
    if arguments.mutants or arguments.sample:
        for block in arguments.blocks or (every if arguments.mutants else SAMPLED):
            try:
                if arguments.sample:
                    wrong += sample(block, arguments.limit, floors)
                else:
                    wrong += campaign(block, arguments.limit, arguments.afresh, floors)
            except (properties.PropertiesError, mutants.MutationError,
                    yosys.YosysError) as error:
                wrong.append(f"{block}: {error}")
    if arguments.page:
        print(f"wrote {mutant_floors.write_page(every).relative_to(ROOT)}")
    if arguments.check:
        wrong += mutant_floors.problems(every)
    return wrong


def runs(arguments):
    """Lines of what went wrong in runs of whole machines."""
    if arguments.acceptance:
        return acceptance.check()
    if arguments.keys:
        return keys.check(arguments.short, arguments.seed)
    if arguments.faults:
        return faults.check(arguments.short, arguments.page)
    if arguments.sensitivity:
        return sensitivity.check(arguments.short, arguments.page)
    return engines.compare(arguments.blocks or engines.scenarios(arguments.short))


def main():
    every = mutant_tests.mutated()
    arguments = parse(every)
    if any((arguments.engines, arguments.keys, arguments.faults, arguments.sensitivity,
            arguments.acceptance)):
        try:
            wrong = runs(arguments)
        except (engines.EngineError, machines.MachineError) as error:
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
