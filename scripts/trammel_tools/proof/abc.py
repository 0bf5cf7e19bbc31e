# SPDX-License-Identifier: Apache-2.0
"""Asks abc, which comes with Yosys: one command line a question, and bounded searches."""

import re
import subprocess
import time
from pathlib import Path

from trammel_tools.proof.properties import PropertiesError

TRIES = 1000  # conflicts for one output at one clock of the quick search
SIMULATED = 1  # [s] of random inputs
QUICK = 2  # [s] for all of the quick search


def ask(folder, commands, limit):
    """What abc says; nothing when it takes longer than the limit [s]."""
    import pyosys  # it brings abc along
    program = Path(pyosys.__file__).parent / "yosys-abc"
    try:
        done = subprocess.run([program, "-c", commands], cwd=folder, capture_output=True,
                              text=True, check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return ""
    text = done.stdout + done.stderr
    if "cmd error" in text or "Cannot open" in text:
        raise PropertiesError(f"abc: {text.strip().splitlines()[-1]}")
    return text


def risen(text):
    """{output: clock at which it rises} from what bmc3 -a or sim3 -a says."""
    found = re.findall(r"Output +(\d+) was asserted in frame +(\d+)", text)
    return {int(output): int(clock) for output, clock in found}


def searched(text):
    """The clocks that a bounded search has behind it, from what bmc3 says."""
    found = re.search(r"(?:asserted in|after) +(\d+) frames", text)
    return int(found[1]) if found else 0


def base(folder, name, clocks, limit):
    """({output: clock at which it rises}, whether all of the first clocks were searched)."""
    text = ask(folder, f"read_aiger {name}.aig; bmc3 -a -F {clocks} -T {limit}", limit + 30)
    return risen(text), searched(text) >= clocks and "timed out" not in text


def reach(folder, name, labels, frames, limit, begin=0):
    """({label: clock, not before begin, at which its output of name.aig rises}, clocks searched)"""
    text = ask(folder, f"read_aiger {name}.aig; bmc3 -a -S {begin} -F {frames} -T {limit}",
               limit + 30)
    return {labels[n]: clock for n, clock in risen(text).items()}, searched(text)


def random(folder, name, frames):
    """{output: clock} of the outputs that random inputs make rise."""
    return risen(ask(folder, f"read_aiger {name}.aig; sim3 -a -F {frames} -T {SIMULATED}", 30))


def first(folder, name, output, frames, limit, *more):
    """The first clock at which one output of name.aig rises, as far as the search gets."""
    text = ask(folder, f"read_aiger {name}.aig; cone -O {output}; scleanup; "
                       f"bmc3 -F {frames} -T {limit} {' '.join(more)}", limit + 30)
    found = re.search(r"was asserted in frame +(\d+)", text)
    return int(found[1]) if found else None


def quick(folder, name, outputs, frames):
    """{output: clock} of what random inputs, or a search that gives up early, make rise.

    Seconds: what is wrong mostly shows so. The search takes `outputs` one by one, since the cone of
    one is small; random inputs are tried for all.
    """
    end = time.monotonic() + QUICK
    found = random(folder, name, frames)
    for output in outputs:
        if time.monotonic() < end:
            most = found.get(output, frames - 1) + 1
            clock = first(folder, name, output, most, 1, f"-C {TRIES}")
            if clock is not None:
                found[output] = clock
    return found
