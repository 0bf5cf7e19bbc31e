#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wave files of the gantry track: the reset message on its line, and the view for GTKWave.

usage: waves_check.py PROGRAM [FOLDER]      the built trammel program
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
from wave_case import WaveCase, WaveFile, main

RUN = ["run", "gantry-p", "-s", "run.time_s=0.2"]
BIT_NS = 8680  # 434 clocks


class TrackTest(WaveCase):
    def test_the_reset_message_is_on_the_line(self):
        out = self.run_to("reset", RUN, "--wave", "fst", "--wave-window", "0:1ms")
        self.check_view(out / "waves.fst")
        edges = [(time, int(value)) for time, value in
                 WaveFile(out / "waves.fst").changes("gantry_tau.tx_o")]
        first = next(time for time, value in edges if value == 0)

        def level(time):
            return [value for at, value in edges if at <= time][-1]

        for byte, begin in ((0x8A, 0), (0x49, 10)):
            bits = [level(first + BIT_NS * (begin + k) + BIT_NS // 2) for k in range(10)]
            self.assertEqual(bits, [0, *(byte >> k & 1 for k in range(8)), 1])


if __name__ == "__main__":
    main()
