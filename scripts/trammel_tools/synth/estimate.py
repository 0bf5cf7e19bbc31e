# SPDX-License-Identifier: Apache-2.0
"""Estimates of the area on FPGAs for which no open tool places: cells that Yosys maps to.

They are not placed, no vendor's tool has seen them, and a vendor's tool packs otherwise.
"""

import collections
import dataclasses
import json
import re
from pathlib import Path

from trammel_tools.synth import synth_flow


@dataclasses.dataclass(frozen=True)
class Family:
    name: str
    command: str
    kinds: dict  # what is counted: expression of the cells' types


FAMILIES = (
    Family("Xilinx 7 series", "synth_xilinx -family xc7 -flatten -noiopad -noclkbuf",
           {"LUT": r"LUT[1-6]", "FF": r"FD[RSCP]E", "DSP48": r"DSP48E1", "RAMB18": r"RAMB18E1",
            "RAMB36": r"RAMB36E1", "carry of 4 bits": r"CARRY4"}),
    Family("Intel Cyclone V", "synth_intel_alm -family cyclonev -noiopad -noclkbuf",
           {"ALUT": r"MISTRAL_(ALUT[2-6]|ALUT_ARITH|NOT|BUF)", "FF": r"MISTRAL_FF",
            "multiplier": r"MISTRAL_MUL\d+X\d+", "M10K": r"MISTRAL_M10K",
            "MLAB": r"MISTRAL_MLAB"}),
)


def one(top, folder, family):
    """{what: cells} of a top on one family."""
    stem = re.sub(r"\W+", "_", family.name).lower()
    target = Path(folder) / f"{top}.{stem}.json"
    target.unlink(missing_ok=True)
    log = target.with_suffix(".log")
    try:
        with synth_flow.read_design(top, log) as (_, run):
            run(f"{family.command} -top {top}")
            run(f"write_json {target}")
    except RuntimeError as error:
        raise synth_flow.FlowError(f"{family.name}: Yosys: {error}: see {log}") from error
    if not target.exists():
        raise synth_flow.FlowError(f"Yosys gave no netlist of {top} for {family.name}: see {log}")
    cells = json.loads(target.read_text(encoding="utf-8"))["modules"][top]["cells"].values()
    kinds = collections.Counter(cell["type"] for cell in cells)
    return {what: sum(n for kind, n in kinds.items() if re.fullmatch(form, kind))
            for what, form in family.kinds.items()}


def lines(result):
    for family, counts in result.items():
        shown = ", ".join(f"{n} {what}" for what, n in counts.items() if n)
        yield f"estimate, not placed: {family}: {shown}"
