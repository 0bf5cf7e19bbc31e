# SPDX-License-Identifier: Apache-2.0
"""Times, windows and names of wave files, without one."""

import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from trammel_tools.waves import vcd, wave, wave_picture
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
                     "1.2.3:4", "", "0:1e400s", "0:1e308s", "0:-1e400", "1e400:1e401", "0:1e400clk",
                     "nan:1", "0:inf", "0:1\u017f"):
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


class DifferenceTest(unittest.TestCase):
    def test_values_part_at_the_first_change_that_one_has_alone(self):
        same = [(0, 1), (10, 2)]
        for one, two, wanted in (
                (same, same, None), ([], [], None),
                (same, [(0, 1), (12, 2)], (10, 2, 1)), ([(0, 1), (12, 2)], same, (10, 1, 2)),
                (same, [(0, 1)], (10, 2, 1)), (same, [(0, 1), (10, 3)], (10, 2, 3)),
                ([(0, 1)], [(0, 2)], (0, 1, 2)), ([], [(5, 1)], (5, None, 1))):
            self.assertEqual(wave.first_difference(one, two), wanted, (one, two))

    def test_differences_are_in_time_whatever_the_steps_of_the_files(self):
        changes = [{"a": [(0, 1), (10, 2)], "b": [(0, 1), (4, 3)], "c": [(0, 1), (4, 3)]},
                   {"a": [(0, 1), (12, 2)], "b": [(0, 1), (2, 3)], "c": [(0, 1), (2, 3)]}]
        files = [SimpleNamespace(step=step, changes=lambda name, scale=scale, known=known: [
                     (time * scale, value) for time, value in known[name]],
                     identity=lambda name: {"c": "b"}.get(name, name))
                 for step, scale, known in ((2, 1, changes[0]), (1, 2, changes[1]))]
        found, compared = wave.differences(*files, ["a", "b", "c"],
                                           [(0, float("inf"))] * 2)
        self.assertEqual((found, compared), ([(4, "b", 1, 3), (20, "a", 2, 1)], 2))


class VcdTest(unittest.TestCase):
    def test_each_signal_has_a_short_name_of_its_own(self):
        self.assertEqual([vcd.code(n) for n in (0, 93, 94, 95)], ["!", "~", '!"', '""'])
        self.assertEqual(len({vcd.code(n) for n in range(20000)}), 20000)

    def test_a_file_has_each_change_once_and_the_clock_in_every_period(self):
        columns = {vcd.Signal("t.u.b", 4): [3, 3, 5], vcd.Signal("t.a", 1): [0, 1, 1]}
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "a.vcd")
            vcd.write(file, "t.clk_i", columns)
            self.assertEqual(file.read_text().splitlines(), [
                "$timescale 1ns $end", "$scope module t $end", "$var wire 1 # a $end",
                "$var wire 1 ! clk_i $end", "$scope module u $end", '$var wire 4 " b [3:0] $end',
                "$upscope $end", "$upscope $end", "$enddefinitions $end",
                "#0", "1!", 'b11 "', "0#", "#10", "0!", "#20", "1!", "1#", "#30", "0!",
                "#40", "1!", 'b101 "', "#50", "0!", "#60"])
            vcd.write_view(Path(folder, "a.gtkw"), file, "a title",
                           {"One": list(columns), "None": []}, (20, 920), 40)
            lines = Path(folder, "a.gtkw").read_text().splitlines()
        self.assertEqual([lines[n] for n in (0, 3, 6)],
                         ["[*] a title", "[timestart] 20", "*-0.000000 40 -1"])
        self.assertEqual(lines[-6:], ["@200", "-One", "@22", "t.u.b[3:0]", "@28", "t.a"])


class WavePictureTest(unittest.TestCase):
    def test_a_value_is_shown_in_its_format(self):
        for value, kind, text in ((None, "d", "?"), ("z", "", "z"), (0xf, "d", "-1"), (7, "d", "7"),
                                  (8, "d", "-8"), (5, "b", "0101"), (10, "x", "a"), (10, "", "a"),
                                  (10, "u", "10")):
            self.assertEqual(wave_picture.value_text(value, 4, kind), text, (value, kind))

    def test_a_clock_shows_what_stands_behind_its_edge(self):
        changes = [(0, 1), (10, 2), (20, 3), (25, 4)]
        for clocks, values in (([10, 20, 30], [2, 3, 4]), ([5, 15], [1, 2]), ([24, 25], [3, 4])):
            window = clocks[0], clocks[-1] + 1
            self.assertEqual(wave_picture.at_clocks(changes, window, clocks), values)

    def test_a_row_has_a_letter_where_its_value_changes(self):
        lane = wave_picture.lane("a", [0, 0, 1, 1, 0], [0, 1, 2, None, 4], str)
        self.assertEqual(lane, {"name": "a", "wave": "0.1|0"})
        file = SimpleNamespace(bits={"top.a": 1, "top.b": 4}.get)
        self.assertEqual(wave_picture.signal_lane(file, "a", "top.a", "", [0, None, 1], [0, 1, 2]),
                         {"name": "a", "wave": "0x1"})
        self.assertEqual(wave_picture.signal_lane(file, "b", "top.b", "d", [15, 15, 3], [0, 1, 2]),
                         {"name": "b", "wave": "=.=", "data": ["-1", "3"]})
        self.assertEqual(wave_picture.clock_lanes("clk_i", [0, 1, None, 8, 9], 100), [
            {"name": "clock", "wave": "3.|3.", "data": ["100", "+8"]},
            {"name": "clk_i", "wave": "p.|.."}])

    def test_an_arrow_goes_from_a_change_to_the_next_of_another(self):
        picked = [("a", "t.a", "", [0, 0, 1, 1, 1]), ("b", "t.b", "", [0, 0, 1, 1, 0]),
                  ("c", "t.c", "", [0] * 5)]
        lanes = [{"name": label} for label, *_ in picked]
        edges = wave_picture.measure(lanes, picked, [0, 1, 2, None, 4], [("a", "b")])
        self.assertEqual(edges, ["A<~>B 2 clk"])
        self.assertEqual(lanes, [{"name": "a", "node": "..A.."}, {"name": "b", "node": "....B"},
                                 {"name": "c"}])
        for pair, message in ((("a", "c"), "do not change after each other"),
                              (("c", "a"), "do not change after each other"),
                              (("a", "d"), "d is none of the drawn: a, b, c")):
            with self.assertRaisesRegex(Refused, message):
                wave_picture.measure(lanes, picked, [0, 1, 2, 3, 4], [pair])

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
