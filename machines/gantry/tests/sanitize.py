# SPDX-License-Identifier: Apache-2.0
"""Whole runs of this machine for scripts/tool sanitize, good and bad input."""

SHORT = ("run", "gantry-p", "-s", "run.time_s=0.15")
FOLDER = "OUT/gantry"
RUNS = [
    (0, *SHORT, "-s", "host.stream=true", "-o", FOLDER),
    (0, *SHORT, "--engine", "twin", "-o", FOLDER),
    (0, *SHORT, "--wave", "fst", "--wave-window", "5ms:5.1ms", "-o", FOLDER),
    *((0, "run", "gantry-p", way, "-s", "run.time_s=0.003", "-o", FOLDER)
      for way in ("--audit", "--assert")),
    (0, *SHORT, "--json", "--platform", "direct", "-o", FOLDER),
    (0, "run", "gantry-calibrate", "--engine", "twin", "-o", FOLDER),
    (0, "run", "gantry-backlash", "--engine", "twin", "-s", "run.time_s=0.5", "-o", FOLDER),
    (5, *SHORT, "--engine", "twin", "-s", "monitor.sensor=true", "-s", "monitor.stall_ticks=400",
     "-s", "inject.fault=converter_saturated", "-s", "inject.begin_s=0.05", "-s",
     "inject.value=-1", "-o", FOLDER),
    (0, *SHORT, "--engine", "twin", "-o", FOLDER),
    (0, *SHORT, "--serial", "-o", FOLDER),
    (0, "report", FOLDER), (0, "report", FOLDER, FOLDER, "-o", "OUT/two.html"),
]
REFUSED = [
    (2, "host.sends", *SHORT, "-s", "host.sends=0.1:32=1", "-o", FOLDER),
    (2, "position.min_force", *SHORT, "-s", "position.max_force=9", "-o", FOLDER),
    (2, "axis.stiction_count", *SHORT, "-s", "axis.stiction_count=9", "-o", FOLDER),
    (2, "run.engine", *SHORT, "--engine", "twin", "--assert", "-o", FOLDER),
]
REFUSED_BY_ALL = [
    (2, "--serial", "run", "circle", "--serial", "-o", FOLDER),
]
