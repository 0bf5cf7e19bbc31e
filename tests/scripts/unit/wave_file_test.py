# SPDX-License-Identifier: Apache-2.0
"""Times, windows and names of wave files, without one."""

import unittest

from trammel_tools.waves import wave_picture
from trammel_tools.waves.wave_file import Refused, WaveFile, pattern, time_text, within


def file_of(step, rising=()):
    """A wave file of that time step [fs] whose clock rises at these steps."""
    file = object.__new__(WaveFile)
    file.path, file.step = "run.fst", step
    file.clock = lambda name=None: ("top.clk_i", list(rising))
    return file


class WaveFileTest(unittest.TestCase):
    def test_a_window_is_in_time_steps_whatever_its_units(self):
        file = file_of(10**6)  # 1 ns
        for text, window in (("2ms:2.1ms", (2_000_000, 2_100_000)), ("0:1us", (0, 1000)),
                             ("1e-6:3us", (1000, 3000)), (" 5NS : 1Ms", (5, 1_000_000)),
                             (None, (0, float("inf")))):
            with self.subTest(text):
                self.assertEqual(file.window(text), window)

    def test_a_step_of_the_file_need_not_be_a_nanosecond(self):
        self.assertEqual(file_of(10**3).window("1ns:2ns"), (1000, 2000))  # 1 ps

    def test_clocks_count_from_the_start_with_the_period_of_the_clock(self):
        self.assertEqual(file_of(10**6, rising=(10, 30, 50)).window("8clk:54clk"), (160, 1080))
        self.assertEqual(file_of(10**6, rising=(10, 30)).window("1CLK:2Clk"), (20, 40))

    def test_what_is_no_window_is_refused(self):
        for text in ("2us", "2us:1us", "1us:1us", "-1us:1us", "1:2:3", "a:b", ":", "1parsec:2us",
                     "1.2.3:4", ""):
            with self.subTest(text), self.assertRaisesRegex(Refused, "is not a:b with a before b"):
                file_of(10**6).window(text)

    def test_a_time_is_told_in_the_largest_unit_that_it_fills(self):
        self.assertEqual([time_text(t) for t in (0, 10**5, 10**6, 1234 * 10**6, 25 * 10**11,
                                                 10**15)],
                         ["0 ns", "0.1 ns", "1 ns", "1.234 us", "2.5 ms", "1 s"])

    def test_a_name_begins_at_any_scope_and_only_stars_and_marks_are_wild(self):
        for glob, name, fits in (
                ("e_q", "top.u_afc.e_q", True), ("u_afc.e_q", "top.u_afc.e_q", True),
                ("c.e_q", "top.u_afc.e_q", False), ("u_a[0].e", "top.u_a[0].e", True),
                ("u_a[0].e", "top.u_a0.e", False), ("u_*.e?q", "top.u_afc.e_q", True),
                ("e", "top.u_afc.e_q", False)):
            with self.subTest(glob=glob, name=name):
                self.assertEqual(bool(pattern(glob).fullmatch(name)), fits)

    def test_a_window_begins_with_the_value_that_stands_there(self):
        changes = [(0, 1), (10, 2), (20, 3), (30, 4)]
        self.assertEqual(within(changes, (10, 30)), (2, [(20, 3)]))
        self.assertEqual(within(changes, (15, 100)), (2, [(20, 3), (30, 4)]))
        self.assertEqual(within([(50, 1)], (10, 30)), (None, []))


class WavePictureTest(unittest.TestCase):
    def test_a_signal_has_a_label_and_a_format_if_given(self):
        for text, parts in (("u_a.e_q", ("e_q", "u_a.e_q", "")), ("e_q:d", ("e_q", "e_q", "d")),
                            ("error=u_a.e_q:x", ("error", "u_a.e_q", "x"))):
            self.assertEqual(wave_picture.split_name(text), parts)
        with self.assertRaisesRegex(Refused, "format q is none of d, u, x, b"):
            wave_picture.split_name("e_q:q")

    def test_clocks_far_from_a_change_are_one_gap(self):
        row = [0] * 4 + [1] * 12 + [2] * 2
        self.assertEqual(wave_picture.drawn_cells([row], 1),
                         [0, 1, 2, 3, 4, 5, None, 15, 16, 17])
        self.assertEqual(wave_picture.drawn_cells([[0] * 3], 1), [0, 1, 2])
