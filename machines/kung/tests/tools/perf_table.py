# SPDX-License-Identifier: Apache-2.0
"""The result of trammel perf: medians, ratios, the machine; as a document and as tables."""

import os
import platform
import statistics
import subprocess
import sys

import perf_rows
from perf_rows import NotHere
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "performance.md"
RATIOS = ("b/a", "c/a", "d/a", "d/c", "d/w", "e/a", "e/c", "e/d")


def cpu_name():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.partition(":")[2].strip() for line in file if line.startswith("model name")]
    return names[0] if names else platform.machine()


def machine():
    """What the figures were measured on; the load is that of all its users."""
    verilator = subprocess.run(["verilator", "--version"], capture_output=True, text=True,
                               check=False).stdout.split()[:2]
    return {"cpu": cpu_name(), "cores": os.cpu_count(),
            "load": [round(value, 1) for value in os.getloadavg()],
            "verilator": " ".join(verilator[1:])}


def machine_line(where):
    return (f"{where['cpu']}, {where['cores']} cores, load {where['load'][0]} to "
            f"{where['load'][2]}, Verilator {where['verilator']}")


def rate(run):
    return run.clocks / run.cpu_s


def ratio(found, one, other):
    """Median over the rounds of clocks per CPU second, one row against the other."""
    pairs = zip(found.get(one) or [], found.get(other) or [])
    values = [rate(first) / rate(second) for first, second in pairs]
    return statistics.median(values) if values else None


def row_of(row, result, want, found):
    entry = {"row": row, "name": perf_rows.NAMES[row]}
    if not isinstance(result, list):
        state = str(result) if isinstance(result, NotHere) else f"error: {result}"
        return entry | {"state": state}
    hashes = {run.event_hash for run in result}
    middle = {key: statistics.median(getattr(run, key) for run in result)
              for key in ("cpu_s", "wall_s", "peak_kib")}
    clocks = result[0].clocks
    simulated_s = clocks / 50e6
    return entry | {
        "state": "ok" if hashes == {want} else "error: its events differ",
        "event_hash": result[0].event_hash, "clocks": clocks, "evaluated": result[0].evaluated,
        "simulated_s": simulated_s, **middle,
        "clocks_per_s": statistics.median(rate(run) for run in result),
        "real_time_factor": statistics.median(simulated_s / run.cpu_s for run in result),
        "clocks_per_wall_s": statistics.median(run.clocks / run.wall_s for run in result),
        "ratio": ratio(found, row, "a")}


def document(found, want, wanted):
    measured = {row: result for row, result in found.items() if isinstance(result, list)}
    rows = [row_of(row, result, want.get(row), measured) for row, result in found.items()]
    ratios = {name: ratio(measured, *name.split("/")) for name in RATIOS}
    return {"workload": "circle", "seconds": wanted.seconds, "rounds": wanted.repeat,
            "machine": machine(), "rows": rows,
            "ratios": {name: value for name, value in ratios.items() if value is not None},
            "errors": [f"row {row['row']}: {row['state'].removeprefix('error: ')}"
                       for row in rows if row["state"].startswith("error")]}


def shown(value, form):
    return "" if value is None else format(value, form)


def per_s(value):
    return f"{value / 1e6:.2f} M" if value >= 1e5 else f"{value / 1e3:.1f} k"


def text(result):
    lines = ["| row | | clocks/s | real-time factor | ratio to a | memory | events |",
             "|---|---|---|---|---|---|---|"]
    for row in result["rows"]:
        name = f"| {row['row']} | {row['name']} |"
        if row["state"] != "ok":
            lines.append(f"{name} {row['state']} | | | | |")
            continue
        lines.append(f"{name} {per_s(row['clocks_per_s'])} | {row['real_time_factor']:.3g} | "
                     f"{shown(row['ratio'], '.3g')} | {row['peak_kib'] / 1024:.0f} MiB | "
                     f"`{row['event_hash'][:8]}` |")
    lines += ["", "Ratios: " + ", ".join(f"{name} {value:.3g}"
                                         for name, value in result["ratios"].items()) + ".",
              f"{result['seconds']} s simulated, medians of {result['rounds']} rounds on "
              f"{machine_line(result['machine'])}."]
    return "\n".join(lines)


def write(table, name):
    page = PAGE.read_text(encoding="utf-8")
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
    before, rest = page.split(begin)
    PAGE.write_text(f"{before}{begin}{table}\n{end}{rest.split(end)[1]}", encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}", file=sys.stderr)
