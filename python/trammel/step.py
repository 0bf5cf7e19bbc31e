# SPDX-License-Identifier: Apache-2.0
"""A simulation that is advanced by hand: look at a machine, and change it, on the way."""

from __future__ import annotations

import os
from functools import cached_property
from typing import NamedTuple

from trammel import _core
from trammel.results import Figure, Result
from trammel.run_settings import SettingError, settings_of


class _Field(NamedTuple):
    address: int
    shift: int
    width: int  # bits in the register
    bits: int  # of the number; those above repeat its sign
    signed: bool
    help: str

    def of(self, word: int) -> int:
        value = word >> self.shift & (1 << self.bits) - 1
        return value - (1 << self.bits) if self.signed and value >> self.bits - 1 else value

    def into(self, word: int, value: int) -> int:
        mask = (1 << self.width) - 1 << self.shift
        return word & ~mask | value << self.shift & mask


class Snapshot(NamedTuple):
    """How a simulation got where it was: its settings, and all that was done with it."""

    settings: _core.Settings
    done: tuple


class Simulation:
    """A run that goes on when it is told to; made by open().

    It stands only while the firmware waits for its interrupt, so that the bus is free: advance()
    goes on until that is so, some microseconds where a routine is on its way. Registers are read
    and written over the bus, as a second master would: that takes some clocks of simulated time.
    Without such accesses the events are those of run().
    """

    def __init__(self, asked: _core.Settings):
        self._settings = asked.copy()
        self._run = _core.Stepped(asked)
        self._done = []

    def __repr__(self) -> str:
        state = "over" if self.over else "stands"
        return f"<{self._settings.scenario}: {state} at {self.time_s:.9g} s>"

    @property
    def time_s(self) -> float:
        """Simulated time from the start [s]."""
        return self._run.now * self._run.clock_s

    @property
    def clock(self) -> int:
        """The same in clocks of the chip."""
        return self._run.now

    @property
    def over(self) -> bool:
        """The scenario has ended; finish() has its record."""
        return self._run.over

    @property
    def outputs(self) -> int:
        """Pins of the chip toward the machine, gates among them: one bit each, as in pins.hpp of
        the machine."""
        return self._run.drive

    @property
    def inputs(self) -> int:
        """Pins of the machine toward the chip: encoders, limits and so on."""
        return self._run.sense

    def advance(self, seconds: float) -> float:
        """Simulates at least so long, less where the scenario ends before; returns time_s.

        Ctrl-C raises KeyboardInterrupt; the simulation then stands after its newest sample."""
        clock_s = self._run.clock_s
        clocks = round(seconds / clock_s)
        if not 0 < clocks <= 2**62:
            raise SettingError(f"advance: {seconds!r} s is out of range {clock_s:g}..9e10",
                               "seconds", seconds, f"{clock_s:g}..9e10")
        return self._do("advance", clocks)

    @cached_property
    def registers(self) -> dict[str, int]:
        """Registers of the chip and their byte addresses, as docs/registers names them; none for
        a chip without a map."""
        return dict(_core.registers(self._settings.machine)[0])

    @cached_property
    def fields(self) -> dict[str, _Field]:
        """Fields of the registers: "x.KP.mant"; a register of one field has its name alone."""
        found = {}
        for name, address, shift, width, bits, signed, of_axis, text in (
                _core.registers(self._settings.machine)[1]):
            for prefix in ("x.", "y.") if of_axis else ("",):
                full = prefix + name
                at = self.registers.get(full, self.registers.get(full.rpartition(".")[0], address))
                found[full] = _Field(at, shift, width, bits, signed, text)
        return found

    def _address(self, name: str | int) -> int:
        if isinstance(name, int):
            if not 0 <= name < 2**32 or name % 4:
                raise SettingError(f"register: address {name:#x} is out of range 0..0xfffffffc, or "
                                   "no multiple of 4", "register", name, "0..0xfffffffc")
            return name
        if name not in self.registers:
            if not self.registers:
                raise SettingError(f"register {name}: the chip of {self._settings.machine} has no "
                                   "register map; give a byte address of its bus", name)
            raise SettingError(f"register {name}: not of this chip; there are "
                               f"{', '.join(self.registers)}", name)
        return self.registers[name]

    def read(self, register: str | int) -> int:
        """A register or one of its fields, by name or byte address: "x.POS", "x.KP.mant", 0x210.
        A field is a number with its sign, a register of several fields its 32 bits."""
        field = self.fields.get(register)
        if field is not None:
            return field.of(self._do("read", field.address))
        return self._do("read", self._address(register))

    def write(self, register: str | int, value: int) -> None:
        """The same for writing. Of a register with other fields the rest is read before."""
        field = self.fields.get(register)
        value = int(value)
        if not -(2**31) <= value < 2**32:
            raise SettingError(f"register {register}: value {value} is out of range "
                               "-2147483648..4294967295", str(register), value,
                               "-2147483648..4294967295")
        if field is None:
            self._do("write", self._address(register), value & 0xFFFFFFFF)
            return
        low, high = (-(1 << field.bits - 1), (1 << field.bits - 1) - 1) if field.signed else (
            0, (1 << field.bits) - 1)
        if not low <= value <= high:
            raise SettingError(f"register {register}: value {value} is out of range {low}..{high}",
                               register, value, f"{low}..{high}")
        whole = register in self.registers
        word = 0 if whole else self._do("read", field.address)
        self._do("write", field.address, field.into(word, value))

    @property
    def positions(self) -> dict[str, Figure]:
        """Where each axis of the machine really is, whatever its sensors tell: "x" and "y", or ""
        where there is but one; each with the unit of its column in the trace."""
        return {axis: Figure(value, unit) for axis, value, unit in self._run.places}

    def position(self, axis: str = "") -> Figure:
        """One of them. It can only be read: between two clocks nothing moves a machine."""
        found = self.positions
        if axis not in found:
            known = ", ".join(map(repr, found)) or "none"
            raise SettingError(f"position {axis!r}: not of this machine; there are {known}", axis)
        return found[axis]

    @property
    def signals(self) -> list[str]:
        """Words of the chip that are seen without the bus, where its machine shows them."""
        return self._run.signals

    def signal(self, name: str) -> int:
        """One of them: its value at the newest sample."""
        value = self._run.signal(name)
        if value is None:
            known = ", ".join(self.signals) or "none"
            raise SettingError(f"signal {name}: not of this machine; there are {known}", name)
        return value

    def finish(self) -> Result:
        """Simulates the rest of the scenario and returns its record."""
        return Result(self._run.finish(False))

    def stop(self) -> Result:
        """Ends the run at its next sample and returns the record so far: its `end` is
        "interrupted"."""
        return Result(self._run.finish(True))

    def snapshot(self) -> Snapshot:
        """What restore() makes the same simulation of, now and later, any number of times.

        It holds what was done, not what came of it: a simulation always does the same again."""
        return Snapshot(self._settings.copy(), tuple(self._done))

    def _do(self, what: str, *arguments: int):
        if self.over:
            raise SettingError("the run is over: finish() has its record")
        begun = self._run.now
        value = getattr(self._run, what)(*arguments)
        if what == "advance":  # where it got to, for it may have been interrupted
            self._done.append((what, self._run.now - begun))
            return self.time_s
        self._done.append((what, *arguments))
        return value


def open(scenario: str | os.PathLike | _core.Settings, /, **keys) -> Simulation:
    """Begins a simulation that stands until advance() is called; arguments as of settings()."""
    return Simulation(settings_of(scenario, keys))


def restore(snapshot: Snapshot) -> Simulation:
    """A simulation that stands where the snapshot was taken, clock for clock: it is simulated once
    more up to there. That takes as long as it took the first time, of the twin engine some tenth of
    the simulated time."""
    simulation = Simulation(snapshot.settings)
    for what, *arguments in snapshot.done:
        simulation._do(what, *arguments)
    return simulation
