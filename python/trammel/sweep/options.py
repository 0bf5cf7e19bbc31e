# SPDX-License-Identifier: Apache-2.0
"""The command line of `trammel sweep`. It needs nothing else, so that its help is always there."""

import argparse

ABOUT = """Make the runs of a plan on all processors or a cluster, into one Parquet data set.

A plan names a scenario and what varies: a [grid], [latin] hypercube or [random] draws of any
keys, or a [table] of own points; several scenarios as [[part]]. Runs that are in the folder are
not made again, so that a sweep that was killed goes on where it was; a run that cannot be made is
kept with its message. page.html in the folder shows all runs. docs/one-to-a-million.md explains it.

Exit codes: 0 every run is there, 1 some were refused or lost, 2 usage, plan or disk, 3 a package is
missing, 130 interrupted."""


class Parser(argparse.ArgumentParser):
    """Errors in one line."""

    def error(self, message):
        self.exit(2, f"sweep: {message}; see {self.prog} --help\n")


def parser() -> Parser:
    found = Parser(prog="trammel sweep", description=ABOUT,
                   formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    found.add_argument("plan", metavar="PLAN.toml")
    found.add_argument("-o", "--out", metavar="FOLDER",
                       help="of the data set; default: out/<name of the plan>")
    found.add_argument("--jobs", type=int, default=0, metavar="N",
                       help="workers; default: one a processor, 4 jobs of a cluster")
    found.add_argument("--cluster", default="local", metavar="KIND",
                       choices=("local", "slurm", "lsf", "pbs", "sge", "htcondor"),
                       help="local, or by dask-jobqueue: slurm, lsf, pbs, sge, htcondor")
    found.add_argument("--scheduler", default="", metavar="ADDRESS",
                       help="of a Dask scheduler that is there, such as tcp://host:8786")
    found.add_argument("--shard", default="1/1", metavar="i/n",
                       help="the i-th of n parts alone, for other ways to share the work; all may "
                            "write into one folder")
    found.add_argument("--limit", type=float, default=60, metavar="SECONDS",
                       help="how long to wait for the first worker; default: 60")
    found.add_argument("--yes", action="store_true", help="even if the runs are more than 10^7")
    found.add_argument("--count", action="store_true", help="only print how many runs there are")
    found.add_argument("--empty", action="store_true",
                       help="runs that do nothing, to measure what is around them")
    return found
