# SPDX-License-Identifier: Apache-2.0
"""Whole runs of this machine for scripts/tool sanitize, good and bad input."""

SHORT = ("run", "larson-calibrate", "-s", "axis.start_x_step=20", "-s", "axis.start_y_step=30")
FOLDER = "OUT/larson"
RUNS = [
    (0, *SHORT, "-o", FOLDER),
    (0, *SHORT, "--engine", "twin", "-o", FOLDER),
    (5, *SHORT, "-s", "run.max_s=0.05", "--wave", "fst", "--wave-window", "5ms:5.1ms", "-o",
     FOLDER),
    *((5, *SHORT, way, "-s", "run.max_s=0.003", "-o", FOLDER) for way in ("--audit", "--assert")),
    (0, *SHORT, "--json", "--platform", "direct", "-o", FOLDER),
    (0, "run", "larson-limit", "--engine", "twin", "-o", FOLDER),
    (5, "run", "larson-overload", "--engine", "twin", "-o", FOLDER),
    (0, "table", "step", "-s", "record.every_ms=1", "-o", FOLDER),
    (0, "report", FOLDER), (0, "report", FOLDER, FOLDER, "-o", "OUT/two.html"),
]
REFUSED = [
    (2, "name a script", "table"),
    (2, "no such script", "table", "nowhere"),
    (2, "run.engine", *SHORT, "--engine", "twin", "--assert", "-o", FOLDER),
    (2, "motor.friction_N_m", *SHORT, "-s", "motor.friction_N_m=2",
     "-s", "motor.friction_speed_step_s=1"),
]
