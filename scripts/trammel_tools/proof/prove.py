# SPDX-License-Identifier: Apache-2.0
"""Prove the promises of RTL blocks: rtl/<layer>/<block>_props.sv.

usage: trammel prove [--limit SECONDS] [layer/block ...]   without blocks: every one
       trammel prove --leap [--broken] [--limit SECONDS] [chips/chip ...]
       trammel prove --table [--check]    write, or only check, docs/generated/assertions.md

For each block: every assertion holds in every reachable state under any input (induction, then
pdr), every cover is reachable (bounded search), and every negative control, another value of a
named signal, refutes the promises it names. A properties file is bound to its block and holds

  label : assert (...);          a promise; inv_... only helps the proof
  reaches_... : cover (...);     must be reachable
  // breaks label: net = expr    a control, which must refute the promise: readers of this net of
                                 the block see the expression; in it the net has its old value;
                                 `breaks label (module): ...` changes another module
  // breaks label: reg <= expr   the same for what a register loads; `next` is its old input
  // breaks label: Name = expr   the same for a parameter or localparam
  // breaks label: old => new    only where no name will do: a text that occurs once
  // prove: cut MODULE           instances of MODULE are taken out, their outputs are free
  // prove: free $mul            cells of this type are taken out
  // prove: set Name=value ...   a configuration; each such line is proven, controls use the first
  // prove: depth N              of the induction in clocks, default 4
  // prove: frames N             of the search for covers and refutations, default 100
  // prove: from N               the search for refutations leaves out the clocks before N
  // prove: leap label ...       assertions on which the leap of a chip may rest

--leap proves the lemmas of docs/leap.md for every chip that leaps; --broken asks them of the broken
designs in rtl/chips/<chip>_leap.toml, each of which must be refuted.

Exit codes: 0 all proven, 1 a promise or lemma is open, refuted or without control, 2 no such block,
3 a tool is missing. Logs and models stay in build/formal/<block>.
"""

import sys

from trammel_tools import python_tools
from trammel_tools.proof import assertion_table, leap, leap_model, properties
from trammel_tools.proof.block_proof import BlockProof


def prove(block, limit):
    """Lines of what went wrong, which it also prints."""
    wrong = []
    try:
        proof = BlockProof(block, limit)
        wrong = proof.wrong
        proof.run()
    except properties.PropertiesError as error:
        wrong.append(str(error))
    for line in wrong:
        print(f"prove: {block}: {line}", file=sys.stderr)
    return wrong


def main():
    parser = python_tools.Parser(prog="trammel prove", description=__doc__)
    parser.add_argument("--limit", type=int, default=60, metavar="SECONDS",
                        help="for one question to the solver, default 60")
    parser.add_argument("--leap", action="store_true", help="prove the lemmas of chips that leap")
    parser.add_argument("--broken", action="store_true",
                        help="with --leap: refute the broken designs")
    parser.add_argument("--table", action="store_true", help="write docs/generated/assertions.md")
    parser.add_argument("--check", action="store_true",
                        help="with --table: only compare; exit 1 if stale")
    parser.add_argument("blocks", nargs="*", metavar="layer/block", help="default: all")
    arguments = parser.parse_args()
    if arguments.check and not arguments.table:
        parser.error("--check belongs to --table")
    if arguments.broken and not arguments.leap:
        parser.error("--broken belongs to --leap")
    every = leap_model.chips() if arguments.leap else properties.blocks()
    for block in arguments.blocks:
        if block not in every:
            what = "no chip that leaps" if arguments.leap else f"rtl/{block}_props.sv: no such file"
            return python_tools.refuse("prove", f"{block}: {what}; there are {', '.join(every)}")
    if arguments.table:
        return assertion_table.run(arguments.check)
    python_tools.need("pyosys", "prove")
    if arguments.leap:
        return leap.run(arguments.blocks or every, arguments.broken, arguments.limit)
    bad = 0
    for block in arguments.blocks or every:
        bad += bool(prove(block, arguments.limit))
    return 1 if bad else 0
