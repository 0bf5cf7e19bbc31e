# SPDX-License-Identifier: Apache-2.0
"""Scenarios of every machine: the RTL by clock domain, the RTL as a whole, the twin."""

import json
import os
import resource
import statistics
import subprocess

import perf_rows
import perf_table

WAYS = {"whole": ("run.domains=false",), "domains": (), "twin": ("run.engine=twin",)}
MOST_S = 1  # simulated
ROUNDS = 3


def scenarios():
    """Built-in ones, of all machines; not those that run many times."""
    command = [perf_rows.BUILD / "testbench" / "trammel", "list", "scenarios"]
    listed = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    names = [line.split()[0] for line in listed.splitlines() if line.strip()]
    return [name for name in names if not name.startswith("response")]


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def measure(scenario, way):
    """Clocks, CPU time of the whole program, event hash and awake share by domain."""
    out = perf_rows.OUT / f"{scenario}-{way}"
    command = [perf_rows.BUILD / "testbench" / "trammel", "run", scenario, "--no-report",
               "--platform", "direct", "-o", out, "-s", f"run.max_s={MOST_S}"]
    command += [word for key in WAYS[way] for word in ("-s", key)]
    begin = cpu_s()
    # Without gnuplot, whose pictures are not of interest here.
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          env=os.environ | {"PATH": os.devnull})
    used = cpu_s() - begin
    # 5: it would take longer than MOST_S.
    if done.returncode not in (0, 1, 5) or not (out / "metrics.json").exists():
        raise perf_rows.Failed(f"{scenario}: exit code {done.returncode}: {done.stderr[-500:]}")
    run = json.loads((out / "metrics.json").read_text(encoding="utf-8"))["run"]
    return {"clocks": run["clocks"], "cpu_s": used, "event_hash": run["event_hash"]}


def document(progress):
    rows, errors = [], []
    for scenario in scenarios():
        runs = {way: [] for way in WAYS}
        for number in range(ROUNDS):
            for way in WAYS:
                progress(f"{scenario}, round {number + 1} of {ROUNDS}, {way}")
                runs[way].append(measure(scenario, way))
        if len({run["event_hash"] for each in runs.values() for run in each}) != 1:
            errors.append(f"{scenario}: events differ")
        rows.append({"scenario": scenario, "clocks": runs["domains"][0]["clocks"]} | {
            way: statistics.median(run["cpu_s"] for run in each) for way, each in runs.items()})
    return {"machine": perf_table.machine(), "scenarios": rows, "errors": errors}


def text(result):
    lines = ["| scenario | clocks | RTL, all domains | RTL, domains that are awake | faster by "
             "| twin |", "|---|---:|---:|---:|---:|---:|"]
    lines += [f"| {row['scenario']} | {row['clocks'] / 1e6:.1f} M | {row['whole']:.2f} s | "
              f"{row['domains']:.2f} s | {row['whole'] / row['domains']:.1f} | "
              f"{row['twin']:.2f} s |"
              for row in result["scenarios"]]
    return "\n".join([*lines, "", f"CPU time of the whole program, medians of {ROUNDS} rounds on "
                                  f"{perf_table.machine_line(result['machine'])}."])
