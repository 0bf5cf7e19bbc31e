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

LEFT_OUT = ("over_budget", "board", "design", "top")  # follow from the sources


def path_of(on):
    return RTL / "boards" / on.name / f"{on.chip}.placed.json"


def digest(top, folder):
    """Of what nextpnr reads: ports and cells by name with what they are connected to. Attributes,
    which name source files, are not in it."""
    module = synth_flow.read_netlist(top, folder)[1]["modules"][top]
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
    path_of(on).write_text(lines(record) + "\n", encoding="utf-8")


def put(on, folder, result):
    """Puts a placement on record; that the same netlist ran beside its RTL stays there."""
    record = {"netlist": digest(on.top, folder)}
    record |= {key: value for key, value in result.items() if key not in LEFT_OUT}
    old = read(on) or {}
    if old.get("loop", {}).get("netlist") == record["netlist"]:
        record["loop"] = old["loop"]
    write(on, record)


def put_loop(on, folder, loop):
    """Adds a run in closed loop; False where that netlist is not the one on record."""
    record = read(on)
    if record is None or record["netlist"] != digest(on.top, folder):
        return False
    record["loop"] = {"netlist": record["netlist"], **loop}
    write(on, record)
    return True


def result_of(on, record):
    """What the placement reported, as `synth_board.run` gives it."""
    return {"board": on.name, "design": f"chips/{on.chip}", "top": on.top, **record}


def findings(on, folder, budget, comparison, page):
    """Lines of what does not hold any more, of a netlist that was mapped into the folder."""
    record, name = read(on), path_of(on).relative_to(ROOT)
    again = f"run trammel synth {on.chip} --board {on.name} --docs"
    if record is None:
        yield f"there is no {name}; {again}"
        return
    if record["netlist"] != digest(on.top, folder):
        yield f"the netlist is not the one of {name}: {again}"
        return
    tools = synth_flow.versions()
    if record["tools"] != tools or record["device"] != on.device.name:
        yield f"{name} is of {record['device']}, {record['tools']}, not {on.device.name}, " \
              f"{tools}: {again}"
    result = result_of(on, record)
    yield from synth_board.findings(result, budget)
    if synth_board.fill(page, result, on, budget, comparison) != page:
        yield f"docs/synthesis.md does not say what {name} does: {again}"
    if record.get("loop", {}).get("netlist") != record["netlist"] and on.memory:
        yield f"{name}: this netlist has not run beside its RTL: run scripts/tool netlist --record"
