# SPDX-License-Identifier: Apache-2.0
"""Make the runs of a plan on all processors or a cluster, into one Parquet data set.

It is `python -m trammel sweep` with the package that the build has made; the command line is
python/trammel/command_line.py.
"""

from trammel_tools.runs import package


def main():
    return package.perform("sweep", ["dask", "pyarrow"])
