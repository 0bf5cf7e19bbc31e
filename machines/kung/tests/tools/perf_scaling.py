# SPDX-License-Identifier: Apache-2.0
"""Scaling of a leaping run: cost against simulated time, encoder speed and waves."""

import statistics

import perf_rows
import perf_table

TIMES_S = (0.25, 1, 4, 15, 60)
SPEEDS_M_S = (0, 0.5, 1, 2, 4)
SPEED_S = 0.1
WAVES_S = 0.25
ROUNDS = 3
WAVE_ROUNDS = 15  # their ratios are small, and each takes a second
WINDOW = ("run.wave=fst", "run.wave_begin_s=0.002", "run.wave_end_s=0.002125")
WAVES = {"none": (), "one window of 125 us": WINDOW,
         "125 us in every 10 ms": (*WINDOW, "run.wave_every_s=0.01")}


def entry(runs, **what):
    simulated_s = runs[0].clocks / 50e6
    cpu_s = statistics.median(run.cpu_s for run in runs)
    return {**what, "simulated_s": simulated_s, "cpu_s": cpu_s,
            "cpu_s_per_s": cpu_s / simulated_s, "evaluated": runs[0].evaluated / runs[0].clocks,
            "peak_kib": statistics.median(run.peak_kib for run in runs),
            "record_kib": runs[0].record_kib}


def document(progress):
    times, speeds, waves = [], [], []
    for seconds in TIMES_S:
        progress(f"{seconds} s simulated")
        times.append(entry([perf_rows.run_row("d", seconds, "path.repeats=60")]))
    for speed in SPEEDS_M_S:
        progress(f"encoders at {speed} m/s")
        runs = [perf_rows.run_program("perf_rows", "speed", f"speed={speed}",
                                      f"run.max_s={SPEED_S}") for _ in range(ROUNDS)]
        speeds.append(entry(runs, speed_m_s=speed))
    progress("waves")
    perf_rows.OUT.mkdir(parents=True, exist_ok=True)
    file = f"waves={perf_rows.OUT / 'waves.fst'}"
    rounds = [{name: perf_rows.run_row("d", WAVES_S, *keys, file) for name, keys in WAVES.items()}
              for _ in range(WAVE_ROUNDS)]
    for name in WAVES:
        ratio = statistics.median(r[name].cpu_s / r["none"].cpu_s for r in rounds)
        waves.append(entry([r[name] for r in rounds], waves=name, ratio=ratio))
    hashes = {run.event_hash for r in rounds for run in r.values()}
    errors = [] if len(hashes) == 1 else ["the events of a run with waves differ"]
    return {"machine": perf_table.machine(), "time": times, "speed": speeds, "waves": waves,
            "errors": errors}


def mib(kib):
    return f"{kib / 1024:.1f} MiB"


def text(result):
    lines = ["| simulated | CPU time per simulated second | peak memory "
             "| the 2 kHz record, on the disk |", "|---|---|---|---|"]
    lines += [f"| {row['simulated_s']:g} s | {row['cpu_s_per_s']:.2f} s | "
              f"{mib(row['peak_kib'])} | {mib(row['record_kib'])} |" for row in result["time"]]
    lines += ["", "| encoders, both axes | clocks evaluated | CPU time per simulated second |",
              "|---|---|---|"]
    lines += [f"| {row['speed_m_s']:g} m/s | {100 * row['evaluated']:.1f} % | "
              f"{row['cpu_s_per_s']:.2f} s |" for row in result["speed"]]
    lines += ["", "| waves (FST) | CPU time against none | peak memory |", "|---|---|---|"]
    lines += [f"| {row['waves']} | {row['ratio']:.2f} | {mib(row['peak_kib'])} |"
              for row in result["waves"]]
    return "\n".join([*lines, "", f"Measured on {perf_table.machine_line(result['machine'])}."])
