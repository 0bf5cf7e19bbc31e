# SPDX-License-Identifier: Apache-2.0
"""The placement on record of a chip on a board: rtl/boards/<board>/<chip>.placed.json.

Placing takes a quarter of an hour, and the same netlist, tools and seed give the same placement. So
the record holds what `trammel synth --board --docs` reported, with a digest of the netlist it
placed, and `--check` maps the sources again and compares: where the digest is the same, the record
is what another placement would report. `scripts/tool netlist --record` adds the digest of the
netlist that ran beside the RTL.
"""

import hashlib
import json

from trammel_tools.paths import ROOT, RTL
from trammel_tools.synth import synth_board, synth_flow


def path_of(on):
    return RTL / "boards" / on.name / f"{on.chip}.placed.json"


def digest(top, folder):
    """Of what nextpnr reads: ports and cells by name with what they are connected to. Attributes,
    which name source files, are not in it."""
    module = synth_flow.read_mapped(top, folder)["modules"][top]
    cells = {name: [cell["type"], cell["parameters"], cell["connections"]]
             for name, cell in module["cells"].items()}
    return hashlib.sha256(json.dumps([module["ports"], cells]).encode()).hexdigest()


def read(on):
    """The record, or None."""
    path = path_of(on)
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def lines(table, indent=" "):
    """A JSON object with a member a line, and so for the members of its members."""
    def one(value):
        nested = isinstance(value, dict) and len(indent) < 2 and value
        return lines(value, indent + " ") if nested else json.dumps(value)
    members = ",\n".join(f"{indent}{json.dumps(key)}: {one(value)}" for key, value in table.items())
    return f"{{\n{members}\n{indent[1:]}}}"


def write(on, record):
    synth_flow.write_whole(path_of(on), lines(record) + "\n")


def put(on, folder, result):
    """Puts a placement on record; that the same netlist ran beside its RTL stays there."""
    record = {"netlist": digest(on.top, folder), **result}
    del record["over_budget"]  # follows from the sources
    old = read(on) or {}
    if old.get("loop", {}).get("netlist") == record["netlist"]:
        record["loop"] = old["loop"]
    write(on, record)


def put_loop(on, loop):
    """Adds a run in closed loop of the netlist on record."""
    record = read(on)
    record["loop"] = {"netlist": record["netlist"], **loop}
    write(on, record)


def about(on):
    """The record or None, the name of its file, and how it is made again."""
    return (read(on), path_of(on).relative_to(ROOT),
            f"run trammel synth {on.chip} --board {on.name} --docs")


def other(on, folder):
    """A line if the netlist that was mapped into the folder is not the one on record."""
    record, name, again = about(on)
    if record is None:
        return f"there is no {name}; {again}"
    if record["netlist"] != digest(on.top, folder):
        return f"the netlist is not the one of {name}: {again}"
    return None


def findings(on, folder, page):
    """Lines of what does not hold any more, of a netlist that was mapped into the folder."""
    if line := other(on, folder):
        yield line
        return
    record, name, again = about(on)
    tools = synth_flow.versions()
    if record["tools"] != tools or record["device"] != on.device.name:
        yield f"{name} is of {record['device']}, {record['tools']}, not {on.device.name}, " \
              f"{tools}: {again}"
    budget, comparison = synth_board.budget_of(on)
    yield from synth_board.findings(record, budget)
    if synth_board.fill(page, record, on, budget, comparison) != page:
        yield f"docs/synthesis.md does not say what {name} does: {again}"
    if record.get("loop", {}).get("netlist") != record["netlist"] and on.memory:
        yield f"{name}: this netlist has not run beside its RTL: run scripts/tool netlist --record"
