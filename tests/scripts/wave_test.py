#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""trammel wave on small files written by hand: what it finds, draws and refuses."""

import contextlib
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools
from trammel_tools.paths import ROOT, TOOL
from trammel_tools.waves import wave, wave_picture

HEAD = """$timescale 1ns $end
$scope module top $end
$var wire 1 ! clk_i $end
$var wire 1 " low $end
$var wire 1 # high $end
$scope module u_a[0] $end
$var wire 8 $ e [7:0] $end
$var wire 1 ! clk_i $end
$upscope $end
$scope module u_a[1] $end
$var wire 8 % e [7:0] $end
$upscope $end
$upscope $end
$enddefinitions $end
"""


def vcd(changes, clocks=60, head=HEAD):
    """A clock of 20 ns and these changes {time: text}, written in order."""
    events = {20 * n: "1!\n" for n in range(clocks)}
    events.update({20 * n + 10: "0!\n" for n in range(clocks)})
    for time, text in changes.items():
        events[time] = events.get(time, "") + text
    return head + "".join(f"#{time}\n{events[time]}" for time in sorted(events))


BASE = {0: '1"\n0#\nb0 $\nb1 %\n', 200: '0"\n', 1000: "1#\n", 1040: "b11111101 $\n"}


class WaveTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(dir=Path.cwd()))
        self.addCleanup(shutil.rmtree, self.folder)

    def file(self, name, changes, **more):
        path = self.folder / name
        path.write_text(vcd(changes, **more), encoding="ascii")
        return str(path)

    def run_wave(self, *words):
        """Exit code, standard output and standard error."""
        out, err = io.StringIO(), io.StringIO()
        with mock.patch.object(sys, "argv", ["wave", *map(str, words)]), \
                contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = wave.main()
            except SystemExit as end:
                code = end.code
        return code, out.getvalue(), err.getvalue()

    def refused(self, *words):
        """The one line on stderr of a call that ends with 2."""
        code, out, err = self.run_wave(*words)
        self.assertEqual((code, out, err.count("\n")), (2, "", 1), err)
        return err

    def draw(self, file, *words):
        target = self.folder / "p.svg"
        code, _, err = self.run_wave("draw", file, *words, "-o", target)
        self.assertEqual((code, err), (0, ""))
        svg = target.read_text(encoding="utf-8")
        self.assertIn("<svg", svg)
        picture = json.loads(target.with_suffix(".json").read_text(encoding="utf-8"))
        return {lane["name"]: lane for lane in picture["signal"]}, picture, svg

    def test_a_name_may_begin_at_any_scope_and_an_index_is_no_wild_card(self):
        file = self.file("a.vcd", BASE)
        _, out, _ = self.run_wave("list", file)
        self.assertEqual(out.split(), ["top.clk_i", "top.high", "top.low", "top.u_a[0].clk_i",
                                       "top.u_a[0].e[7:0]", "top.u_a[1].e[7:0]"])
        self.assertEqual(self.run_wave("list", file, "--signals", "u_a[0].*")[1].split(),
                         ["top.u_a[0].clk_i", "top.u_a[0].e[7:0]"])
        self.assertEqual(self.run_wave("list", file, "--signals", "e")[1].count("\n"), 2)

    def test_equal_values_are_equal_whatever_the_file_repeats(self):
        one = self.file("a.vcd", BASE)
        two = self.file("b.vcd", {**BASE, 600: '0"\nb1 %\n'})
        self.assertEqual(self.run_wave("compare", one, two)[:2], (0, "equal: 5 signals\n"))

    def test_the_first_differences_come_in_order_of_time_with_names_and_values(self):
        one = self.file("a.vcd", BASE)
        two = self.file("b.vcd", {**BASE, 1000: "", 1040: "b101 $\n", 300: "b111 %\n"})
        code, out, _ = self.run_wave("compare", one, two)
        self.assertEqual(code, 1)
        self.assertEqual(out.split("\n")[:4],
                         ["300 ns            top.u_a[1].e: 1 and 7",
                          "1 us              top.high: 1 and 0",
                          "1.04 us           top.u_a[0].e: 253 and 5",
                          "3 of 5 signals differ, 0 are in one file only"])
        self.assertEqual(self.run_wave("compare", one, two, "--signals", "low")[0], 0)
        self.assertEqual(self.run_wave("compare", one, two, "--first", "1")[1].count("\n"), 2)
        code, out, _ = self.run_wave("compare", one, two, "--json")
        document = json.loads(out)
        self.assertEqual((code, document["differing"], document["equal"]), (1, 3, False))
        self.assertEqual(document["first"][0],
                         {"t_s": 3e-7, "signal": "top.u_a[1].e", "a": 1, "b": 7})

    def test_a_change_that_comes_later_in_one_file_shows_what_each_holds_until_then(self):
        one = self.file("a.vcd", BASE)
        for moved, told in (({1000: "", 1100: "1#\n"}, "1 us              top.high: 1 and 0"),
                            ({1000: "", 900: "1#\n"}, "900 ns            top.high: 0 and 1")):
            two = self.file("b.vcd", {**BASE, **moved})
            code, out, _ = self.run_wave("compare", one, two)
            self.assertEqual((code, out.split("\n")[0]), (1, told))

    def test_only_the_window_counts_with_the_values_it_begins_with(self):
        one = self.file("a.vcd", BASE)
        two = self.file("b.vcd", {**BASE, 200: "", 300: '0"\n'})
        self.assertEqual(self.run_wave("compare", one, two, "--window", "0:200ns")[0], 0)
        self.assertEqual(self.run_wave("compare", one, two, "--window", "0:220ns")[0], 1)
        self.assertEqual(self.run_wave("compare", one, two, "--window", "250ns:290ns")[0], 1)
        self.assertEqual(self.run_wave("compare", one, two, "--window", "300ns:1us")[0], 0)
        self.assertEqual(self.run_wave("compare", one, two, "--window", "15clk:50clk")[0], 0)

    def test_files_of_other_time_steps_compare_by_time(self):
        one = self.file("a.vcd", BASE)
        fine = vcd({1000 * time: text for time, text in BASE.items()}, clocks=0,
                   head=HEAD.replace("1ns", "1ps"))
        two = self.folder / "b.vcd"
        two.write_text(fine, encoding="ascii")
        self.assertEqual(self.run_wave("compare", one, two, "--signals", "low", "high", "e")[0], 0)

    def test_a_signal_of_one_file_only_is_a_difference(self):
        one = self.file("a.vcd", BASE)
        two = self.file("b.vcd", BASE, head=HEAD.replace(" low ", " lower "))
        code, out, _ = self.run_wave("compare", one, two)
        self.assertEqual(code, 1)
        self.assertIn(f"only in {one}: top.low\n", out)
        self.assertIn(f"only in {two}: top.lower\n", out)

    def test_conversion_keeps_every_value_both_ways(self):
        file = self.file("a.vcd", BASE)
        fst, back = self.folder / "a.fst", self.folder / "back.vcd"
        self.assertEqual(self.run_wave("convert", file, fst)[0], 0)
        self.assertEqual(self.run_wave("convert", fst, back)[0], 0)
        self.assertEqual(self.run_wave("compare", file, fst)[0], 0)
        self.assertEqual(self.run_wave("compare", file, back)[0], 0)
        self.assertEqual(len(list(self.folder.iterdir())), 3)  # nothing half made

    def test_a_picture_shows_a_clock_a_cell_and_leaves_out_what_rests(self):
        lanes, picture, svg = self.draw(
            self.file("a.vcd", BASE), "--window", "8clk:54clk", "--signals", "off=low", "on=high",
            "e=u_a[0].e:d", "--measure", "off", "on", "--title", "dead time")
        self.assertEqual(lanes["clock"]["wave"], "3....|3.....")
        self.assertEqual(lanes["clock"]["data"], ["8", "+40"])
        self.assertEqual(lanes["clk_i"]["wave"], "p....|......")
        self.assertEqual(lanes["off"]["wave"], "1.0..|......")
        self.assertEqual(lanes["on"]["wave"], "0....|..1...")
        self.assertEqual(lanes["e"]["wave"], "=....|....=.")
        self.assertEqual(lanes["e"]["data"], ["0", "-3"])
        self.assertEqual(picture["edge"], ["A<~>B 40 clk"])
        self.assertEqual(lanes["off"]["node"].index("A"), 2)
        self.assertEqual(lanes["on"]["node"].index("B"), 8)
        self.assertIn("40 clk", svg)
        self.assertIn("dead time", svg)

    def test_a_short_rest_is_drawn_and_a_longer_one_is_a_gap(self):
        for clock, drawn in ((16, "1.0.....1..|"), (18, "1.0.......1..|"), (19, "1.0..|..1..|")):
            file = self.file("a.vcd", {0: '1"\n0#\n', 200: '0"\n', 20 * clock: '1"\n'})
            lanes, _, _ = self.draw(file, "--window", "8clk:54clk", "--signals", "low")
            self.assertEqual(lanes["low"]["wave"], drawn)

    def test_a_measure_ends_after_it_began(self):
        file = self.file("a.vcd", {0: '1"\n0#\n', 200: '0"\n1#\n', 400: "0#\n"})
        _, picture, _ = self.draw(file, "--window", "8clk:54clk", "--signals", "low", "high",
                                  "--measure", "low", "high")
        self.assertEqual(picture["edge"], ["A<~>B 10 clk"])

    def test_formats_of_values(self):
        self.assertEqual([wave_picture.value_text(0xfd, 8, k) for k in ("d", "u", "x", "b", "")],
                         ["-3", "253", "fd", "11111101", "fd"])
        self.assertEqual(wave_picture.value_text(None, 8, "d"), "?")
        self.assertEqual(wave_picture.value_text("10xx", 4, "d"), "10xx")

    def test_broken_and_missing_files_are_told_in_one_line(self):
        for name, content in (("empty.vcd", b""), ("text.vcd", b"hello\n" * 50),
                              ("cut.fst", bytes(range(256)) * 4),
                              ("half.vcd", vcd(BASE).encode()[:150]),
                              ("bits.vcd", vcd({**BASE, 400: "b01zz9 $\n"}).encode())):
            path = self.folder / name
            path.write_bytes(content)
            with self.subTest(name):
                good = self.file("good.vcd", BASE)
                self.assertIn(str(path), self.refused("compare", path, good))
        self.assertIn("No such file", self.refused("list", self.folder / "no.fst"))
        self.assertIn("is a folder", self.refused("list", self.folder))
        os.mkfifo(self.folder / "fifo")
        for name in self.folder / "fifo", "/dev/zero":  # whose reading would not end
            self.assertIn("not a regular file", self.refused("list", name))

    def test_a_picture_replaces_no_file_that_is_not_one(self):
        file = self.file("a.vcd", BASE)
        words = ["draw", file, "--window", "0:1us", "--signals", "low", "-o"]
        victim = self.folder / "victim"
        victim.write_text("mine", encoding="ascii")
        for name in "a.svg", "b.json":
            (self.folder / name).symlink_to(victim)
        os.mkfifo(self.folder / "c.json")
        for name in "a.svg", "b.svg", "c.svg":
            self.assertIn("not a regular file", self.refused(*words, self.folder / name))
        self.assertEqual(victim.read_text(encoding="ascii"), "mine")
        self.assertEqual(len(list(self.folder.iterdir())), 5)
        run = self.folder / "r"
        run.mkdir()
        for name, text in (("run.json", '{"trammel": "1", "files": {"metrics.json": {}}}'),
                           ("metrics.json", '{"signal": []}')):
            (run / name).write_text(text, encoding="ascii")
            self.assertIn("of a run's record", self.refused(*words, run / f"{name[:-5]}.svg"))
            self.assertEqual((run / name).read_text(encoding="ascii"), text)
        self.assertEqual(len(list(run.iterdir())), 2)

    def test_only_wavejson_of_a_picture_is_replaced(self):
        file = self.file("a.vcd", BASE)
        source = self.folder / "p.json"
        words = ["draw", file, "--window", "0:1us", "--signals", "low", "-o", self.folder / "p.svg"]
        for text in ('{"signal": []}', '{"a": 1}', '[1]', '"signal"', "3", "mine", "", "[" * 100000,
                     '{"signal": 1}', '{"signal": [\n  {"name": "mine"}]}\n'):
            source.write_text(text, encoding="ascii")
            self.assertIn("p.json: is not of the form that draw writes", self.refused(*words))
            self.assertEqual(source.read_text(encoding="ascii"), text)
            self.assertFalse((self.folder / "p.svg").exists())
        source.write_bytes(b"\xff")
        self.assertIn("is not of the form", self.refused(*words))
        source.unlink()
        for signal in "low", "high":
            self.assertIn(signal, self.draw(file, "--window", "0:1us", "--signals", signal)[0])
        for picture in sorted((ROOT / "docs" / "pictures").glob("*.json")):
            self.assertTrue(wave_picture.is_own(picture), picture)

    def test_a_conversion_replaces_regular_files_only(self):
        file = self.file("a.vcd", BASE)
        fst = self.folder / "a.fst"
        self.assertEqual(self.run_wave("convert", file, fst)[0], 0)
        self.assertEqual(self.run_wave("convert", file, fst)[0], 0)
        victim = self.folder / "victim"
        victim.write_text("mine", encoding="ascii")
        for name in ("x.vcd", "x.fst", f".y.vcd.{os.getpid()}", f".y.fst.{os.getpid()}",
                     "y.fst.hier"):
            (self.folder / name).symlink_to(victim)
        os.mkfifo(self.folder / "f.vcd")
        for name in "x.vcd", "f.vcd":
            self.assertIn("not a regular file", self.refused("convert", fst, self.folder / name))
        self.assertIn("not a regular file", self.refused("convert", file, self.folder / "x.fst"))
        self.assertEqual(self.run_wave("convert", fst, self.folder / "y.vcd")[0], 0)
        self.assertEqual(self.run_wave("convert", file, self.folder / "y.fst")[0], 0)
        self.assertEqual(victim.read_text(encoding="ascii"), "mine")
        self.assertTrue((self.folder / "y.vcd").is_file())
        self.assertFalse((self.folder / "y.vcd").is_symlink())
        (self.folder / "waves.fst").write_text("a record's", encoding="ascii")
        self.assertIn("of a run's record",
                      self.refused("convert", file, self.folder / "waves.fst"))

    def test_what_xml_cannot_hold_is_escaped_in_a_picture(self):
        lanes, picture, svg = self.draw(
            self.file("a.vcd", BASE), "--window", "0:1us", "--title", "a\nb\x1b<&\udcff",
            "--signals", "a\x1b]0;x=low", "b\ufffe<&=high")
        self.assertEqual(list(lanes)[2:], ["a\\u001b]0;x", "b\\ufffe<&"])
        self.assertEqual(picture["head"]["text"], "a\\u000ab\\u001b<&\\xff")
        words = "".join(xml.etree.ElementTree.fromstring(svg).itertext())
        for seen in *list(lanes)[2:], picture["head"]["text"]:
            self.assertIn(seen, words)

    def test_a_time_step_of_nothing_is_refused(self):
        path = self.file("zero.vcd", BASE, head=HEAD.replace("1ns", "0ns"))
        self.assertIn("time step is 0", self.refused("compare", path, path, "--window", "0:1us"))

    def test_names_are_shown_without_control_characters(self):
        path = self.file("odd.vcd", BASE, head=HEAD.replace("low", "lo\x1b[31mw"))
        done = subprocess.run([sys.executable, TOOL, "wave", "list", path], capture_output=True,
                              text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("lo\\u001b[31mw", done.stdout)
        self.assertNotIn("\x1b", done.stdout)

    def test_a_reader_that_panics_says_nothing_itself(self):
        path = self.folder / "bits.vcd"
        path.write_text(vcd({**BASE, 400: "b01zz9 $\n"}), encoding="ascii")
        done = subprocess.run([sys.executable, TOOL, "wave", "compare", path, path],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)

    def test_what_cannot_be_is_told_in_one_line(self):
        file = self.file("a.vcd", BASE)
        picture = ["-o", self.folder / "p.svg"]
        gap = {time: text for time, text in BASE.items() if time < 1000}
        gap[90000] = "1!\n"
        for words, told in (
                (("list", file, "--signals", "u_b[0].e"), "did you mean u_a[0].e?"),
                (("compare", file, file, "--window", "2us:1us"), "a before b"),
                (("compare", file, file, "--window", "1ms:2ms"), "holds 0 ns to 1.19 us"),
                (("compare", file, file, "--window", "1parsec:2us"), "--window: value"),
                (("compare", file, file, "--window", "0:1e400s"), "--window: value 0:1e400s"),
                (("list", file, "--signals", "a\nb"), "a\\u000ab: no such signal"),
                (("draw", file, "--window", "1ms:2ms", "--signals", "low", *picture), "outside"),
                (("draw", self.file("g.vcd", gap), "--window", "0:1ms", "--signals", "low",
                  *picture), "have a gap"),
                (("draw", file, "--window", "0:1us", "--signals", "e", *picture),
                 "2 signals end so"),
                (("draw", file, "--window", "0:1us", "--signals", "low:q", *picture), "format q"),
                (("draw", file, "--window", "0:1us", "--signals", "low", "--measure", "low", "hi",
                  *picture), "none of the drawn: low"),
                (("draw", file, "--window", "0:1us", "--signals", "low", "high", "--measure",
                  "high", "low", *picture), "do not change after each other"),
                (("draw", file, "--window", "0:1us", "--signals", "low", "low", *picture),
                 "two are called low"),
                (("draw", file, "--window", "0:1us", "--signals", "low", "-o", "p.png"), ".svg"),
                (("convert", file, self.folder / "b.vcd"), "only .fst to .vcd"),
                (("convert", file, self.folder / "no" / "b.fst"), "cannot be written"),
                (("list",), "see trammel wave list --help"),
                (("lst", file), "invalid choice: 'lst'")):
            with self.subTest(told):
                self.assertIn(told, self.refused(*words))
        self.assertFalse((self.folder / "p.svg").exists())

    def test_a_missing_converter_is_told_apart(self):
        file = self.file("a.vcd", BASE)
        with mock.patch("shutil.which", return_value=None):
            code, _, err = self.run_wave("convert", file, self.folder / "b.fst")
        self.assertEqual((code, err), (3, "wave: vcd2fst is missing (trammel doctor)\n"))


if __name__ == "__main__":
    python_tools.need("pywellen", "wave_test.py")
    unittest.main()
