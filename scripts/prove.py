#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove the promises of RTL blocks: rtl/<layer>/<block>_props.sv.

usage: prove.py [--limit SECONDS] [layer/block ...]   without blocks: every one
       prove.py --leap [--broken] [--limit SECONDS] [chips/chip ...]
       prove.py --table [--check]    write, or only check, docs/generated/promises.md

For each block: every assertion holds in every reachable state under any input (induction, then
pdr), every cover is reachable (bounded search), and every negative control, a changed text of the
RTL, refutes the promises it names. A properties file is bound to its block and holds

  label : assert (...);          a promise; inv_... only helps the proof
  reaches_... : cover (...);     must be reachable
  // breaks label: old => new    a control: this change of the block's text must refute the promise;
                                 `breaks label (module): ...` changes another module's text
  // prove: cut MODULE           instances of MODULE are taken out, their outputs are free
  // prove: free $mul            cells of this type are taken out
  // prove: set Name=value ...   a configuration; each such line is proven, controls use the first
  // prove: depth N              of the induction in clocks, default 4
  // prove: frames N             of the search for covers and refutations, default 100
  // prove: from N               the search for refutations leaves out the clocks before N
  // prove: leap label ...       assertions on which the leap of a chip may rest

--leap asks of every chip that leaps the lemmas of docs/leap.md; --broken asks them of the broken
designs in rtl/chips/<chip>_leap.toml, and each must be refuted.

Exit codes: 0 all proven, 1 a promise or lemma is open, refuted or without control, 2 no such block,
3 a tool is missing. Logs and models stay in build/formal/<block>.
"""

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import formal  # noqa: E402
import leap  # noqa: E402
import leap_model  # noqa: E402
import promise_table  # noqa: E402
import properties  # noqa: E402
import python_tools  # noqa: E402

OUT = properties.ROOT / "build" / "formal"


def prove(block, limit):
    """Lines of what went wrong; prints a line a promise."""
    begin = time.monotonic()
    props = properties.read(block)
    folder = OUT / block.replace("/", "_")
    folder.mkdir(parents=True, exist_ok=True)
    configurations = props.configurations or [[]]
    first = configurations[0]
    proofs = [formal.Model(f"asserts{n}", props.asserts, c) for n, c in enumerate(configurations)]
    covers = [formal.Model("covers", props.covers, first)] if props.covers else []
    controls = [formal.Model(f"control{n}", c.promises, first, dict([c.file]))
                for n, c in enumerate(props.controls)]
    order = formal.write_models(props, folder, [*proofs, *covers, *controls])

    wrong = []
    state = dict.fromkeys(props.asserts, "proven")
    for model in proofs:
        if sorted(order[model.name]) != sorted(props.asserts):
            raise properties.PropertiesError(
                f"rtl/{block}_props.sv: not all assertions arrived: {order[model.name]}")
        verdicts = formal.prove(folder, model.name, order[model.name], props.depth, limit)
        for label, verdict in verdicts.items():
            if verdict != "proven":
                state[label] = verdict
                wrong.append(f"{label}: {verdict} {' '.join(model.parameters)}".rstrip())
    controlled = []
    for model, control in zip(controls, props.controls):
        controlled += control.promises
        reached = formal.reach(folder, model.name, order[model.name], props.frames, limit,
                               props.begin)
        for label in control.promises:
            if label not in reached:
                wrong.append(f"{label}: line {control.line}: the control '{control.old} => "
                             f"{control.new}' does not refute it in {props.frames} clocks")
    wrong += [f"{label}: no negative control (// breaks {label}: old => new)"
              for label in props.promises if label not in controlled]
    for model in covers:
        reached = formal.reach(folder, model.name, order[model.name], props.frames, limit)
        for label in props.covers:
            print(f"  {label:<44} reached at clock {reached.get(label)}")
            if label not in reached:
                wrong.append(f"{label}: not reached within {props.frames} clocks")
    for label in props.promises:
        print(f"  {label:<44} {state[label]}, {controlled.count(label)} control(s)")
    print(f"{block}: {len(props.promises)} promises, {len(props.controls)} controls, "
          f"{len(props.covers)} covers in {time.monotonic() - begin:.1f} s")
    return wrong


def main():
    parser = python_tools.Parser(prog="trammel prove", description=__doc__)
    parser.add_argument("--limit", type=int, default=60, metavar="SECONDS",
                        help="for one question to the solver, default 60")
    parser.add_argument("--leap", action="store_true")
    parser.add_argument("--broken", action="store_true")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("blocks", nargs="*", metavar="layer/block")
    arguments = parser.parse_args()
    if arguments.check and not arguments.table:
        parser.error("--check belongs to --table")
    if arguments.broken and not arguments.leap:
        parser.error("--broken belongs to --leap")
    every = leap_model.chips() if arguments.leap else properties.blocks()
    for block in arguments.blocks:
        if block not in every:
            what = "no chip that leaps" if arguments.leap else f"rtl/{block}_props.sv: no such file"
            print(f"prove: {block}: {what}; there are {', '.join(every)}", file=sys.stderr)
            return 2
    if arguments.table:
        return promise_table.run(arguments.check)
    python_tools.need("pyosys", "prove")
    if arguments.leap:
        return leap.run(arguments.blocks or every, arguments.broken, arguments.limit)
    bad = 0
    for block in arguments.blocks or every:
        try:
            wrong = prove(block, arguments.limit)
        except properties.PropertiesError as error:
            wrong = [str(error)]
        for line in wrong:
            print(f"prove: {block}: {line}", file=sys.stderr)
        bad += bool(wrong)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
