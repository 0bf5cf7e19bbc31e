# SPDX-License-Identifier: Apache-2.0
"""The command lines of `trammel sweep` and `trammel tune`, and how they end. It needs nothing of
the package that is not there before the build, so that the help is always there."""

import argparse
import contextlib
import os
import sys
from collections.abc import Callable

try:
    from trammel._core import one_line, printable_lines
except ImportError:  # before it is built: those of scripts/, which reads the command line
    from trammel_tools.text import one_line
    from trammel_tools.text import shown as printable_lines

SWEEP = """Make the runs of a plan on all processors or a cluster, into one Parquet data set.

A plan names a scenario and what varies: a [grid], a [latin] hypercube or [random] draws of any
keys, or a [table] of your own points; several scenarios are a [[part]] each. Runs that are in the
folder are not made again, so that a sweep that was killed goes on where it was. A run that cannot
be made is kept with its message. page.html in the folder shows all runs.
docs/one-to-a-million.md explains it.

Exit codes: 0 every run is there, 1 some were refused or lost, 2 usage, plan or disk, 3 a package is
missing, 130 interrupted."""

TUNE = """Search the best values of keys with Optuna, on all processors or a cluster.

A study names the keys to search, the cases that each trial runs (scenarios, payloads...), one or
more objectives over all cases, and constraints. Trials that are in the folder are not made again:
a study that was killed goes on where it was. best.toml is a scenario file with the best values; if
there are several objectives, there is one for each of the best trials. page.html shows all trials.
docs/one-to-a-million.md explains it.

Exit codes: 0 there is a best trial, 1 none meets the constraints, 2 usage, study or disk, 3 a
package is missing, 130 interrupted."""


class Shown:
    """A stream to which texts of others come as printable_lines() shows them. What is to reach the
    terminal as it is, is written to `plain`."""

    def __init__(self, plain):
        self.plain = plain

    def write(self, text: str) -> int:
        self.plain.write(printable_lines(text))
        return len(text)

    def __getattr__(self, name: str):
        return getattr(self.plain, name)


def main(verb: str, parser: Callable[[], "Parser"], action: Callable[[argparse.Namespace], int],
         place: Callable[[argparse.Namespace], str]) -> int:
    """The exit code of a verb with its command line. All that it prints is shown."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    with contextlib.ExitStack() as streams:
        if sys.stdout is not None:
            streams.enter_context(contextlib.redirect_stdout(Shown(sys.stdout)))
        if sys.stderr is not None:
            streams.enter_context(contextlib.redirect_stderr(Shown(sys.stderr)))
        given = parser().parse_args()
        return exit_code(verb, lambda: action(given), place(given))


class Parser(argparse.ArgumentParser):
    """Errors in one line."""

    def __init__(self, verb: str, about: str):
        super().__init__(prog=f"trammel {verb}", description=about, allow_abbrev=False,
                         formatter_class=argparse.RawDescriptionHelpFormatter)
        self.verb = verb

    def error(self, message):
        self.exit(2, one_line(f"{self.verb}: {message}; see {self.prog} --help") + "\n")

    def add_workers(self, jobs: str) -> None:
        """Where the runs are made."""
        self.add_argument("--jobs", type=int, default=0, metavar="N", help=jobs)
        self.add_argument("--cluster", default="local", metavar="KIND",
                          choices=("local", "slurm", "lsf", "pbs", "sge", "htcondor"),
                          help="where the workers are: local, or by dask-jobqueue slurm, lsf, pbs, "
                               "sge, htcondor")
        self.add_argument("--scheduler", default="", metavar="ADDRESS",
                          help="of a Dask scheduler that is running, such as tcp://host:8786")
        self.add_argument("--limit", type=float, default=60, metavar="SECONDS",
                          help="how long to wait for the first worker; default: 60")


def sweep() -> Parser:
    found = Parser("sweep", SWEEP)
    found.add_argument("plan", metavar="PLAN.toml", help="what varies, and how")
    found.add_argument("-o", "--out", metavar="FOLDER",
                       help="of the data set; default: out/<name of the plan>")
    found.add_workers("workers; default: one for each processor; of a cluster, 4 jobs")
    found.add_argument("--shard", default="1/1", metavar="i/n",
                       help="only the i-th of n parts, for other ways to share the work; all may "
                            "write into one folder")
    found.add_argument("--yes", action="store_true",
                       help="make the runs even if there are more than 10^7")
    found.add_argument("--count", action="store_true", help="only print how many runs there are")
    found.add_argument("--empty", action="store_true",
                       help="make runs that do nothing, to measure what is around them")
    return found


def tune() -> Parser:
    found = Parser("tune", TUNE)
    found.add_argument("study", metavar="STUDY.toml", help="what is searched, and what is good")
    found.add_argument("-o", "--out", metavar="FOLDER",
                       help="of the study; default: out/<name of the study>")
    found.add_argument("--trials", type=int, default=0, metavar="N",
                       help="how many in all; default: those of the study")
    found.add_workers("trials at a time; default: one for each processor. With 1 a study always "
                      "comes to the same result")
    return found


def exit_code(verb: str, action: Callable[[], int], place: str) -> int:
    """The exit code of what a verb does; an error is a line, of a file if none else at `place`."""
    try:
        return action()
    except ImportError as error:
        code, text = 3, f"{error.name} is missing (trammel doctor)"
    except KeyboardInterrupt:
        code, text = 130, "interrupted; the same command goes on"
    except OSError as error:
        why = os.strerror(error.errno) if error.errno else error
        code, text = 2, f"{error.filename or place}: {why}; what is done is kept"
    except ValueError as error:
        code, text = 2, str(error)
    print(one_line(f"{verb}: {text}"), file=sys.stderr)
    return code
