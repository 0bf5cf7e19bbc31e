# SPDX-License-Identifier: Apache-2.0
"""Search the best values of keys with Optuna, on all processors or a cluster.

It is `python -m trammel tune` with the package that the build has made; the command line is
python/trammel/command_line.py.
"""

from trammel_tools.runs import package


def main():
    return package.perform("tune", ["dask", "optuna"])
