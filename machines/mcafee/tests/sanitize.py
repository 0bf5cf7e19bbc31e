# SPDX-License-Identifier: Apache-2.0
"""Whole runs of this machine for scripts/tool sanitize, good and bad input."""

CORNER = ("run", "mcafee-stage3", "-s", "path.kind=corner", "-s", "path.side_mm=2", "-s",
          "path.radius_mm=1", "-s", "compare=false", "-s", "trajectory.wait_s=0.1", "-s",
          "run.reached_counts=2000")
FOLDER = "OUT/mcafee"
RUNS = [
    (0, *CORNER, "-o", FOLDER),
    (0, "track", "--listing"),
    (0, *CORNER, "--wave", "fst", "--wave-trigger", "row == 1", "-o", FOLDER),
    (0, *CORNER, "--wave", "fst", "--wave-window", "5ms:5.1ms", "-o", FOLDER),
    *((5, *CORNER, way, "-s", "run.max_s=0.01", "-o", FOLDER) for way in ("--audit", "--assert")),
    (0, *CORNER, "--json", "--platform", "direct", "-o", FOLDER),
    (5, *CORNER, "--platform", "direct", "--no-leap", "-s", "run.max_s=0.02", "-o", FOLDER),
    (0, *CORNER, "--engine", "twin", "-s", "path.kind=star", "-s", "path.side_mm=1",
     "-s", "path.radius_mm=0.1", "-s", "compare=true", "-o", FOLDER),
    (0, "run", "mcafee-stage1", "-s", "trajectory.readings=3", "-o", FOLDER),
    *((5, "run", "mcafee-stage2", "-s", "run.max_s=0.02", "-s", f"chip.clock_MHz={clock}",
       "--engine", engine, "-o", FOLDER) for clock in (6, 8) for engine in ("rtl", "twin")),
    (5, *CORNER, "-s", "path.side_mm=4", "-s", "stage.switch_high_m=0.001", "-o", FOLDER),
    (0, "report", FOLDER), (0, "report", FOLDER, FOLDER, "-o", "OUT/two.html"),
    (0, "track"), (0, "track", "-s", "path.kind=circle", "-o", "OUT/circle.csv"),
]
REFUSED = [
    (2, "value 7 is neither 6 nor 8", *CORNER, "-s", "chip.clock_MHz=7"),
    (2, "run.engine", *CORNER, "--engine", "twin", "--assert", "-o", FOLDER),
    (2, "row 0: increments 142, 0", *CORNER, "-s", "path.row_mm=0.7", "-o", FOLDER),
    (2, "path.radius_mm", "track", "-s", "path.radius_mm=31"),
    (2, "has an expected value", "run", "mcafee-stage1", "-s", "trajectory.readings=3", "--check"),
    (2, "is not one of mcafee", "track", "-s", "machine=other"),
]
REFUSED_BY_ALL = [
    (2, "is a scenario of the machine", "track", "circle"),
]
