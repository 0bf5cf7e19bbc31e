#!/usr/bin/env -S python3 -P
# SPDX-License-Identifier: Apache-2.0
"""Each fault that a machine offers gives the same events with the RTL, leaping and every clock,
with SystemC and with the twin, and other events than a run without it. Each fault that only other
machines offer is refused in one line, which names those that the machine has.

usage: faults_test.py PROGRAM

The runs are those of [faults.wiring] in machines/<m>/tests/runs.toml. A register is flipped in the
RTL alone: there the three wirings are compared.
"""

import functools
import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

from trammel_tools import machines  # noqa: E402

WIRINGS = {"twin": ["--engine", "twin"], "leaping": ["--platform", "direct"],
           "plain": ["--platform", "direct", "-s", "run.leap=false"],
           "systemc": ["--platform", "systemc"]}


def event_hash(program, plan, wiring, settings, folder):
    """The run's event hash, or the line that refuses it."""
    with tempfile.TemporaryDirectory(dir=folder) as out:
        command = [program, "run", plan["scenario"], "--no-report", "-o", f"{out}/run",
                   *WIRINGS[wiring]]
        for one in [*plan["settings"], *settings]:
            command += ["-s", one]
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
        if done.returncode == 2:
            return done.stderr.strip()
        if done.returncode not in (0, 5):
            return f"exit {done.returncode}: {done.stderr.strip()}"
        metrics = Path(out, "run", "metrics.json").read_text(encoding="utf-8")
        return json.loads(metrics)["run"]["event_hash"]


def judge(program, plan, kind, offered, healthy, folder):
    """Line of what went wrong, or ""."""
    settings = [f"inject.fault={kind}", *plan.get("with", {}).get(kind, [])]
    wirings = [one for one in WIRINGS if kind != "register_flip" or one != "twin"]
    found = {one: event_hash(program, plan, one, settings, folder) for one in wirings}
    if kind not in offered:
        refused = all("inject.fault: " in text and "\n" not in text
                      and text.endswith(", ".join(offered)) for text in found.values())
        return "" if refused else f"{kind}: not refused: {found}"
    if len(set(found.values())) != 1:
        return f"{kind}: {found}"
    same = healthy in found.values()
    if same != (kind in plan.get("unseen", [])):
        return f"{kind}: {'the same as' if same else 'other than'} a run without: {found}"
    return ""


def main():
    program, wrong, tried = sys.argv[1], [], 0
    offered = {one: machines.fault_kinds(program, one) for one in machines.folders()}
    names = dict.fromkeys(kind for kinds in offered.values() for kind in kinds)
    for machine in machines.folders():
        plan = machines.runs(machine).get("faults", {}).get("wiring")
        if plan is None:
            continue
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
            healthy = event_hash(program, plan, "twin", ["inject.fault=none"], folder)
            tried += len(names)
            each = functools.partial(judge, program, plan, offered=offered[machine],
                                     healthy=healthy, folder=folder)
            lines = pool.map(each, names)
            wrong += [f"{machine}: {line}" for line in lines if line]
    for line in wrong:
        print(line, file=sys.stderr)
    print(f"{tried} faults in all wirings, {len(wrong)} differ")
    return 1 if wrong or tried == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
