# SPDX-License-Identifier: Apache-2.0
"""Make the runs of a plan on all processors or a cluster, into one Parquet data set.

It is `python -m trammel sweep` with the package that the build has made; the command line is
python/trammel/sweep/options.py.
"""

import importlib.util
import os
import sys

from trammel_tools import python_tools
from trammel_tools.paths import ROOT

PACKAGE = ROOT / "build" / "python"


def options():
    """The parser of the package, which may not be built yet."""
    file = ROOT / "python" / "trammel" / "sweep" / "options.py"
    spec = importlib.util.spec_from_file_location("options", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.parser()


def main():
    options().parse_args()
    python_tools.need("dask", "sweep")
    if not list(PACKAGE.glob("trammel/_core*.so")):
        print("sweep: the Python package is not built: ./trammel test makes it", file=sys.stderr)
        return 3
    paths = [str(PACKAGE), *filter(None, [os.environ.get("PYTHONPATH")])]
    # A process of its own: workers are started with its main module.
    return os.execve(sys.executable, [sys.executable, "-m", "trammel", "sweep", *sys.argv[1:]],
              {**os.environ, "PYTHONPATH": os.pathsep.join(paths)})
