# SPDX-License-Identifier: Apache-2.0
"""From keys to a run."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from typing import NamedTuple

from trammel import _core
from trammel.results import Result

Value = bool | int | float | str | os.PathLike


class SettingError(_core.ConfigError):
    """A key that does not exist, or a value that it may not have.

    key     its name, as it was given
    value   what it was given; None where several keys do not fit together
    range   what it may be, such as "0..50" or "one of fc, afc"; None for an unknown key
    """

    def __init__(self, text: str, key: str | None = None, value: object = None,
                 range: str | None = None):
        super().__init__(text)
        self.key, self.value, self.range = key, value, range

    def __reduce__(self):  # so that workers can send it
        return type(self), (str(self), self.key, self.value, self.range)


class Key(NamedTuple):
    """A parameter of a machine: name with unit, default as TOML has it, range, one line of help."""

    name: str
    default: str
    range: str
    help: str


def text_of(value: Value) -> str:
    """A value as the command line has it."""
    if hasattr(value, "item"):  # a NumPy scalar
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return repr(value)
    if isinstance(value, str | os.PathLike):
        return os.fspath(value)
    raise SettingError(f"a value must be a number, a flag or a text, not {type(value).__name__}")


def _apply(asked: _core.Settings, key: str, value: Value) -> None:
    try:
        asked.set(key, text_of(value))
    except _core.ConfigError as error:
        text = str(error).removeprefix("-s: ")
        raise SettingError(text, key, value, asked.range(key)) from None


def _given(scenario: str | os.PathLike, engine: str | None, files: Iterable[str | os.PathLike],
           keys: dict[str, Value]) -> _core.Settings:
    """Settings that are not checked yet."""
    asked = _core.Settings(os.fspath(scenario))
    asked.set("run.platform", "direct")
    for file in files:
        asked.add_file(os.fspath(file))
    if engine is not None:
        _apply(asked, "run.engine", engine)
    for key, value in keys.items():
        _apply(asked, key, value)
    return asked


def settings(scenario: str | os.PathLike, /, *, engine: str | None = None,
             files: Iterable[str | os.PathLike] = (), **keys: Value) -> _core.Settings:
    """The settings of a run, checked: a scenario, then files, then keys; later ones win.

    scenario  the name of a built-in one, or the path of a .toml file
    engine    "rtl", the verilated chip, or "twin", its bit-exact twin in C++, which is faster
    files     further TOML files
    keys      as `trammel run -s` has them: controller="afc", **{"plant.x.payload_kg": 11}

    Raises SettingError, which carries key and range; environment variables are not looked at. The
    wiring is `run.platform = "direct"` unless it is given: its events are those of "systemc", which
    can run only once at a time in a process.
    """
    asked = _given(scenario, engine, files, keys)
    try:
        asked.validate()
    except _core.ConfigError as error:
        named = re.match(r"([a-z]\w*(?:\.\w+)*)\b", str(error))
        key = named[1] if named and asked.range(named[1]) else None
        raise SettingError(str(error), key, None, asked.range(key) if key else None) from None
    return asked


def settings_of(scenario: str | os.PathLike | _core.Settings, keys: dict) -> _core.Settings:
    """Settings as they are, or made of a scenario and keys."""
    if not isinstance(scenario, _core.Settings):
        return settings(scenario, **keys)
    if keys:
        raise SettingError(f"{next(iter(keys))}: settings() takes it, not what is given its result",
                           next(iter(keys)))
    return scenario


def run(scenario: str | os.PathLike | _core.Settings, /, *,
        progress: Callable[[float], object] | None = None, **keys) -> Result:
    """Simulates a scenario and returns its record; arguments as of settings().

    progress  is called some times a second with the fraction done, 0 to 1; what it raises ends the
              run and is raised here. Ctrl-C does the same with KeyboardInterrupt.

    Other threads go on meanwhile, and may run simulations too. A run that trips or diverges is a
    result like any other: look at `end` and `verdict`.
    """
    return Result(_core.run(settings_of(scenario, keys), progress))


def scenarios() -> list[str]:
    """Names of the built-in scenarios."""
    return _core.scenarios()


def keys(machine: str) -> dict[str, Key]:
    """Every key of a machine with default, range and help."""
    found = {name: Key(name, *more) for name, *more in _core.keys(machine)}
    if not found:
        raise SettingError(f"{machine}: no such machine; there are {', '.join(_core.machines())}")
    return found
