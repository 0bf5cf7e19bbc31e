# SPDX-License-Identifier: Apache-2.0
"""Whole runs of this machine for scripts/tool sanitize, good and bad input."""

import json
import shutil
from pathlib import Path

# A few points, so that start-up, service routine and every output of a run are there.
LINE = ("-s", "path.kind=line", "-s", "path.line_end_x_m=0.1005", "-s", "path.line_end_y_m=0.1003",
        "-s", "path.line_ticks=10", "-s", "run.platform=direct", "-s", "run.reached_m=1")
SHORT = ("run", "circle", *LINE)
TWIN = ("--engine", "twin")
WAVE = (*SHORT, "-o", "OUT/waves", "--wave")
STEP = ("run", "step", "-s", "path.square_half_samples=20", "-s", "path.square_periods=2",
        "-s", "run.reached_m=1")
TRIP = ("-s", "inject.fault=trip_pin", "-s", "inject.begin_s=0.01")
JUMP = ("-s", "inject.fault=encoder_jump", "-s", "inject.begin_s=0.01")
HUNG = ("-s", "inject.fault=processor_hung", "-s", "inject.begin_s=0.01")
WATCHDOG = (*HUNG, "-s", "chip.watchdog_ticks=5")
CORE = (*SHORT, "--cpu", "rtl", "-o", "OUT/core")
COMMANDS = Path(__file__).parent / "soc" / "commands.txt"
FOLDER = "OUT/direct"
RUNS = [
    (0, *SHORT, "-o", FOLDER, "--wave", "fst", "--wave-window", "20ms:20.1ms"),
    (0, *SHORT, "--platform", "systemc", "-o", "OUT/systemc", "--json"),
    # FST without SystemC: the writer maps its file where stacks of SystemC's coroutines were, which
    # the sanitizer of GCC 12 still takes for such.
    (0, *WAVE, "vcd", "--wave-trigger", "drives", "--wave-window", "0:10us", "-s", "controller=fc",
     "--platform", "systemc"),
    (0, *WAVE, "fst", "--wave-trigger", "x.e > 0 after 1ms", "--wave-every", "10ms",
     "--wave-window", "0:10us"),
    (0, *WAVE, "fst", "--wave-trigger", "at 1ms", "--wave-window", "0:10us"),
    (0, *STEP, "-o", "OUT/step"),
    (0, *SHORT, "-o", "OUT/asserted", "--assert", "-s", "run.leap=false"),
    (0, "run", "step", *TWIN, "-o", "OUT/whole_step"),
    (0, "run", "--all", *LINE, "--json", "-o", "OUT/all"),
    (5, *SHORT, "--platform", "systemc", "-o", "OUT/tripped", *TRIP),
    (5, *SHORT, "-o", "OUT/encoder", *JUMP),
    (5, *SHORT, "--platform", "systemc", "-o", "OUT/watchdog", *WATCHDOG),
    (5, *SHORT, "-o", "OUT/short", "-s", "run.max_s=0.005"),
    (0, *SHORT, "-o", "OUT/audited", "--audit"), (0, *SHORT, "-o", "OUT/activity", "--activity"),
    (0, *SHORT, *TWIN, "-o", "OUT/activity", "--activity"),
    (0, *SHORT, "-o", "OUT/twin", *TWIN, "-s", "gains.interpolate=true"),
    (0, *STEP, "-o", "OUT/twin_step", *TWIN),
    (5, *SHORT, "-o", "OUT/twin_tripped", *TWIN, *TRIP),
    (5, *SHORT, "-o", "OUT/twin_encoder", *TWIN, *JUMP),
    (5, *SHORT, "-o", "OUT/twin_watchdog", *TWIN, *WATCHDOG),
    # The precision controller: laps that it learns, a program, start values that swing, limits.
    (0, "run", "circle", *TWIN, "-o", "OUT/laps", "-s", "controller=precision", "-s",
     "path.circle_radius_m=0.002", "-s", "path.repeats=2", "-s", "precision.learn=true"),
    (5, *SHORT, *TWIN, "-o", "OUT/swings", "-s", "controller=precision", "-s",
     "precision.mass_kg=500"),
    (2, "precision.learn", *SHORT, "-o", "OUT/none", "-s", "controller=precision", "-s",
     "precision.learn=true"),
    (0, "report", FOLDER, "OUT/systemc", "-o", "OUT/two.html"),
    (0, "report", "OUT/step", "--json"),
    (0, "report", FOLDER, FOLDER, "-o", "OUT/two.html"),
    (0, "run", "OUT/step/run.toml", "-o", "OUT/again", "-s", "name=a < b & c"),
    # Gains for the motor, a DC link that sags and rises, a rating that is passed, settling.
    (0, *SHORT, *TWIN, "-o", "OUT/drive", "-s", "gains.by_rule=true", "-s", "plant.x.supply_ohm=1",
     "-s", "plant.y.supply_ohm=1", "-s", "plant.x.continuous_current_A=0.001",
     "-s", "plant.x.peak_current_A=0.002", "-s", "run.settle_s=0.02"),
    # Frequency responses; a table that is nowhere near its model, or its path.
    (0, "run", "response", *TWIN, "-s", "path.sweep_tones=3", "-s", "path.sweep_first_ticks=100",
     "-s", "path.sweep_dwell_ticks=20", "-o", "OUT/response"),
    (0, "run", "response-current", *TWIN, "-s", "path.sweep_tones=3", "-o", "OUT/currents"),
    (5, "run", "response", *TWIN, "-s", "run.max_s=0.1", "-o", "OUT/cut_response"),
    (5, *SHORT, *TWIN, "-o", "OUT/diverged", "-s", "run.diverged_m=1e-4",
     "-s", "plant.x.load_N=300"),
    (5, *SHORT, *TWIN, "-o", "OUT/far", "-s", "chip.following_error_m=1e-5",
     "-s", "plant.load_N=40"),
    (5, *SHORT, *TWIN, "-o", "OUT/d_current", "-s", "chip.d_current_A=0.006",
     "-s", "plant.current_offset_a_A=0.3"),
    # A gain that rounds up to the next power of two, and one below the least exponent.
    (0, *SHORT, "-s", "gains.kp=0.99999", "-s", "gains.ki=1e-6",
     "-s", "chip.d_current_A=0.3", "-o", "OUT/gains"),
    # The processor's RTL, with its serial port, and with an illegal instruction.
    (0, *CORE), (0, *CORE, "--audit", "-s", f"run.uart={COMMANDS}"),
    (0, *CORE, "-s", "run.uart=pty"), (5, *CORE, *HUNG),
]
REFUSED = [
    (2, "takes no scenario", "run", "--all", "circle"),
    (2, "loop/x: Too many levels", "run", "circle", "-o", "OUT/loop/x"),
    (2, "--all sets controller itself", "run", "--all", "-s", "controller=fc"),
    (2, "has an expected value", *SHORT, "--check", "-o", "OUT/checked"),
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
    (2, "is outside the run", *WAVE, "fst", "--wave-window", "200s:201s"),
    (1, "lies outside the run", *WAVE, "fst", "--wave-window", "5s:5.001s"),
    (1, "never fired", *WAVE, "fst", "--wave-trigger", "fault.stroke"),
    (2, "unknown signal", *WAVE, "fst", "--wave-trigger", "x.nothing > 3"),
    (2, "did you mean x.CTRL.enable?", *WAVE, "fst", "--wave-trigger", "rise x.CTRL.enabl"),
    (2, "needs --wave", "run", "circle", "--wave-every", "1ms"),
    (2, "no JSON at byte", "report", "OUT/cut_metrics"),
    (2, "does not hold 38 numbers", "report", "OUT/cut_trace"),
    (2, "does not hold 49 rules", "report", "OUT/no_rules"),
    (3, "this program has one machine only", "report", "OUT/other"),
    (2, "there is no such file", *CORE, "-s", "run.uart=OUT/none"),
    (2, "need run.cpu", *CORE, "-s", "inject.fault=bus_stall"),
    (2, "unknown key", "run", "circle", "-s", "filter.kp=1"),
]
REFUSED_BY_ALL = [
    (2, "which this trammel does not have", "report", "OUT/other"),
    (2, "not a key of the machine kung", "run", "circle", "-s", "filter.kp=1"),
]


def damage(out, name, file, change):
    """A copy of the first run in which one file is changed."""
    shutil.copytree(out / "direct", out / name)
    text = (out / name / file).read_text(encoding="utf-8")
    (out / name / file).write_text(change(text), encoding="utf-8")


def write_bad_input(out):
    """After the runs, before what is refused."""
    (out / "loop").symlink_to("loop")
    damage(out, "cut_metrics", "metrics.json", lambda text: text[:400])
    damage(out, "cut_trace", "trace.csv", lambda text: text[:2000])
    damage(out, "no_rules", "detail.json", lambda text: json.dumps(
        json.loads(text) | {"rules": {axis: {"first": [], "last": []} for axis in "xy"}}))
    damage(out, "other", "metrics.json", lambda text: text.replace('"kung"', '"other"', 1))
