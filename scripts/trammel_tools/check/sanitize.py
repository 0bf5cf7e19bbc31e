# SPDX-License-Identifier: Apache-2.0
"""Run the C++ code under the address and undefined-behaviour sanitizers, and count its coverage.

usage: scripts/tool sanitize build      the preset asan: own code checked, models those of build/
       scripts/tool sanitize unit       its unit tests
       scripts/tool sanitize program    whole runs of its program, good and bad input

CTest runs the three in this order. A finding ends a program with an exit code that no case
expects. Nothing is suppressed. Two checks of the second sanitizer are left out, which are a quarter
of the time to compile: what goes to a null pointer ends in the address sanitizer anyway, and
alignment is checked with Clang by the fuzzers.

SystemC runs its threads on stacks that it allocates (QuickThreads). AddressSanitizer treats them
like any other memory: locals on them are checked too. Two limits follow. Locals cannot move to the
fake stack of the system's thread, so detect_stack_use_after_return, and nothing else, is off. And
an exception thrown on such a stack leaves marks of dead locals there, which may later look like a
finding: no case throws inside a SystemC thread. The verilated models are not checked.

Exit codes: 0 no finding, 1 a finding or a wrong exit code, 2 usage, or there is no such build.
"""

import itertools
import os
import shutil
import subprocess
import sys

from trammel_tools import machines
from trammel_tools.paths import ROOT

BUILD = ROOT / "build" / "asan"
PROGRAM = BUILD / "testbench" / "trammel"
OUT = BUILD / "runs"
ENVIRONMENT = os.environ | {
    "ASAN_OPTIONS": "detect_stack_use_after_return=0:exitcode=99",
    "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99",
    "LSAN_OPTIONS": "exitcode=99"}
# Exit code, then the command line; `OUT` stands for the folder of all. Runs of a machine are in its
# tests/sanitize.py: RUNS, REFUSED, FOLDER of one that a report can be made of, and, where they are
# needed, write_input(out), write_bad_input(out), passes(program, environment, out).
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


def fault_runs(machine):
    """A run cut short with each fault of a machine, the wirings in turn."""
    plan = machines.runs(machine).get("faults", {}).get("wiring", {})
    for n, kind in enumerate(plan.get("kinds", [])):
        settings = [*plan["settings"], f"inject.fault={kind}", *plan["with"].get(kind, [])]
        wiring = (("--engine", "twin"), ("--platform", "systemc"))[n % 2]
        if kind == "register_flip":
            wiring = ("--platform", "direct")
        yield (5, "run", plan["scenario"], *wiring, "-o", "OUT/fault",
               *(word for one in settings for word in ("-s", one)))


def runs_of(cases):
    """All runs, with what every machine lists."""
    return [*(run for case in cases.values() for run in case.RUNS), *RUNS,
            *(run for machine in cases for run in fault_runs(machine)),
            *((0, "list", topic, machine) for machine in cases for topic in ("keys", "columns"))]


def refused_of(cases):
    """All that is refused, with reports of two machines."""
    folders = [case.FOLDER for case in cases.values()]
    return [*REFUSED, *(line for case in cases.values() for line in case.REFUSED),
            *((2, "only runs of one machine", "report", one, other, "-o", "OUT/two.html")
              for one, other in itertools.pairwise(folders)),
            (2, "at most 12", "report", *folders[:1] * 13, "-o", "OUT/two.html"),
            (2, "name a file", "report", *folders[:1], "-o", "OUT/empty")]


def configure_and_build():
    if not (ROOT / "build" / "build.ninja").exists():
        print("sanitize: there is no build: trammel test makes it", file=sys.stderr)
        return 2
    for stale in BUILD.rglob("*.gcda"):
        stale.unlink()
    log = ROOT / "build" / "asan.log"
    with log.open("w", encoding="utf-8") as out:
        for command in ["cmake", "--preset", "asan"], ["ninja", "-C", BUILD, "trammel_checked"]:
            done = subprocess.run(command, cwd=ROOT, stdout=out, stderr=out, check=False)
            if done.returncode != 0:
                print(f"sanitize: {' '.join(map(str, command))} failed; end of {log}:\n"
                      + log.read_text(encoding="utf-8")[-4000:], file=sys.stderr)
                return 1
    return 0


def unit():
    return subprocess.run(["ctest", "--test-dir", BUILD, "-R", r"^unit\.", "-j", "2",
                           "--output-on-failure", "--no-tests=error"], env=ENVIRONMENT,
                          check=False).returncode and 1


# The leak checker reads the stacks of a stopped program; at one that SystemC has just freed it
# crashes itself. That says nothing about the program, which is run again.
TRACER_DIED = "LeakSanitizer has encountered a fatal error"
ATTEMPTS = 4


def succeeds(code, says, words):
    command = [PROGRAM, *(w.replace("OUT", str(OUT)) for w in words)]
    for _ in range(ATTEMPTS):
        done = subprocess.run(command, env=ENVIRONMENT, cwd=OUT, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, errors="replace", check=False)
        if TRACER_DIED not in done.stderr:
            break
    line = f"trammel {' '.join(words)}: exit code {done.returncode}"
    told = [text for text in done.stderr.split("\n")[:-1] if "waves of" not in text]
    clear = says is None or (len(told) == 1 and told[0].startswith("trammel: ") and says in told[0])
    if done.returncode == code and clear and "Sanitizer" not in done.stderr:
        print(line)
        return True
    wanted = f"{code}" + (f" and one line that says `{says}`" if says else "")
    print(f"sanitize: {line}, expected {wanted}\n{done.stderr[-6000:]}", file=sys.stderr)
    return False


def call_each(cases, name, *arguments):
    """What each machine that has this function returns."""
    return [getattr(case, name)(*arguments) for case in cases.values() if hasattr(case, name)]


def program():
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    cases = machines.modules("sanitize")
    call_each(cases, "write_input", OUT)
    good = [succeeds(code, None, words) for code, *words in runs_of(cases)]
    if not all(good):
        return 1
    (OUT / "empty").mkdir()
    (OUT / "bad.toml").write_text("[gains\nkp = 1\n", encoding="utf-8")
    (OUT / "bad.csv").write_text("1,2\n3;4\n", encoding="utf-8")
    call_each(cases, "write_bad_input", OUT)
    refused = [succeeds(code, says, words) for code, says, *words in refused_of(cases)]
    talks = call_each(cases, "passes", PROGRAM, ENVIRONMENT, OUT)
    return 0 if all(refused) and all(talks) else 1


def main():
    verbs = {"build": configure_and_build, "unit": unit, "program": program}
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    if len(sys.argv) != 2 or sys.argv[1] not in verbs:
        print(f"sanitize: one of {', '.join(verbs)}; see --help", file=sys.stderr)
        return 2
    return verbs[sys.argv[1]]()
