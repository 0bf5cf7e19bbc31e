# SPDX-License-Identifier: Apache-2.0
"""A jump of the precision controller's command: the law of docs/precision.md, section 4, alone.

In double precision, with the limits of its words but no rounding, against a mass with friction
whose current is ideal but for two ticks, its lag and its limit. What it does here is the law's and
not that of the integers, the inverter or the encoder.
"""

import itertools
import math
from dataclasses import dataclass

TICK = 62.5e-6  # [s]
DELAY = 2  # [ticks] until a current is there, which then lags
LAG = 0.19e-3 / TICK
COUNT = 5e-6  # [m]
FORCE_CONSTANT = 79.9  # [N/A]
MOST_A = 4.8
COULOMB, VISCOUS = 3.0, 20.0  # [N], [N s/m]
LEAD = 6
ACCEL = 0.125  # [count/tick^2]: 24 bits of 2^-26
SPEED = 8.0  # [count/tick]: 24 bits of 2^-20
PLACE = 2048.0  # [count]: 20 bits of 2^-8, 24 bits of 2^-12


def clip(value, most):
    return max(-most, min(most, value))


def gains(w1, zeta, w2, w3):
    """L1, L2, L3, K1, K2 of section 5."""
    z, y = math.exp(-w2 * TICK), math.exp(-w3 * TICK)
    l1 = 1 - z * z * y
    l2 = 3 - 2 * l1 - z * z - 2 * z * y
    return l1, l2, 3 - 2 * z - y - l1 - l2, (w1 * TICK)**2, 2 * zeta * w1 * TICK


def changes_of_side(values, band):
    """How often values change their sign, those within the band left out."""
    beyond = [x > 0 for x in values if abs(x) > band]
    return sum(a != b for a, b in itertools.pairwise(beyond))


class Spline:
    """Items 1 and 2, of control points [count]; a knot every 32 ticks."""

    def __init__(self):
        self.last = [0.0, 0.0, 0.0]
        self.p = self.v = self.a = self.j = 0.0

    def tick(self, point=None):
        if point is not None:
            c1, c2, c3 = self.last
            self.j = (point - 3 * c1 + 3 * c2 - c3) / 32**3
            self.last = [point, c1, c2]
        self.a += self.j
        self.v += self.a
        self.p += self.v


class Law:
    """Items 4 to 12, with the mass known; returns the current asked for [A]."""

    def __init__(self, mass, poles):
        self.l1, self.l2, self.l3, self.k1, self.k2 = gains(*poles)
        self.per_a = mass * COUNT / TICK**2 / FORCE_CONSTANT  # [A per count/tick^2]
        self.e1 = self.e2 = self.d = self.u1 = self.u2 = self.um = 0.0

    def tick(self, command, place):
        e = clip(command.p - place, PLACE)
        aff = clip(command.a + LEAD * command.j, ACCEL)
        vff = clip(command.v + LEAD * command.a, 512)
        n = clip(e - self.e1, PLACE)
        self.e1 = clip(self.e1 + self.l1 * n, PLACE)
        self.e2 = clip(self.e2 + self.l2 * n, SPEED)
        self.d = clip(self.d + self.l3 * n, ACCEL)
        acc = clip(self.k1 * self.e1 + self.k2 * self.e2 + self.d, ACCEL)
        asked = (self.per_a * clip(acc + aff, ACCEL) +
                 (VISCOUS * vff * COUNT / TICK + COULOMB * clip(16 * vff, 1)) / FORCE_CONSTANT)
        current = clip(asked, MOST_A)
        used = clip(acc - (asked - current) / self.per_a, ACCEL)
        self.um += (self.u2 - self.um) / 4
        self.u2, self.u1 = self.u1, used
        self.e2 = clip(self.e2 + self.d - self.um, SPEED)
        self.e1 = clip(self.e1 + self.e2, PLACE)
        return current


class Mass:
    """A slide behind a current that is late and lags; position in counts."""

    def __init__(self, mass):
        self.mass, self.late = mass, [0.0] * DELAY
        self.place = self.speed = self.current = 0.0  # [m], [m/s], [A]

    def tick(self, current):
        self.late.append(current)
        self.current += (self.late.pop(0) - self.current) * (1 - math.exp(-1 / LAG))
        force = FORCE_CONSTANT * self.current - VISCOUS * self.speed
        if abs(self.speed) < 1e-4 and abs(force) < COULOMB:
            self.speed = 0.0
        else:
            against = self.speed if abs(self.speed) > 1e-4 else force
            self.speed += (force - math.copysign(COULOMB, against)) / self.mass * TICK
        self.place += self.speed * TICK
        return self.place / COUNT


@dataclass
class Step:
    swings: int  # times past the end, by more than 10 um
    settled_s: float  # to 10 um, from the knot of the jump on
    beyond_m: float  # the farthest


def step(mass, poles=(300, 0.7, 4000, 400), length=0.01, seconds=0.6):
    """What a command that jumps makes of the mass [kg]."""
    command, law, slide = Spline(), Law(mass, poles), Mass(mass)
    place, off = 0.0, []
    jump = [0.0, 0.0, 1.0, 1.0]  # points, of which the second and third are pre-filtered
    points = iter([b - (a - 2 * b + c) / 6 for a, b, c in zip(jump, jump[1:], jump[2:])])
    for tick in range(round(seconds / TICK)):
        command.tick(length / COUNT * next(points, 1.0) if tick % 32 == 0 else None)
        place = slide.tick(law.tick(command, place))
        if tick >= 128 and tick % 8 == 0:  # behind the spline, every sample of the trace
            off.append((tick * TICK - 32 * TICK, place * COUNT - length))
    return Step(changes_of_side((x for _, x in off), 1e-5),
                max((t for t, x in off if abs(x) > 1e-5), default=0.0), max(x for _, x in off))
