#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove the promises of RTL blocks: rtl/<layer>/<block>_props.sv.

usage: prove.py [--limit SECONDS] [layer/block ...]   without blocks: every one

For each block: every assertion holds in every reachable state under any input (abc pdr), every
cover is reachable (bounded search), and every negative control, a changed text of the RTL, refutes
the promises it names. A properties file is bound to its block and holds

  label : assert (...);          a promise; inv_... only helps the proof
  label : cover (...);           must be reachable
  // breaks label: old => new    a control: this change of the block's text must refute the promise;
                                 `breaks label (module): ...` changes another module's text
  // prove: cut MODULE           instances of MODULE are taken out, their outputs are free
  // prove: free $mul            cells of this type are taken out
  // prove: set Name=value       a parameter of the block
  // prove: frames N             depth of the bounded search, default 100

Exit codes: 0 all proven, 1 a promise is open, refuted or without control, 2 no such block,
3 a tool is missing. Logs and models stay in build/formal/<block>.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import formal  # noqa: E402
import python_tools  # noqa: E402

OUT = formal.ROOT / "build" / "formal"


def prove(block, limit):
    """Lines of what went wrong; prints a line a promise."""
    clock = formal.stopwatch()
    props = formal.read_properties(block)
    folder = OUT / block.replace("/", "_")
    folder.mkdir(parents=True, exist_ok=True)
    wrong = []

    order = formal.write_asserts(props, folder, "asserts")
    if sorted(order) != sorted(props.asserts):
        raise formal.FormalError(f"rtl/{block}_props.sv: not all assertions arrived: {order}")
    state = dict.fromkeys(order, formal.prove_all(folder, "asserts", len(order), limit))
    if set(state.values()) != {"proven"}:
        for index, label in enumerate(order):
            state[label] = formal.prove_one(folder, "asserts", index, limit)
    controlled = check_controls(props, folder, limit, wrong)
    for label in props.asserts:
        if state[label] != "proven":
            wrong.append(f"{label}: {state[label]}")
        if label in props.promises and label not in controlled:
            wrong.append(f"{label}: no negative control (// breaks {label}: old => new)")
    check_covers(props, folder, limit, wrong)
    for label in props.promises:
        print(f"  {label:<44} {state[label]}, {controlled.count(label)} control(s)")
    print(f"{block}: {len(props.promises)} promises, {len(props.controls)} controls, "
          f"{len(props.covers)} covers in {clock():.1f} s")
    return wrong


def check_controls(props, folder, limit, wrong):
    """Labels that some control refuted, once for each."""
    refuted = []
    for number, control in enumerate(props.controls):
        name = f"control{number}"
        order = formal.write_asserts(props, folder, name,
                                     formal.mutate_text(control, folder, number))
        for label in control.promises:
            index = order.index(label)
            if formal.reach(folder, name, index, props.frames, limit) is not None or \
                    formal.prove_one(folder, name, index, limit) == "refuted":
                refuted.append(label)
            else:
                wrong.append(f"{label}: line {control.line}: the control "
                             f"'{control.old} => {control.new}' does not refute it")
    return refuted


def check_covers(props, folder, limit, wrong):
    if not props.covers:
        return
    order = formal.write_covers(props, folder, "covers")
    for index, label in enumerate(order):
        at = formal.reach(folder, "covers", index, props.frames, limit)
        if at is None:
            wrong.append(f"{label}: not reached within {props.frames} clocks")
        else:
            print(f"  {label:<44} reached at clock {at}")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=int, default=120, metavar="SECONDS")
    parser.add_argument("blocks", nargs="*", metavar="layer/block")
    arguments = parser.parse_args()
    every = sorted(f"{p.parent.name}/{p.stem.removesuffix('_props')}"
                   for p in formal.RTL.glob("*/*_props.sv"))
    for block in arguments.blocks:
        if block not in every:
            print(f"prove: rtl/{block}_props.sv: no such file; there are {', '.join(every)}",
                  file=sys.stderr)
            return 2
    python_tools.need("pyosys", "prove")
    bad = 0
    for block in arguments.blocks or every:
        try:
            wrong = prove(block, arguments.limit)
        except formal.FormalError as error:
            wrong = [str(error)]
        for line in wrong:
            print(f"prove: {block}: {line}", file=sys.stderr)
        bad += bool(wrong)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
