# SPDX-License-Identifier: Apache-2.0
"""The campaign of faults, for trammel verify --faults.

Each fault of [faults.campaign] in machines/<m>/tests/runs.toml is injected at three times of a
short run: at rest, in acceleration, at constant speed. A run with the machine's monitors says what
noticed it, a run without them what else would have come of it. Both are judged by the plant's
truth: a fault is dangerous when the carriage leaves the place where it is in the run without a
fault by more than `limit`, hits a stop, or a phase current passes its peak rating.
"""

import csv
import itertools
import json
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from trammel_tools import machines
from trammel_tools.check import engines
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "generated" / "faults.md"
PATIENCE = 300  # [s] for one run
SHARE = 0.95  # of the dangerous ones that are noticed
EVERY = 11  # faults between two of the reduced campaign


@dataclass
class Outcome:
    """What became of a fault at one time."""

    fault: str
    time: str
    by: str = ""
    after_s: float = 0
    off_s: float | None = None  # from its detection
    stopping: float = 0
    consequences: list = field(default_factory=list)  # without monitors
    error: str = ""

    @property
    def dangerous(self):
        return bool(self.consequences)


def expand(group):
    """(name, settings) of each fault of a group: every combination of its lists."""
    keys = [key for key in ("axis", "line", "value", "bit") if key in group]
    for chosen in itertools.product(*[group[key] for key in keys]):
        settings = [f"inject.fault={group['fault']}", *group.get("settings", [])]
        settings += [f"inject.{key}={value}" for key, value in zip(keys, chosen)]
        words = [group["fault"]]
        for key, value in zip(keys, chosen):
            names = group.get(f"{key}_names", {})
            words.append(str(names.get(str(value), f"{key} {value}")))
        yield ", ".join(words), settings


def waypoints(plan, folder):
    """The settings of a path through points at times, one each interval."""
    if "waypoints" not in plan:
        return []
    way, lines, k = plan["waypoints"], [], 0
    for n in range(round(way[-1][0] / plan["interval_s"]) + 1):
        t = n * plan["interval_s"]
        while k + 2 < len(way) and t > way[k + 1][0]:
            k += 1
        share = min(1, (t - way[k][0]) / (way[k + 1][0] - way[k][0]))
        lines.append(",".join(f"{1e3 * (a + share * (b - a)):.4f}"
                              for a, b in zip(way[k][1:], way[k + 1][1:])))
    path = Path(folder) / "waypoints.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return [f"path.points_file={path}"]


def run(plan, settings, out):
    """(metrics, true positions by sample), or an error text."""
    engine = "rtl" if any("register_flip" in one for one in settings) else "twin"
    command = [engines.PROGRAM, "run", plan["scenario"], "--engine", engine, "--platform",
               "direct", "--no-report", "-o", out]
    for one in settings:
        command += ["-s", one]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False,
                              timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return f"does not end within {PATIENCE} s"
    if done.returncode not in (0, 5):
        return f"exit {done.returncode}: {done.stderr.strip()}"
    metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
    with (out / "trace.csv").open(encoding="utf-8") as lines:
        rows = [(float(row["t_s"]), *[float(row[name]) * plan["scale"]
                                      for name in plan["columns"]])
                for row in csv.DictReader(lines)]
    for path in out.iterdir():
        path.unlink()
    return metrics, rows


def farthest(rows, healthy):
    """Largest distance of an axis from where it is without the fault, at the same sample."""
    return max((abs(a - b) for one, other in zip(rows, healthy)
                for a, b in zip(one[1:], other[1:])), default=0)


def consequences(plan, metrics, rows, healthy):
    """What of it is dangerous, by the plant's truth."""
    unit, injected, found = plan["unit"], metrics["injected"], []
    # A table that was stopped is not where it would have been: only its way up to there counts.
    if injected["off_after_s"] is not None:
        stopped = injected["begin_s"] + injected["off_after_s"]
        rows = [row for row in rows if row[0] < stopped]
    far = farthest(rows, healthy)
    if far > plan["limit"]:
        found.append(f"{far:.3g} {unit} off")
    if injected["peak_A"] > plan["peak_A"]:
        found.append(f"{injected['peak_A']:.3g} A")
    if injected["at_stop"]:
        found.append("at a stop")
    return found


def judge(plan, healthy, more, folder, one):
    """Outcome of a fault at a time."""
    (name, settings), (time, begin) = one
    outcome = Outcome(name, time)
    at = [*plan["settings"], *more, f"inject.begin_s={begin}", *settings]
    with tempfile.TemporaryDirectory(dir=folder) as place:
        seen = run(plan, [*at, *plan.get("monitors", [])], Path(place) / "seen")
        blind = run(plan, [*at, *plan.get("blind", [])], Path(place) / "blind")
    for result in (seen, blind):
        if isinstance(result, str):
            outcome.error = result
            return outcome
    injected = seen[0]["injected"]
    outcome.by = injected["detected_by"]
    if outcome.by:
        outcome.after_s = injected["detected_after_s"]
        outcome.stopping = injected["stopping"]
        if injected["off_after_s"] is not None:
            outcome.off_s = injected["off_after_s"] - outcome.after_s
    outcome.consequences = consequences(plan, *blind, healthy) or \
        consequences(plan, *seen, healthy)
    return outcome


def campaign(machine, short, folder):
    """(plan, outcomes) of a machine; None without a campaign."""
    plan = machines.runs(machine).get("faults", {}).get("campaign")
    if plan is None:
        return None, []
    more = waypoints(plan, folder)
    base = run(plan, [*plan["settings"], *more, *plan.get("monitors", [])],
               Path(folder) / "healthy")
    if isinstance(base, str):
        raise machines.MachineError(f"{machine}: the run without a fault: {base}")
    metrics, healthy = base
    if metrics["end"] != "done":
        raise machines.MachineError(f"{machine}: the run without a fault: {metrics['verdict']}")
    faults = [fault for group in plan["fault"] for fault in expand(group)]
    tried = list(itertools.product(faults, plan["times"].items()))
    if short:
        tried = tried[::EVERY]
    with ThreadPoolExecutor(2) as pool:
        outcomes = list(pool.map(lambda one: judge(plan, healthy, more, folder, one), tried))
    return plan, outcomes


def text(plan, outcome):
    """One cell of the table."""
    unit = plan["unit"]
    if outcome.error:
        return outcome.error
    harm = "; ".join(outcome.consequences)
    if not outcome.by:
        return f"**not noticed: {harm}**" if harm else "not noticed, harmless"
    off = "" if outcome.off_s is None else f", off {1e6 * outcome.off_s:.0f} us later"
    return (f"{outcome.by}, {1e3 * outcome.after_s:.3g} ms{off}, stops in "
            f"{outcome.stopping:.2g} {unit}" + (f" (else {harm})" if harm else ""))


def problems(machine, plan, outcomes):
    """Lines of what is not as promised."""
    wrong = [f"{machine}: {one.fault}, {one.time}: {one.error}" for one in outcomes if one.error]
    counted = tuple(plan.get("counted", []))  # noticed, but no reason to turn anything off
    for one in outcomes:
        if one.by.startswith(counted):  # of an empty tuple: none does
            continue
        if one.by and (one.off_s is None or one.off_s > plan["off_s"]):
            wrong.append(f"{machine}: {one.fault}, {one.time}: noticed ({one.by}), but the drives "
                         f"are not off within {1e6 * plan['off_s']:.0f} us")
    dangerous = [one for one in outcomes if one.dangerous]
    missed = [one for one in dangerous if not one.by]
    # Few cases of the reduced campaign: one is no share.
    if len(missed) > max(1, (1 - plan.get("share", SHARE)) * len(dangerous)):
        wrong += [f"{machine}: {one.fault}, {one.time}: {text(plan, one)}" for one in missed]
        wrong.append(f"{machine}: {len(missed)} of {len(dangerous)} dangerous faults are not "
                     f"noticed: at most {1 - plan.get('share', SHARE):.0%}")
    return wrong


def summary(plan, outcomes):
    dangerous = [one for one in outcomes if one.dangerous]
    noticed = [one for one in dangerous if one.by]
    share = len(noticed) / len(dangerous) if dangerous else 1
    faults = len({one.fault for one in outcomes})
    return (f"{faults} faults at {len(plan['times'])} times: {len(dangerous)} of {len(outcomes)} "
            f"cases dangerous, {len(noticed)} of these noticed ({share:.1%})")


def section(machine, plan, outcomes):
    times = list(plan["times"])
    lines = [f"## {machine}", "", plan["about"], "", summary(plan, outcomes) + ".", "",
             "| fault | " + " | ".join(times) + " |", "|---" * (len(times) + 1) + "|"]
    by_fault = {}
    for one in outcomes:
        by_fault.setdefault(one.fault, {})[one.time] = text(plan, one)
    lines += [f"| {name} | " + " | ".join(cells[time] for time in times) + " |"
              for name, cells in by_fault.items()]
    met = {one.by for one in outcomes if one.by}
    lines += ["", "| what notices | met by |", "|---|---|"]
    for by in sorted(met):
        known = [where for start, where in plan["met_by"].items() if by.startswith(start)]
        if not known:
            raise machines.MachineError(f"{machine}: [faults.campaign.met_by] lacks \"{by}\"")
        lines.append(f"| {by} | {known[0]} |")
    return "\n".join(lines) + "\n"


HEAD = """<!-- Generated by trammel verify --faults --page: do not edit. -->

# What notices which fault

Each fault ([faults.md](../faults.md)) at rest, in acceleration and at constant speed: what noticed
it, after how long, how much later all outputs were off, how far the carriage then went; in brackets
what would have come of it without the monitors that can be turned off. In bold: dangerous and not
noticed. Dangerous is, by the plant's truth, a carriage that leaves by more than the limit the place
where it is in a run without the fault, that hits a stop, or a phase current above the peak rating.
"""


def check(short=False, page=False):
    """Prints the figures of each machine; returns lines of what went wrong."""
    if not engines.PROGRAM.exists():
        raise engines.EngineError("the program is missing: trammel list builds it")
    wrong, sections = [], []
    for machine in machines.folders():
        with tempfile.TemporaryDirectory() as folder:
            plan, outcomes = campaign(machine, short, folder)
        if plan is None:
            continue
        for one in outcomes:
            print(f"{machine}: {one.fault}, {one.time}: {text(plan, one)}", flush=True)
        print(f"{machine}: {summary(plan, outcomes)}", flush=True)
        wrong += problems(machine, plan, outcomes)
        if page:
            sections.append(section(machine, plan, outcomes))
    if page:
        PAGE.write_text("\n".join([HEAD, *sections]), encoding="utf-8")
        print(f"wrote {PAGE.relative_to(ROOT)}")
    return wrong
