# SPDX-License-Identifier: Apache-2.0
"""What is searched: a study in TOML."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from pathlib import Path
from typing import NamedTuple

from trammel import _core
from trammel.run_settings import _apply, _given
from trammel.sweep.plan import PlanError, drawn_axis, read_toml

MOST_CASES = 1000
OVER = {"max": max, "mean": lambda values: sum(values) / len(values), "min": min}
DISTANCES = {"rms": lambda values: math.sqrt(sum(v * v for v in values) / len(values)),
             "max": max, "mean": OVER["mean"]}
TOP = {"scenario", "engine", "seed", "trials", "keys", "cases", "search", "objective",
       "constraint"}


class StudyError(PlanError):
    """What is wrong with a study, in one line."""


class Target(NamedTuple):
    """A value that a figure of some of the cases is to have; at a distance of 1 it misses by
    `within`."""

    figure: str
    value: float
    within: float
    cases: tuple[int, ...]


class Distance(NamedTuple):
    """How far the cases are from targets, to be small."""

    over: str
    targets: tuple[Target, ...]
    maximize = False

    def value(self, rows: list[dict]) -> float:
        return DISTANCES[self.over]([abs(rows[n][one.figure] - one.value) / one.within
                                     for one in self.targets for n in one.cases])

    def reached(self, rows: list[dict]) -> list[float]:
        """The figure of each target; the mean of its cases."""
        return [OVER["mean"]([rows[n][one.figure] for n in one.cases]) for one in self.targets]

    def missing(self, rows: list[dict]) -> list[str]:
        return [one.figure for one in self.targets
                if any(rows[n].get(one.figure) is None for n in one.cases)]

    @property
    def name(self) -> str:
        return f"{self.over} distance from {sum(len(one.cases) for one in self.targets)} targets"


class Goal(NamedTuple):
    """A figure over all cases: to be small or large, or to stay within limits."""

    figure: str
    over: str
    maximize: bool = False
    at_least: float = -math.inf
    at_most: float = math.inf

    def value(self, rows: list[dict]) -> float:
        return OVER[self.over]([row[self.figure] for row in rows])

    def missing(self, rows: list[dict]) -> list[str]:
        return [self.figure] if any(row.get(self.figure) is None for row in rows) else []

    def outside(self, rows: list[dict]) -> list[float]:
        """By how much the limits are missed; what is not above 0 is within."""
        value = self.value(rows)
        found = [self.at_least - value] if self.at_least > -math.inf else []
        return found + ([value - self.at_most] if self.at_most < math.inf else [])

    @property
    def limits(self) -> list[float]:
        return [x for x in (self.at_least, self.at_most) if math.isfinite(x)]

    @property
    def name(self) -> str:
        return f"{self.over} {self.figure}"


class Study:
    """Keys that are searched, the cases that each trial runs, and what judges them."""

    def __init__(self, file: Path):
        self.file = Path(file)
        given = read_toml(self.file, StudyError)
        unknown = sorted(set(given) - TOP)
        if unknown:
            self.refuse(f"{unknown[0]}: unknown; a study has {', '.join(sorted(TOP))}")
        self.scenario = given.get("scenario", "circle")
        if not isinstance(self.scenario, str):
            self.refuse("scenario: expects a name or a file")
        self.engine = given.get("engine", "twin")
        self.seed = self.whole(given, "seed", 1, 0)
        self.trials = self.whole(given, "trials", 100, 1)
        self.keys = self.table(given, "keys")
        self.cases = self.cases_of(self.table(given, "cases"))
        self.search = {}
        for key, value in self.table(given, "search").items():
            self.search[key] = self.axis(key, value)
        if not self.search:
            self.refuse("search: names no key")
        self.objectives = self.goals(given, "objective")
        self.constraints = self.goals(given, "constraint")
        if not self.objectives:
            self.refuse("names no [[objective]]")
        self.check()

    def refuse(self, text: str):
        raise StudyError(f"{self.file}: {text}")

    def whole(self, given: dict, name: str, default: int, least: int) -> int:
        value = given.get(name, default)
        if type(value) is not int or not least <= value <= 10**6:
            self.refuse(f"{name}: must be {least}..1000000")
        return value

    def table(self, given: dict, name: str) -> dict:
        value = given.get(name, {})
        if not isinstance(value, dict):
            self.refuse(f"{name}: expects a table")
        return value

    def cases_of(self, given: dict) -> list[tuple[str, dict]]:
        """(scenario, values) of each case: every combination of the lists."""
        for key, values in given.items():
            if not isinstance(values, list) or not values:
                self.refuse(f"cases: {key}: expects a list of values")
            if key == "scenario" and not all(isinstance(value, str) for value in values):
                self.refuse("cases: scenario: expects a list of names or files")
            if key in self.keys:
                self.refuse(f"cases: {key}: given twice")
        count = math.prod(len(values) for values in given.values())
        if count > MOST_CASES:
            self.refuse(f"cases: {count} of them, more than {MOST_CASES}")
        found = []
        for values in itertools.product(*given.values()):
            case = dict(zip(given, values))
            found.append((case.pop("scenario", self.scenario), case))
        return found

    def axis(self, key: str, value):
        """A list of [low, high], {log = [low, high]} or {choice = [...]}."""
        if isinstance(value, dict) and set(value) == {"choice"}:
            if not isinstance(value["choice"], list) or not value["choice"]:
                self.refuse(f"search: {key}: choice: expects a list of values")
            return tuple(value["choice"])
        if isinstance(value, dict) and "normal" in value:
            self.refuse(f"search: {key}: expects [low, high], {{log = ...}} or {{choice = ...}}")
        whole = isinstance(value, list) and all(type(v) is int for v in value)
        return drawn_axis(f"{self.file} [search]", key, value, whole)

    def goals(self, given: dict, kind: str) -> list:
        every = given.get(kind, [])
        if not isinstance(every, list):
            self.refuse(f"{kind}: expects [[{kind}]]")
        return [self.goal(kind, one) for one in every]

    def goal(self, kind: str, given: dict) -> Goal | Distance:
        allowed = {"figure", "over", *(("goal",) if kind == "objective" else
                                       ("at_least", "at_most"))}
        if kind == "objective" and isinstance(given, dict) and "targets" in given:
            return self.distance(given)
        if not isinstance(given, dict) or not isinstance(given.get("figure"), str) \
                or not set(given) <= allowed:
            self.refuse(f"{kind}: expects {', '.join(sorted(allowed))}")
        over, goal = given.get("over", "max"), given.get("goal", "minimize")
        if not isinstance(over, str) or over not in OVER:
            self.refuse(f"{kind}: over: must be one of {', '.join(OVER)}")
        if goal not in ("minimize", "maximize"):
            self.refuse(f"{kind}: goal: must be one of minimize, maximize")
        limits = {k: given[k] for k in ("at_least", "at_most") if k in given}
        if kind == "constraint" and not limits:
            self.refuse("constraint: expects at_least or at_most")
        if not all(type(v) in (int, float) and math.isfinite(v) for v in limits.values()):
            self.refuse("constraint: a limit must be a number")
        return Goal(given["figure"], over, goal == "maximize", **limits)

    def distance(self, given: dict) -> Distance:
        if not set(given) <= {"over", "targets"}:
            self.refuse("objective: with targets expects nothing else than over")
        over, targets = given.get("over", "rms"), given["targets"]
        if not isinstance(over, str) or over not in DISTANCES:
            self.refuse(f"objective: over: with targets must be one of {', '.join(DISTANCES)}")
        if not isinstance(targets, list) or not targets:
            self.refuse("objective: targets: expects a list of tables")
        return Distance(over, tuple(map(self.target, targets)))

    def target(self, given) -> Target:
        if not isinstance(given, dict) or not isinstance(given.get("figure"), str) \
                or not all(type(given.get(k)) in (int, float) and math.isfinite(given[k])
                           for k in ("value", "within")) or given["within"] <= 0:
            self.refuse("objective: targets: each expects figure, value and within, which is "
                        "above 0")
        wanted = {k: v for k, v in given.items() if k not in Target._fields[:3]}
        cases = tuple(n for n, (scenario, case) in enumerate(self.cases)
                      if wanted.items() <= {"scenario": scenario, **case}.items())
        if not cases:
            self.refuse(f"objective: targets: {given['figure']}: no case has " +
                        ", ".join(f"{k} = {v}" for k, v in wanted.items()))
        return Target(given["figure"], given["value"], given["within"], cases)

    def of(self, target: Target) -> str:
        """The cases of a target, in words."""
        return "; ".join(" ".join([scenario, *(f"{k}={v}" for k, v in case.items())])
                         for scenario, case in (self.cases[n] for n in target.cases))

    def check(self) -> None:
        """Keys and their ends are within their ranges, in every case."""
        try:
            for scenario, case in self.cases:
                _given(scenario, self.engine, (), {**self.keys, **case}).validate()
                base = _core.Settings(scenario)
                for key, axis in self.search.items():
                    if key in self.keys or key in case:
                        self.refuse(f"search: {key}: given twice")
                    ends = axis if type(axis) is tuple else (axis.low, axis.high)
                    for value in ends:
                        _apply(base.copy(), key, value)
        except StudyError:
            raise
        except _core.ConfigError as error:
            self.refuse(str(error))

    def identity(self) -> dict:
        text = json.dumps([self.scenario, self.engine, self.seed, self.keys, self.cases,
                           {key: list(axis) for key, axis in self.search.items()},
                           [list(map(str, goal)) for goal in self.objectives + self.constraints]])
        return {"study": hashlib.sha256(text.encode()).hexdigest(), "version": _core.version}

    def suggest(self, trial) -> dict:
        """Values of a trial of Optuna."""
        values = {}
        for key, axis in self.search.items():
            if type(axis) is tuple:
                values[key] = trial.suggest_categorical(key, axis)
            elif axis.whole:
                values[key] = trial.suggest_int(key, axis.low, axis.high)
            else:
                values[key] = trial.suggest_float(key, axis.low, axis.high,
                                                  log=axis.spread == "log")
        return values
