#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wave files of two LM628 behind their bus: which part a transfer is for, the view for GTKWave.

usage: waves_check.py PROGRAM [FOLDER]      the built trammel program
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
from wave_case import WaveCase, WaveFile, level, main, pulses

CORNER = ["run", "mcafee-stage3", "-s", "path.kind=corner", "-s", "path.side_mm=2", "-s",
          "path.radius_mm=1", "-s", "compare=false", "-s", "run.max_s=0.01"]


class BusTest(WaveCase):
    def test_two_parts_are_shown_with_their_bus(self):
        out = self.run_to("two", CORNER, "--wave", "fst", "--wave-window", "2ms:5ms", code=5)
        self.check_view(out / "waves.fst")
        file = WaveFile(out / "waves.fst")
        x, y, write = ([(time, int(value)) for time, value in file.changes(f"mcafee_xy.{name}")]
                       for name in ("cs_x_n_o", "cs_y_n_o", "wr_n_o"))
        whole = [(b, e) for b, e in pulses(write) if b > 2_000_000]
        self.assertGreater(len(whole), 5)
        for begin, end in whole:
            self.assertLessEqual(abs(end - begin - 5500), 100)
            self.assertEqual(level(x, begin) + level(y, begin), 1)


if __name__ == "__main__":
    main()
