#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the C++ code under the address and undefined-behaviour sanitizers, and count its coverage.

usage: sanitize.py build      the preset asan: own code checked, verilated models those of build/
       sanitize.py unit       its unit tests
       sanitize.py program    whole runs of its program, good and bad input

CTest does the three in this order. A finding ends a program with an exit code that no case
expects. Nothing is suppressed.

SystemC runs its threads on stacks of its own (QuickThreads), which AddressSanitizer takes for
memory like any other: locals on them are checked too. Two limits follow. Locals cannot move to the
fake stack of the system's thread, so detect_stack_use_after_return, and it alone, is off. And an
exception thrown on such a stack leaves marks of dead locals there, which may later look like a
finding: no case throws inside a thread of SystemC. The verilated models are not checked.

Exit codes: 0 no finding, 1 a finding or a wrong exit code, 2 usage, or there is no such build.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "asan"
PROGRAM = BUILD / "testbench" / "trammel"
OUT = BUILD / "runs"
ENVIRONMENT = os.environ | {
    "ASAN_OPTIONS": "detect_stack_use_after_return=0:exitcode=99",
    "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99",
    "LSAN_OPTIONS": "exitcode=99"}
# A few points, so that start-up, service routine and every output of a run are there.
LINE = ("-s", "path.kind=line", "-s", "path.line_end_x_m=0.1005", "-s", "path.line_end_y_m=0.1003",
        "-s", "path.line_ticks=10", "-s", "run.platform=direct")
SHORT = ("run", "circle", *LINE)
TWIN = ("--engine", "twin")
WAVE = (*SHORT, "-o", "OUT/waves", "--wave")
AN693 = ("run", "an693-tuning", "-s", "trajectory.steps=1", "-s", "trajectory.wait_s=0.005")
MCAFEE = ("run", "mcafee-stage3", "-s", "path.kind=corner", "-s", "path.side_mm=2", "-s",
          "path.radius_mm=1", "-s", "compare=false", "-s", "trajectory.wait_s=0.001")
# Exit code, then the command line; `OUT` stands for the folder of all.
RUNS = [
    (0, *SHORT, "-o", "OUT/direct", "--wave", "fst", "--wave-window", "20ms:20.1ms"),
    (0, *SHORT, "--platform", "systemc", "-o", "OUT/systemc", "--json"),
    (0, *WAVE, "vcd", "--wave-trigger", "drives", "--wave-window", "0:10us", "-s", "controller=fc"),
    (0, *WAVE, "fst", "--wave-trigger", "x.e > 0 after 1ms", "--wave-every", "10ms",
     "--wave-window", "0:10us", "--platform", "systemc"),
    (0, "run", "step", "-s", "path.square_half_samples=20", "-s", "path.square_periods=2",
     "-o", "OUT/step"),
    (0, *SHORT, "-o", "OUT/asserted", "--assert", "--check", "-s", "run.leap=false"),
    (0, "run", "step", *TWIN, "-o", "OUT/whole_step"),
    (0, "run", "--all", *LINE, "-o", "OUT/all"),
    (5, *SHORT, "--platform", "systemc", "-o", "OUT/tripped", "-s", "inject.trip_s=0.01"),
    (5, *SHORT, "-o", "OUT/encoder", "-s", "inject.encoder_s=0.01"),
    (5, *SHORT, "--platform", "systemc", "-o", "OUT/watchdog", "-s", "inject.processor_s=0.01",
     "-s", "chip.watchdog_ticks=5"),
    (5, *SHORT, "-o", "OUT/short", "-s", "run.max_s=0.005"),
    (0, *SHORT, "-o", "OUT/audited", "--audit"),
    (0, *SHORT, "-o", "OUT/twin", *TWIN, "-s", "gains.interpolate=true"),
    (0, "run", "step", "-s", "path.square_half_samples=20", "-s", "path.square_periods=2",
     "-o", "OUT/twin_step", *TWIN),
    (5, *SHORT, "-o", "OUT/twin_tripped", *TWIN, "-s", "inject.trip_s=0.01"),
    (5, *SHORT, "-o", "OUT/twin_encoder", *TWIN, "-s", "inject.encoder_s=0.01"),
    (5, *SHORT, "-o", "OUT/twin_watchdog", *TWIN, "-s", "inject.processor_s=0.01",
     "-s", "chip.watchdog_ticks=5"),
    (0, "report", "OUT/direct", "OUT/systemc", "-o", "OUT/two.html"),
    (0, "report", "OUT/step", "--json"),
    (0, "report", "OUT/direct", "OUT/direct", "-o", "OUT/two.html"),
    (0, "run", "OUT/step/run.toml", "-o", "OUT/again", "-s", "name=a < b & c"),
    (0, *AN693, "-o", "OUT/an693"),
    (0, *AN693, "--json", "--platform", "direct", "-o", "OUT/an693"),
    (0, *AN693, "--no-leap", "-s", "program=hold", "-o", "OUT/an693"),
    *((5, "run", f"an693-{program}", "-s", "run.max_s=0.02", "-o", "OUT/an693")
      for program in ("absolute", "relative", "breakpoints")),
    (0, *AN693, "--audit", "-o", "OUT/an693"), (0, *AN693, "--assert", "-o", "OUT/an693"),
    (0, *MCAFEE, "-o", "OUT/mcafee"),
    (0, *AN693, "--wave", "vcd", "--wave-trigger", "hi", "-o", "OUT/an693"),
    (0, *AN693, "--engine", "twin", "-o", "OUT/an693"), (0, "track", "--listing"),
    (0, *MCAFEE, "--wave", "fst", "--wave-trigger", "row == 1", "-o", "OUT/mcafee"),
    (0, "lm628", "hold", "--wave", "fst", "--wave-window", "1.5ms:1.6ms", "-o", "OUT/lm628"),
    (0, *MCAFEE, "--wave", "fst", "--wave-window", "5ms:5.1ms", "-o", "OUT/mcafee"),
    *((5, *MCAFEE, way, "-s", "run.max_s=0.01", "-o", "OUT/mcafee")
      for way in ("--audit", "--assert")),
    (0, *MCAFEE, "--json", "--platform", "direct", "--no-leap", "-o", "OUT/mcafee"),
    (0, *MCAFEE, "--engine", "twin", "-s", "path.kind=star", "-s", "path.side_mm=4",
     "-s", "path.radius_mm=0.2", "-s", "compare=true", "-o", "OUT/mcafee"),
    (0, "run", "mcafee-stage1", "-s", "trajectory.readings=3", "-o", "OUT/mcafee"),
    (5, "run", "mcafee-stage2", "-s", "run.max_s=0.02", "-o", "OUT/mcafee"),
    (5, *MCAFEE, "-s", "path.side_mm=4", "-s", "stage.switch_high_m=0.001", "-o", "OUT/mcafee"),
    (0, "report", "OUT/mcafee"), (0, "report", "OUT/mcafee", "OUT/mcafee", "-o", "OUT/two.html"),
    (0, "track"), (0, "track", "-s", "path.kind=circle", "-o", "OUT/circle.csv"),
    (0, "list", "keys", "mcafee"),
    # A gain that rounds up to the next power of two, and one below the least exponent.
    (0, *SHORT, "-s", "gains.kp=0.99999", "-s", "gains.ki=1e-6", "-o", "OUT/gains"),
    (5, "run", "an693-hold", "-s", "run.diverged_counts=1", "-o", "OUT/an693"),
    (0, "lm628", "tuning", "-o", "OUT/lm628"), (0, "lm628", "hold", "--json"),
    (0, "lm628", "--audit"),
    (0, "lm628", "OUT/all.lm628"), (0, "report", "OUT/an693", "OUT/lm628", "-o", "OUT/two.html"),
    (0, "list", "keys", "an693"), (0, "list"), (0, "list", "keys"),
    (0, "list", "signals", "--json"), (0, "--version"),
    (0, "list", "signals"), (0, "list", "keys", "--json"), (0, "--help"), (0, "run", "--help"),
    (0, "doctor", "--json"), (2,), (2, "list", "nothing"),
]
# What is refused, or cannot be given: exit code, what its one line says, the command line.
REFUSED = [
    (2, "did you mean run?", "rum"), (2, "name a scenario", "run"),
    (2, "no such scenario", "run", "no such"),
    (2, "a scenario beside it", "run", "--all", "circle"),
    (2, "both controllers", "run", "--all", "-s", "controller=fc"),
    (2, "is out of range", "run", "circle", "-s", "gains.kp=33"),
    (2, "did you mean", "run", "circle", "-s", "gains.kpp=1"),
    (2, "expects key=value", "run", "circle", "-s", "gains.kp"),
    (2, "not a whole number", "run", "circle", "-s", "path.line_ticks=ten"),
    (2, "cannot be read", "run", "circle", "-c", "OUT/none.toml"),
    (2, "bad.toml:1", "run", "circle", "-c", "OUT/bad.toml"),
    (2, "path.points_file", "run", "circle", "-s", "path.kind=points"),
    (2, "bad.csv:2", "run", "circle", "-s", "path.kind=points",
     "-s", "path.points_file=OUT/bad.csv"),
    (2, "is not a folder", "run", "circle", "-o", "OUT/bad.csv"),
    (2, "is not a:b", *WAVE, "fst", "--wave-window", "5ms"),
    (2, "run.audit", *SHORT, "--audit", "--no-leap", "-o", "OUT/waves"),
    (2, "run.engine", *SHORT, *TWIN, "--audit", "-o", "OUT/waves"),
    (2, "run.engine", *MCAFEE, *TWIN, "--assert", "-o", "OUT/mcafee"),
    (2, "is outside the run", *WAVE, "fst", "--wave-window", "200s:201s"),
    (1, "lies outside the run", *WAVE, "fst", "--wave-window", "5s:5.001s"),
    (1, "never fired", *WAVE, "fst", "--wave-trigger", "fault.stroke"),
    (2, "unknown signal", *WAVE, "fst", "--wave-trigger", "x.nothing > 3"),
    (2, "did you mean x.CTRL.enable?", *WAVE, "fst", "--wave-trigger", "rise x.CTRL.enabl"),
    (2, "needs --wave", "run", "circle", "--wave-every", "1ms"),
    (2, "no such folder", "report", "OUT/none"), (2, "is not a folder", "report", "OUT/bad.csv"),
    (2, "no run in out/", "report"), (2, "is missing", "report", "OUT/empty"),
    (2, "no JSON at byte", "report", "OUT/cut_metrics"),
    (2, "does not hold 38 numbers", "report", "OUT/cut_trace"),
    (2, "does not hold 49 rules", "report", "OUT/no_rules"),
    (2, "is no key of the machine an693", *AN693, "-s", "gains.kp=1"),
    (2, "row 0: increments 142, 0", *MCAFEE, "-s", "path.row_mm=0.7", "-o", "OUT/mcafee"),
    (2, "path.radius_mm", "track", "-s", "path.radius_mm=31"),
    (2, "is not offered", *MCAFEE, "--check"), (2, "is not one of mcafee", "track", "an693-hold"),
    (2, "is no key of the machine kung", "run", "circle", "-s", "filter.kp=1"),
    (2, "is none of: drive", *AN693, "--wave", "fst", "--wave-trigger", "e ~ 3"),
    (2, "did you mean status.index?", *AN693, "--wave", "fst", "--wave-trigger",
     "rise status.idex"),
    (2, "needs a folder", "lm628", "hold", "--wave", "fst"),
    (2, "is not known before", "lm628", "hold", "--wave", "fst", "--wave-trigger", "hi", "-o",
     "OUT/lm628"),
    (2, "no report page", "report", "OUT/other"),
    (2, "did you mean LTRJ?", "lm628", "OUT/bad.lm628"),
    (2, "no such script", "lm628", "nothing"),
    (2, "is no key", "lm628", "hold", "-s", "gains.kp=1"),
    (5, "not within 0.01 s", "lm628", "OUT/late.lm628"),
    (2, "here the commands are at the port", "lm628", "hold", "-s", "filter.kp=1"),
    (2, "only runs of one machine", "report", "OUT/direct", "OUT/an693", "-o", "OUT/two.html"),
    (2, "only runs of one machine", "report", "OUT/mcafee", "OUT/an693", "-o", "OUT/two.html"),
    (2, "at most 8", "report", *["OUT/direct"] * 9, "-o", "OUT/two.html"),
    (2, "name a file", "report", "OUT/direct", "-o", "OUT/empty"),
]


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


def damage(name, file, change):
    """A copy of the first run in which one file is changed."""
    shutil.copytree(OUT / "direct", OUT / name)
    text = (OUT / name / file).read_text(encoding="utf-8")
    (OUT / name / file).write_text(change(text), encoding="utf-8")


# Every word of the shell.
WORDS = """RESET\nPORT8\nPORT12\nDFH\nSIP\nLPEI 1\nLPES 2\nSBPA -5\nSBPR 5\nMSKI 0\nRSTI 0
LFIL 0Fh 1 2 3 4\nUDF\nLTRJ 3Fh 1 2 3\nSTT\nRDSTAT\nRDSIGS\nRDIP\nRDDP\nRDRP\nRDDV\nRDRV\nRDSUM
byte c 0Ah\nwait 1 ms\nread d\nrst\nwait complete\nstatus\npins\nhelp\nhelp LFIL\nhelp RSTI
help wait\nhelp status\nhelp byte\nhelp PORT12\nquit\n"""


def write_bad_input():
    (OUT / "bad.lm628").write_text("LTRK 0\n", encoding="utf-8")
    (OUT / "late.lm628").write_text("RSTI 0\nwait hi 10 ms\n", encoding="utf-8")
    (OUT / "empty").mkdir()
    (OUT / "bad.toml").write_text("[gains\nkp = 1\n", encoding="utf-8")
    (OUT / "bad.csv").write_text("1,2\n3;4\n", encoding="utf-8")
    damage("cut_metrics", "metrics.json", lambda text: text[:400])
    damage("cut_trace", "trace.csv", lambda text: text[:2000])
    damage("no_rules", "detail.json", lambda text: json.dumps(
        json.loads(text) | {"rules": {axis: {"first": [], "last": []} for axis in "xy"}}))
    damage("other", "metrics.json", lambda text: text.replace('"kung"', '"other"', 1))


def succeeds(code, says, words):
    command = [PROGRAM, *(w.replace("OUT", str(OUT)) for w in words)]
    done = subprocess.run(command, env=ENVIRONMENT, cwd=OUT, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, errors="replace", check=False)
    line = f"trammel {' '.join(words)}: exit code {done.returncode}"
    told = [text for text in done.stderr.split("\n")[:-1] if "waves of" not in text]
    clear = says is None or (len(told) == 1 and told[0].startswith("trammel: ") and says in told[0])
    if done.returncode == code and clear and "Sanitizer" not in done.stderr:
        print(line)
        return True
    wanted = f"{code}" + (f" and one line that says `{says}`" if says else "")
    print(f"sanitize: {line}, expected {wanted}\n{done.stderr[-6000:]}", file=sys.stderr)
    return False


def program():
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    (OUT / "all.lm628").write_text(WORDS, encoding="utf-8")
    good = [succeeds(code, None, words) for code, *words in RUNS]
    if not all(good):
        return 1
    write_bad_input()
    refused = [succeeds(code, says, words) for code, says, *words in REFUSED]
    talk = subprocess.run([ROOT / "tests/testbench/lm628_prompt_check.py", PROGRAM],
                          env=ENVIRONMENT, cwd=OUT, check=False)
    return 0 if all(refused) and talk.returncode == 0 else 1


def main():
    verbs = {"build": configure_and_build, "unit": unit, "program": program}
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    if len(sys.argv) != 2 or sys.argv[1] not in verbs:
        print(f"sanitize: one of {', '.join(verbs)}; see --help", file=sys.stderr)
        return 2
    return verbs[sys.argv[1]]()


if __name__ == "__main__":
    sys.exit(main())
