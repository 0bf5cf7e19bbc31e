# SPDX-License-Identifier: Apache-2.0
"""The command line of `trammel tune`. It needs nothing else, so that its help is always there."""

import argparse

ABOUT = """Search the best values of keys with Optuna, on all processors or a cluster.

A study names the keys to search, the cases that each trial runs (scenarios, payloads...), one or
several objectives over all cases, and constraints. Trials that are in the folder are not made
again: a study that was killed goes on where it was. best.toml is a scenario file of the best
values, one for each of the best where there are several objectives; page.html shows all trials.
docs/one-to-a-million.md explains it.

Exit codes: 0 there is a best trial, 1 none meets the constraints, 2 usage, study or disk, 3 a
package is missing, 130 interrupted."""


class Parser(argparse.ArgumentParser):
    """Errors in one line."""

    def error(self, message):
        self.exit(2, f"tune: {message}; see {self.prog} --help\n")


def parser() -> Parser:
    found = Parser(prog="trammel tune", description=ABOUT,
                   formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    found.add_argument("study", metavar="STUDY.toml")
    found.add_argument("-o", "--out", metavar="FOLDER",
                       help="of the study; default: out/<name of the study>")
    found.add_argument("--trials", type=int, default=0, metavar="N",
                       help="how many in all; default: those of the study")
    found.add_argument("--jobs", type=int, default=0, metavar="N",
                       help="trials at a time; default: one a processor. With 1 a study always "
                            "comes to the same")
    found.add_argument("--cluster", default="local", metavar="KIND",
                       choices=("local", "slurm", "lsf", "pbs", "sge", "htcondor"),
                       help="as of trammel sweep")
    found.add_argument("--scheduler", default="", metavar="ADDRESS", help="as of trammel sweep")
    found.add_argument("--limit", type=float, default=60, metavar="SECONDS",
                       help="how long to wait for the first worker; default: 60")
    return found
