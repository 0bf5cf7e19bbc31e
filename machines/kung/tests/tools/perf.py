# SPDX-License-Identifier: Apache-2.0
"""Measure clocks per second: one workload in every wiring, side by side, with equal events.

The circle on two axes, 0.25 simulated seconds of 50 MHz, in rows:
  a  the --sc model of Verilator with sc_clock, every pin a signal: what the ratios refer to
  b  the --cc model, activated by SystemC once a clock
  c  look-ahead, every clock evaluated (run.leap=false)
  w  look-ahead, leaping, all clock domains evaluated (run.domains=false)
  d  look-ahead, leaping, domains that are awake: what `trammel run` does
  e  the twin engine (run.engine=twin)
  f  Icarus Verilog on a netlist written by Yosys, recorded inputs of 1 ms replayed
  g  cocotb on the Verilator of .venv, the same inputs

Rows run in turn, each in its own process. Clocks per second, real-time factor and ratio are those
of CPU time, medians over the rounds, so that other load on the machine matters little; --json has
wall time too. A row whose event hash differs from the others' is an error.

Exit codes: 0 all rows that ran agree, 1 a row failed or its events differ, 2 usage, or there is no
build, 130 interrupted.
"""

import json
import sys

import perf_machines
import perf_rows
import perf_scaling
import perf_table
from perf_replay import Replay
from perf_rows import Failed, NotHere
from trammel_tools import python_tools


def arguments():
    parser = python_tools.Parser(prog="trammel perf", description=__doc__)
    parser.add_argument("--rows", default="a,b,c,w,d,e,f,g", metavar="a,b,...", help="default all")
    parser.add_argument("--repeat", type=int, default=3, metavar="N", help="rounds, default 3")
    parser.add_argument("--seconds", type=float, default=0.25, metavar="S",
                        help="simulated by rows a to e, default 0.25")
    parser.add_argument("--scaling", action="store_true",
                        help="cost against simulated time, encoder speed and waves instead")
    parser.add_argument("--machines", action="store_true",
                        help="scenarios of every machine, by domain, as a whole and twin, instead")
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    parser.add_argument("--docs", action="store_true",
                        help="write the tables into docs/performance.md")
    parser.add_argument("--check", action="store_true",
                        help="exit 1 also when leaping is not faster than evaluating every clock")
    wanted = parser.parse_args()
    wanted.rows = wanted.rows.replace(" ", "").split(",")
    unknown = [row for row in wanted.rows if row not in perf_rows.NAMES]
    if unknown:
        parser.error(f"--rows {','.join(unknown)}: rows are {', '.join(perf_rows.NAMES)}")
    if wanted.repeat < 1:
        parser.error(f"--repeat {wanted.repeat}: at least 1")
    if not 0.001 <= wanted.seconds <= 60:
        parser.error(f"--seconds {wanted.seconds}: 0.001 to 60")
    return wanted


def rounds(wanted):
    """Row -> list of measurements, or the reason why there is none."""
    replay = Replay()
    found = {row: [] for row in wanted.rows}
    for number in range(wanted.repeat):
        for row in wanted.rows:
            if not isinstance(found[row], list):
                continue
            python_tools.progress(f"round {number + 1} of {wanted.repeat}, row {row}")
            try:
                found[row].append(replay.run(row) if row in perf_rows.REPLAYED
                                  else perf_rows.run_row(row, wanted.seconds))
            except (NotHere, Failed) as reason:
                found[row] = reason
    python_tools.progress("")
    return found, replay


def expected(found, replay):
    """Row -> event hash that it should have: that of the first row with its workload."""
    simulated = [r[0].event_hash for row, r in found.items()
                 if row not in perf_rows.REPLAYED and isinstance(r, list)]
    return {row: replay.reference() if row in perf_rows.REPLAYED else simulated[0]
            for row, r in found.items() if isinstance(r, list)}


def compare(wanted):
    found, replay = rounds(wanted)
    result = perf_table.document(found, expected(found, replay), wanted)
    if wanted.check and not result["ratios"].get("d/c", 2) > 1:
        result["errors"].append("leaping is not faster than evaluating every clock")
    return result, perf_table.text(result)


def tables(wanted):
    """Another measurement than the rows: module, and place on the page."""
    return ((perf_scaling, "scaling") if wanted.scaling else
            (perf_machines, "machines") if wanted.machines else (None, "rows"))


def measure(module):
    result = module.document(python_tools.progress)
    python_tools.progress("")
    return result, module.text(result)


def main():
    wanted = arguments()
    if not (perf_rows.BUILD / "build.ninja").exists():
        print("perf: there is no build: `trammel run circle` makes it", file=sys.stderr)
        return 2
    try:
        python_tools.progress("building")
        module, place = tables(wanted)
        perf_rows.build(["d"] if module else wanted.rows)
        result, table = measure(module) if module else compare(wanted)
    except Failed as error:
        python_tools.progress("")
        print(f"perf: {error}", file=sys.stderr)
        return 1
    print(json.dumps(result, indent=2) if wanted.json else table)
    if wanted.docs:
        perf_table.write(table, place)
    for line in result.get("errors", []):
        print(f"perf: {line}", file=sys.stderr)
    return 1 if result.get("errors") else 0
