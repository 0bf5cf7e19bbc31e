# SPDX-License-Identifier: Apache-2.0
"""The verb `trammel sweep`."""

from __future__ import annotations

import contextlib
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from trammel import command_line
from trammel.sweep.plan import MOST, Plan, PlanError

FLUSH_S = 10  # what a kill can cost, and
FLUSH_ROWS = 20_000


class Done(NamedTuple):
    """What perform() did."""

    runs: int  # made now
    refused: int  # of all that are there, without a result
    left: int
    seconds: float


class Progress:
    """A line with rate and time left, on a terminal alone; and a call for whoever wants to know."""

    def __init__(self, show: bool, call: Callable[[int, int], object] | None = None,
                 what: str = "runs"):
        self.show, self.call, self.what = show and sys.stderr.isatty(), call, what
        self.begin(0)

    def begin(self, count: int) -> None:
        self.count, self.made = count, 0
        self.begun = self.last = time.monotonic()

    def add(self, runs: int) -> None:
        self.made += runs
        if self.call is not None:
            self.call(self.made, self.count)
        now = time.monotonic()
        if not self.show or now - self.last < 0.2:
            return
        self.last = now
        rate = self.made / (now - self.begun)
        left = (self.count - self.made) / rate
        self._line(f"{self.made} of {self.count} {self.what}, {rate:.3g} per s, "
                   f"{left:.0f} s left")

    def close(self) -> None:
        if self.show:
            self._line("")

    def _line(self, text: str) -> None:
        """In the place of the one before."""
        terminal = getattr(sys.stderr, "plain", sys.stderr)
        terminal.write(f"\r\033[K{text}")
        terminal.flush()


def shard_of(text: str) -> tuple[int, int]:
    """i/n, with 1 <= i <= n."""
    try:
        one, of = map(int, text.split("/"))
    except ValueError:
        one = of = 0
    if not 1 <= one <= of:
        raise PlanError(f"--shard {text}: expects i/n with 1 <= i <= n, such as 2/8")
    return one, of


def perform(plan: Plan, folder, *, jobs: int = 0, cluster: str = "local", scheduler: str = "",
            shard: tuple[int, int] = (1, 1), limit_s: float = 60, show: bool = False,
            page: bool = True, empty: bool = False,
            progress: Callable[[int, int], object] | None = None) -> Done:
    """Makes the runs of a plan that are not in the folder yet, and the page of all.

    progress  is called with the runs made now and how many it will be; what it raises ends the
              sweep, as Ctrl-C does, and what is done is kept
    """
    import numpy as np

    from trammel.sweep import cluster as workers
    from trammel.sweep import files, store

    one, of = shard
    file = Path(folder) / "page.html"
    if page:
        files.check_replaceable(file)
    with store.Store(Path(folder), plan.identity(), f"-{one}-of-{of}" if of > 1 else "") as kept:
        wanted = np.arange(one - 1, plan.count, of)
        wanted = wanted[~np.isin(wanted, kept.done(), assume_unique=True)]
        begun, made = time.monotonic(), 0
        if len(wanted):
            made = _make(plan, kept, wanted, workers, jobs or workers.processors(), cluster,
                         scheduler, limit_s, Progress(show, progress), empty)
        seconds = time.monotonic() - begun
        table = kept.table(["run", "end"])
        refused = sum(end in store.ENDS_REFUSED for end in table["end"].to_pylist())
        if page:
            from trammel.sweep import page as shown

            shown.write(plan, kept.table(), file)
    return Done(made, refused, plan.count - table.num_rows, seconds)


def _make(plan, kept, wanted, workers, jobs, cluster, scheduler, limit_s, progress, empty) -> int:
    parts = [(part.scenario, part.engine, part.keys) for part in plan.parts]
    runs = ((int(number), *plan.run(int(number))) for number in wanted)
    progress.begin(len(wanted))
    rows, flushed, made = [], time.monotonic(), 0

    def flush() -> None:
        nonlocal rows, flushed, made
        if rows:
            kept.add(rows)
        made += len(rows)
        rows, flushed = [], time.monotonic()

    with workers.client(cluster, jobs, scheduler, limit_s) as found:
        try:
            for some in workers.rows(found, parts, runs, jobs, empty):
                rows += some
                progress.add(len(some))
                if len(rows) >= FLUSH_ROWS or time.monotonic() - flushed > FLUSH_S:
                    flush()
        except BaseException:
            with contextlib.suppress(OSError, PlanError):  # may be what it ended by: the disk
                flush()
            raise
        finally:
            progress.close()
        flush()
    return made


def _sweep(given) -> int:
    shard = shard_of(given.shard)
    plan = Plan(Path(given.plan))
    if given.count:
        print(plan.count)
        return 0
    if plan.count > MOST and not given.yes:
        raise PlanError(f"{given.plan}: {plan.count} runs, more than {MOST}; --yes makes them")
    folder = Path(given.out or Path("out") / Path(given.plan).stem)
    jobs = given.jobs or (0 if given.cluster == "local" else 4)
    done = perform(plan, folder, jobs=jobs, cluster=given.cluster, scheduler=given.scheduler,
                   shard=shard, limit_s=given.limit, show=True, empty=given.empty)
    rate = f", {done.runs / done.seconds:.3g} per s" if done.runs else ""
    print(f"{plan.file.stem}: {plan.count - done.left} of {plan.count} runs, {done.runs} of them "
          f"now{rate}; {done.refused} without a result\n  results in {os.fspath(folder)}\n"
          f"  page: {folder / 'page.html'}")
    return 1 if done.refused else 0


def main() -> int:
    return command_line.main("sweep", command_line.sweep, _sweep,
                             lambda given: given.out or given.plan)


if __name__ == "__main__":
    sys.exit(main())
