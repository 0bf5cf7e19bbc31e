#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wave files of the stepper interface: five steps in one window, and the view for GTKWave.

usage: waves_check.py PROGRAM [FOLDER]      the built trammel program
"""

import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
from wave_case import WaveCase, WaveFile, main, pulses

RUN = ["run", "larson-calibrate", "-s", "axis.start_x_step=30", "-s", "axis.start_y_step=20",
       "-s", "run.max_s=0.2"]


class StepTest(WaveCase):
    def test_steps_of_both_axes_are_shown_with_words_and_bus(self):
        out = self.run_to("steps", RUN, "--wave", "fst", "--wave-window", "0:14ms", code=5)
        self.check_view(out / "waves.fst")
        file = WaveFile(out / "waves.fst")
        for axis in (0, 1):
            steps = [(time, int(value)) for time, value in file.changes(
                f"larson_xy.u_table.gen_axis[{axis}].u_channel.step_o")]
            whole = pulses([(time, 1 - value) for time, value in steps])
            self.assertEqual(len(whole), 5)  # of 400 Hz, in 14 ms
            for begin, end in whole:
                self.assertLessEqual(abs(end - begin - 2080), 20)  # half a period of 240 kHz
            for before, after in itertools.pairwise(whole):
                self.assertLessEqual(abs(after[0] - before[0] - 2_500_000), 20)


if __name__ == "__main__":
    main()
