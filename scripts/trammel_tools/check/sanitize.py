# SPDX-License-Identifier: Apache-2.0
"""Run C++ code under the address and undefined-behaviour sanitizers, and count its coverage.

usage: scripts/tool sanitize GROUP      a folder of tests/ with unit tests, or a machine

It builds what the group needs in build/asan (preset asan): own code is checked, the models are
those of build/. Then it runs the unit tests of the group; of a machine whole runs of its program
too, good and bad input, and in the group testbench those of the program of all machines. It prints
how many passed, and which lines of which files were executed, for `trammel coverage`.

A finding ends a program with an exit code that no case expects. Nothing is suppressed. Two checks
of the second sanitizer are left out, which are a quarter of the time to compile: what goes to a
null pointer ends in the address sanitizer anyway, and alignment is checked with Clang by the
fuzzers.

SystemC runs its threads on stacks that it allocates (QuickThreads). AddressSanitizer treats them
like any other memory: locals on them are checked too. Two limits follow. Locals cannot move to the
fake stack of the system's thread, so detect_stack_use_after_return, and nothing else, is off. And
an exception thrown on such a stack leaves marks of dead locals there, which may later look like a
finding: no case throws inside a SystemC thread. The verilated models are not checked.

Exit codes: 0 no finding, 1 a finding, a wrong exit code or no build, 2 usage.
"""

import dataclasses
import fcntl
import itertools
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from trammel_tools import machines
from trammel_tools.check import coverage_cpp
from trammel_tools.paths import ROOT

BUILD = ROOT / "build" / "asan"
GENERAL = "testbench"  # the group with the program of all machines
ENVIRONMENT = os.environ | {
    "ASAN_OPTIONS": "detect_stack_use_after_return=0:exitcode=99",
    "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99",
    "LSAN_OPTIONS": "exitcode=99"}
# Exit code, then the command line; `OUT` stands for the folder of a group. Runs of a machine are in
# its tests/sanitize.py: RUNS, REFUSED, FOLDER of one that a report can be made of, and, where they
# are needed, REFUSED_BY_ALL, which the program of all machines refuses, write_input(out),
# write_bad_input(out), passes(program, environment, out).
RUNS = [
    (0, "list"), (0, "list", "machines"), (0, "list", "machines", "--json"),
    (0, "list", "keys"), (0, "list", "keys", "--json"), (0, "list", "columns", "--json"),
    (0, "list", "signals"), (0, "list", "signals", "--json"),
    (0, "--version"), (0, "--help"), (0, "run", "--help"),
    (0, "doctor", "--json"), (2,), (2, "list", "nothing"),
]
# What is refused, or cannot be given: exit code, what its one line says, the command line.
REFUSED = [
    (2, "did you mean run?", "rum"), (2, "name a scenario", "run"),
    (2, "no such scenario", "run", "no such"),
    (2, "no such folder", "report", "OUT/none"), (2, "is not a folder", "report", "OUT/bad.csv"),
    (2, "no run in out/", "report"), (2, "is missing", "report", "OUT/empty"),
]


def fault_runs(machine, kinds):
    """A run cut short with each of these faults of a machine, the wirings in turn."""
    plan = machines.runs(machine).get("faults", {}).get("wiring")
    for n, kind in enumerate(kinds if plan else []):
        settings = [*plan["settings"], f"inject.fault={kind}", *plan.get("with", {}).get(kind, [])]
        wiring = (("--engine", "twin"), ("--platform", "systemc"))[n % 2]
        if kind == "register_flip":
            wiring = ("--platform", "direct")
        yield (5, "run", plan["scenario"], *wiring, "-o", "OUT/fault",
               *(word for one in settings for word in ("-s", one)))


def of_machine(name, case, kinds):
    """What is run and what is refused by the program of one machine."""
    return ([*case.RUNS, *fault_runs(name, kinds),
             *((0, "list", topic, name) for topic in ("keys", "columns"))], case.REFUSED)


def of_all(cases):
    """What is run and what is refused by the program of all machines, with reports of two."""
    folders = [case.FOLDER for case in cases.values()]
    runs = [next(run for run in case.RUNS if case.FOLDER in run) for case in cases.values()]
    return ([*runs, *RUNS],
            [*REFUSED, *(line for case in cases.values()
                         for line in getattr(case, "REFUSED_BY_ALL", [])),
             *((2, "only runs of one machine", "report", one, other, "-o", "OUT/two.html")
               for one, other in itertools.pairwise(folders)),
             (2, "at most 12", "report", *folders[:1] * 13, "-o", "OUT/two.html"),
             (2, "name a file", "report", *folders[:1], "-o", "OUT/empty")])


def groups():
    """Folders of tests/ with unit tests, and machines."""
    return sorted({path.parent.name for path in ROOT.glob("tests/*/*_test.cpp")} |
                  machines.folders().keys())


def build(target):
    """Builds it, one at a time; what went wrong, or nothing."""
    if not (ROOT / "build" / "build.ninja").exists():
        return "there is no build: trammel test makes it"
    BUILD.mkdir(exist_ok=True)
    log = BUILD / f"{target}.log"
    commands = [["ninja", "-C", BUILD, target]]
    with (BUILD / ".building").open("w") as lock, log.open("w", encoding="utf-8") as out:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (BUILD / "build.ninja").exists():
            commands.insert(0, ["cmake", "--preset", "asan"])
        for command in commands:
            done = subprocess.run(command, cwd=ROOT, stdout=out, stderr=out, check=False)
            if done.returncode != 0:
                return (f"{' '.join(map(str, command))} failed; end of {log}:\n"
                        + log.read_text(encoding="utf-8")[-4000:])
    return ""


def unit(group, environment):
    """How many unit tests passed, or nothing where one failed."""
    done = subprocess.run(["ctest", "--test-dir", BUILD, "-R", rf"^unit\.{group}\.",
                           "--output-on-failure", "--no-tests=error"], env=environment,
                          capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="", file=sys.stderr)
        return None
    return re.search(r"tests passed, 0 tests failed out of (\d+)", done.stdout)[1]


# The leak checker reads the stacks of a stopped program; at one that SystemC has just freed it
# crashes itself. That says nothing about the program, which is run again.
TRACER_DIED = "LeakSanitizer has encountered a fatal error"
ATTEMPTS = 4


@dataclasses.dataclass(frozen=True)
class Program:
    """A program, the folder that its command lines call OUT, and its environment."""
    path: Path
    out: Path
    environment: dict

    def succeeds(self, code, says, words):
        command = [self.path, *(w.replace("OUT", str(self.out)) for w in words)]
        for _ in range(ATTEMPTS):
            done = subprocess.run(command, env=self.environment, cwd=self.out,
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  errors="replace", check=False)
            if TRACER_DIED not in done.stderr:
                break
        told = [text for text in done.stderr.split("\n")[:-1] if "waves of" not in text]
        clear = says is None or (len(told) == 1 and told[0].startswith("trammel: ")
                                 and says in told[0])
        if done.returncode == code and clear and "Sanitizer" not in done.stderr:
            return True
        wanted = f"{code}" + (f" and one line that says `{says}`" if says else "")
        print(f"sanitize: trammel {' '.join(words)}: exit code {done.returncode}, expected "
              f"{wanted}\n{done.stderr[-6000:]}", file=sys.stderr)
        return False

    def passes(self, runs, refused, cases):
        """Good input first, then bad: whether all ended as they must."""
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir(parents=True)
        call_each(cases, "write_input", self.out)
        good = [self.succeeds(code, None, words) for code, *words in runs]
        if not all(good):
            return False
        (self.out / "empty").mkdir()
        (self.out / "bad.toml").write_text("[gains\nkp = 1\n", encoding="utf-8")
        (self.out / "bad.csv").write_text("1,2\n3;4\n", encoding="utf-8")
        call_each(cases, "write_bad_input", self.out)
        good = [self.succeeds(code, says, words) for code, says, *words in refused]
        return all(good)


def call_each(cases, name, *arguments):
    """What each machine that has this function returns."""
    return [getattr(case, name)(*arguments) for case in cases if hasattr(case, name)]


def program_of(group, environment):
    """How many command lines of a group's program passed: none of a group that has no program,
    nothing where one failed."""
    cases = machines.modules("sanitize")
    if group == GENERAL:
        name, (runs, refused), own = "trammel", of_all(cases), []
    elif group in cases:
        name, own = f"trammel_{group}_watched", [cases[group]]
        kinds = machines.fault_kinds(BUILD / "testbench" / name, group, environment)
        runs, refused = of_machine(group, *own, kinds)
    else:
        return 0
    program = Program(BUILD / "testbench" / name, BUILD / "runs" / group, environment)
    good = [program.passes(runs, refused, own or cases.values()),
            *call_each(own, "passes", program.path, environment, program.out)]
    return len(runs) + len(refused) if all(good) else None


def check(group):
    if failed := build(f"checked_{group}"):
        print(f"sanitize: {failed}", file=sys.stderr)
        return 1
    environment = ENVIRONMENT | coverage_cpp.begin(group)
    done = unit(group, environment)
    runs = done and program_of(group, environment)
    if done is None or runs is None:
        return 1
    print(f"{done} unit tests{f' and {runs} command lines' if runs else ''} without a finding")
    print("\n".join(coverage_cpp.short(coverage_cpp.count(group))))
    return 0


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    if len(sys.argv) != 2 or sys.argv[1] not in groups():
        print(f"sanitize: one of {', '.join(groups())}; see --help", file=sys.stderr)
        return 2
    return check(sys.argv[1])
