# SPDX-License-Identifier: Apache-2.0
"""Margins of the precision controller's loop, from the gain words of docs/precision.md.

The law of section 4 without rounding, limits and feed-forward, in counts and ticks, and the plant
of the specification's section 5: a mass whose current is two ticks late and lags by 0.19 ms, held
for a tick; with a mode, a share of that mass is on a spring and a damper beside the encoder.
"""

import math
import re
from dataclasses import dataclass

import numpy as np

from precision_step import DELAY, LAG, TICK
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "precision.md"


@dataclass
class Margins:
    crossover_rad_s: float
    phase_deg: float
    up_dB: float
    down_dB: float
    sensitivity: float  # Ms


def law(words):
    """(A, B, C, D) from the error [count] to the acceleration [count per tick^2]."""
    l1, l2, l3, k1, k2 = (mant / 2048 * 2.0**exp for mant, exp in words)
    e1, e2, d, um, u1, u2, e = np.eye(7)  # each as what it was before the tick
    n = e - e1
    e1, e2, d = e1 + l1 * n, e2 + l2 * n, d + l3 * n
    acc = k1 * e1 + k2 * e2 + d
    um, u2, u1 = um + (u2 - um) / 4, u1, acc
    e2 = e2 + d - um
    e1 = e1 + e2
    made, asked = np.array([e1, e2, d, um, u1, u2]), acc
    if l3 == 0:  # no disturbance is observed: it remains 0
        made, asked = np.delete(np.delete(made, 2, 0), 2, 1), np.delete(acc, 2)
    return made[:, :-1], made[:, -1], asked[:-1], asked[-1]


def held(a, b):
    """The step of x' = a x + b u by a tick with u held."""
    size = len(b)
    step = np.zeros((size + 1, size + 1))
    step[:size, :size], step[:size, size] = a / 4096, b / 4096
    whole = np.eye(size + 1)
    for order in range(8, 0, -1):
        whole = np.eye(size + 1) + step @ whole / order
    for _ in range(12):
        whole = whole @ whole
    return whole[:size, :size], whole[:size, size]


def plant(mode_Hz=0.0, ratio=0.2, damping=0.02):
    """(A, B, C) from the acceleration that is asked to the position, with delay, lag and mode."""
    w = 2 * math.pi * mode_Hz * TICK
    # Position and speed of what the encoder rides on, those of the rest, the lagging acceleration.
    a = np.zeros((5, 5))
    a[0, 1] = a[2, 3] = 1
    a[1, 4], a[4, 4] = 1 / (1 - ratio if mode_Hz else 1), -1 / LAG
    if mode_Hz:
        share = 1 - ratio  # the free resonance is above that of the part that is held
        spring, damper = share * w * w, 2 * damping * share * w
        pull = np.array([-spring, -damper, spring, damper, 0])
        a[1] += ratio / share * pull
        a[3] -= pull
    step, input_ = held(a, np.array([0, 0, 0, 0, 1 / LAG]))
    size = 5 + DELAY
    whole, into = np.zeros((size, size)), np.zeros(size)
    whole[:5, :5], whole[:5, 5] = step, input_
    whole[5, 6], into[6] = 1, 1
    if not mode_Hz:  # there is no second mass
        keep = [0, 1, 4, 5, 6]
        whole, into = whole[np.ix_(keep, keep)], into[keep]
    out = np.zeros(len(into))
    out[0] = 1
    return whole, into, out


def stable(controller, table, gain):
    a, b, c, d = controller
    p, q, r = table
    closed = np.block([[p - gain * d * np.outer(q, r), gain * np.outer(q, c)],
                       [-np.outer(b, r), a]])
    return bool(np.max(np.abs(np.linalg.eigvals(closed))) < 1)


def last_stable(controller, table, far):
    """The factor of the gain, towards `far`, at which the loop is lost [dB]; infinite: none."""
    if stable(controller, table, far):
        return math.copysign(math.inf, math.log(far))
    good, bad = 0.0, math.log(far)
    for _ in range(24):
        middle = (good + bad) / 2
        if stable(controller, table, math.exp(middle)):
            good = middle
        else:
            bad = middle
    return 20 * good / math.log(10)


def gain_margins(words, mode_Hz=0.0):
    """(up, down) [dB], or None: it is not stable as it is."""
    controller, table = law(words), plant(mode_Hz)
    if not stable(controller, table, 1):
        return None
    return last_stable(controller, table, 1e3), last_stable(controller, table, 1e-3)


def response(a, b, c, z):
    states = np.linalg.solve(z[:, None, None] * np.eye(len(b)) - a,
                             np.tile(b[:, None], (len(z), 1, 1)))
    return states[:, :, 0] @ c


def margins(words):
    w = np.exp(np.linspace(math.log(10), math.log(3e4), 4000))  # [rad/s]
    z = np.exp(1j * w * TICK)
    a, b, c, d = law(words)
    loop = (response(a, b, c, z) + d) * response(*plant(), z)
    at = int(np.flatnonzero(np.abs(loop) > 1)[-1])
    up, down = gain_margins(words)
    # Between the two frequencies where it crosses.
    above, below = np.log(np.abs(loop[at:at + 2]))
    crossover = w[at] * (w[at + 1] / w[at]) ** (above / (above - below))
    return Margins(float(crossover), math.degrees(np.angle(-loop[at])), up, down,
                   float(np.max(np.abs(1 / (1 + loop)))))


def sets():
    """{name: (poles, words)} of section 5's table."""
    found = {}
    for name, poles, words in re.findall(
            r"^\| (full|soft) \| ([\d., ]+) \|((?: -?\d+, -?\d+ \|){5})",
            PAGE.read_text(encoding="utf-8"), re.M):
        pairs = re.findall(r"(-?\d+), (-?\d+)", words)
        found[name] = ([float(one) for one in poles.split(",")],
                       [(int(mant), int(exp)) for mant, exp in pairs])
    return found


def printed():
    """{name: Margins} of the table of margins on the page."""
    number = r"(-?[\d.]+|none)"
    row = rf"^\| (full|soft) \| {number} \| {number} \| {number} \| {number} \| {number} \|$"
    return {name: Margins(*(-math.inf if one == "none" else float(one) for one in values))
            for name, *values in re.findall(row, PAGE.read_text(encoding="utf-8"), re.M)}
