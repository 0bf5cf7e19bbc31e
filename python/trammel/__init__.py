# SPDX-License-Identifier: Apache-2.0
"""Trammel from Python: runs of motion-control ICs with the machines they drive.

    import trammel
    result = trammel.run("circle", engine="twin", controller="afc", **{"plant.x.payload_kg": 11})
    result.figures["tracking.model.mean_mm"]     # a number with a unit
    result["x_position_m"]                       # a column of the record, as a NumPy array
    result.report("page.html")

The keys are those of scenarios and of `trammel run -s`, with their units in their names.
"""

from pathlib import Path

from trammel import _core
from trammel._core import ConfigError, ToolMissing
from trammel.results import Figure, Result, compare
from trammel.run_settings import SettingError, keys, run, scenarios, settings
from trammel.step import Simulation, Snapshot, open, restore

_data = Path(__file__).parent / "data" / "machines"
if _data.is_dir():  # a package that is installed has them with it
    _core.take_data_from(str(_data))

__version__ = _core.version
__all__ = ["ConfigError", "Figure", "Result", "SettingError", "Simulation", "Snapshot",
           "ToolMissing", "compare", "keys", "open", "restore", "run", "scenarios", "settings"]
