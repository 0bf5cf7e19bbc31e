# SPDX-License-Identifier: Apache-2.0
"""Wave files, VCD or FST, as Python sees them: names, values over time, windows of time."""

import contextlib
import difflib
import os
import re
import stat
import sys
from pathlib import Path

from trammel_tools.output_file import Refused

FEMTO = {"s": 10**15, "ms": 10**12, "us": 10**9, "ns": 10**6}  # femtoseconds
TIME = re.compile(r"([-+]?[0-9.]+(?:e[-+]?[0-9]+)?)(ns|us|ms|s|clk)?", re.I | re.A)


@contextlib.contextmanager
def silent():
    """A reader that meets a broken file writes to stderr before it raises."""
    sys.stderr.flush()
    kept = os.dup(2)
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)


@contextlib.contextmanager
def reading(path):
    """Whatever a reader raises at a broken file is that file's fault."""
    try:
        with silent():
            yield
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # a panic of the reader is no Exception
        text = str(error).replace("\n", " ").strip()
        raise Refused(f"{path}: cannot be read as VCD or FST: {text[:100]}") from None


def pattern(glob):
    """Only * and ? are wild, [0] is an index; a name may begin at any scope."""
    text = "".join({"*": ".*", "?": "."}.get(c, re.escape(c)) for c in glob)
    return re.compile(rf"(?:.*\.)?{text}")


class WaveFile:
    """Names of a wave file and the values of its signals; a time step is `step` femtoseconds."""

    def __init__(self, path):
        import pywellen
        self.path = Path(path)
        if self.path.is_dir():
            raise Refused(f"{path}: is a folder, not a wave file")
        try:  # to open a pipe or a device may never end
            if not stat.S_ISREG(self.path.stat().st_mode):
                raise Refused(f"{path}: cannot be read: it is not a regular file")
            with self.path.open("rb") as file:
                file.read(1)
        except OSError as error:
            raise Refused(f"{path}: cannot be read: {error.strerror}") from None
        with reading(path):
            self._wave = pywellen.Waveform(str(self.path))
            scale = self._wave.timescale
            self.step = scale.factor * 10 ** (scale.unit.to_exponent() + 15)
            self._vars = {v.full_name: v for v in self._wave.all_vars()}
            self.names = sorted(self._vars, key=lambda name: (name.count("."), name))
            self._ids = {name: str(v.signal_id) for name, v in self._vars.items()}
        if self.step <= 0:
            raise Refused(f"{path}: its time step is 0")
        if not self.names:
            raise Refused(f"{path}: holds no signals")

    def bits(self, name):
        return self._vars[name].bitwidth or 0

    def identity(self, name):
        """The same for two names of one signal."""
        return self._ids[name]

    def changes(self, name):
        """(time step, value) of each change; values that repeat are left out."""
        with reading(self.path):
            found = list(self._vars[name].signal)
        return [c for i, c in enumerate(found) if i == 0 or c[1] != found[i - 1][1]]

    def select(self, globs):
        """Names that match any of the globs, all without globs."""
        if not globs:
            return self.names
        chosen = []
        for glob in globs:
            wanted = pattern(glob)
            found = [name for name in self.names if wanted.fullmatch(name)]
            if not found:
                raise Refused(f"{self.path}: {glob}: no such signal{self.suggestion(glob)}")
            chosen += found
        return sorted(set(chosen), key=self.names.index)

    def suggestion(self, name):
        """Of names with as many scopes as were given."""
        depth = name.count(".") + 1
        tails = {".".join(full.split(".")[-depth:]) for full in self.names}
        near = difflib.get_close_matches(name, tails, 1)
        return f"; did you mean {near[0]}?" if near else ""

    def one(self, name):
        """The signal of that name; the least deep one when several names are the same signal."""
        found = self.select([name])
        if len({self.identity(full) for full in found}) > 1:
            raise Refused(f"{self.path}: {name}: {len(found)} signals end so, for instance "
                          f"{found[0]} and {found[-1]}")
        return found[0]

    def top_clock(self):
        return next((name for name in self.names if name.rpartition(".")[2] in ("clk_i", "clk")),
                    None)

    def clock(self, name=None):
        """Name and rising edges of the clock, in time steps; by default the top clk_i."""
        name = self.top_clock() if name is None else self.one(name)
        if name is None:
            raise Refused(f"{self.path}: no signal clk_i; name the clock with --clock")
        rising = [t for t, value in self.changes(name) if value == 1]
        if len(rising) < 2:
            raise Refused(f"{self.path}: {name} does not tick: no clock")
        return name, rising

    def span(self):
        """First and last time step at which the clock changes; without one, any signal."""
        firsts, lasts = [], []
        clock = self.top_clock()
        for name in [clock] if clock else self.names:
            with reading(self.path):
                signal = self._vars[name].signal
                if len(signal):
                    firsts.append(signal[0][0])
                    lasts.append(signal[len(signal) - 1][0])
        return min(firsts, default=0), max(lasts, default=0)

    def steps(self, value, unit, clock):
        """A time in steps of the file."""
        if unit != "clk":
            return round(value * FEMTO[unit] / self.step)
        rising = self.clock(clock)[1]
        return round(value) * (rising[1] - rising[0])

    def window(self, text, clock=None):
        """"a:b" in time steps; without text all of time."""
        if text is None:
            return 0, float("inf")
        edges = []
        for part in text.split(":"):
            found = TIME.fullmatch(part.strip())
            try:
                edges.append(self.steps(float(found[1]), (found[2] or "s").lower(), clock))
            except (TypeError, ValueError, OverflowError):  # the last: of what no float can hold
                edges = []
                break
        if len(edges) != 2 or not 0 <= edges[0] < edges[1]:
            raise Refused(f"--window: value {text} is not a:b with a before b, each with s, ms, "
                          "us, ns or clk behind it")
        return edges[0], edges[1]

    def reached(self, text):
        """The same, for a window in which there must be something."""
        begin, end = self.window(text)
        first, last = self.span()
        if text is not None and (end <= first or begin > last):
            raise Refused(f"--window: {text} lies outside {self.path}, which holds "
                          f"{time_text(first * self.step)} to {time_text(last * self.step)}")
        return begin, end


def within(changes, window):
    """The value the window begins with and the changes inside [begin, end)."""
    begin, end = window
    first, inside = None, []
    for time, value in changes:
        if time <= begin:
            first = value
        elif time < end:
            inside.append((time, value))
        else:
            break
    return first, inside


def time_text(femtoseconds):
    for unit, size in FEMTO.items():
        if femtoseconds >= size or unit == "ns":
            return f"{femtoseconds / size:.9g} {unit}"
    return ""
