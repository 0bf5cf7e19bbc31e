# SPDX-License-Identifier: Apache-2.0
"""Plans of sweeps: what they run, and what is refused. plan_test.py PROGRAM (which is not used)."""

import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from trammel.sweep import Plan, PlanError
from trammel.sweep.plan import MOST_BYTES, Axis

HEAD = 'scenario = "circle"\n'


def plan(text, **files):
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            Path(folder, name).write_text(content)
        file = Path(folder, "plan.toml")
        file.write_text(text)
        return Plan(file)


def values(found, key):
    return np.array([found.run(n)[1][key] for n in range(found.count)])


class Points(unittest.TestCase):
    def test_values_at_the_shares_of_a_distribution(self):
        for axis, shares, wanted in (
                (Axis("a", (), "uniform", 2, 6), (0, 0.25, 1), (2, 3, 6)),
                (Axis("a", (), "uniform", 1, 3, True), (0, 0.5, 0.999), (1, 2, 3)),
                (Axis("a", (), "log", 1, 100), (0, 0.5, 1), (1, 10, 100)),
                (Axis("a", (), "normal", 10, 2), (0.5, 0.8413447, 0.0227501), (10, 12, 6))):
            np.testing.assert_allclose(axis.at(np.array(shares)), wanted, rtol=1e-6,
                                       err_msg=str(axis))
        ends = Axis("a", (), "normal", 10, 2).at(np.array([0.0, 1.0]))
        self.assertTrue(np.isfinite(ends).all(), ends)
        self.assertAlmostEqual(ends.sum(), 20, places=3)

    def test_the_least_of_everything_is_taken(self):
        found = plan("seed = 0\n" + HEAD + '[grid]\ncontroller = ["fc"]\n"gains.kp" = {from = 0.1, '
                     'to = 0.2, count = 2}\n[random]\ncount = 1\n"plant.payload_kg" = [1.0, 2.0]\n')
        self.assertEqual((found.count, found.varied),
                         (2, ["controller", "gains.kp", "plant.payload_kg"]))
        self.assertEqual([found.run(n)[1]["gains.kp"] for n in range(2)], [0.1, 0.2])

    def test_a_scenario_beside_the_plan(self):
        found = plan('scenario = "own.toml"\n', **{"own.toml": 'description = "mine"\n'})
        file = Path(found.parts[0].scenario)
        self.assertEqual((file.is_absolute(), file.name, found.count), (True, "own.toml", 1))

    def test_a_table_in_a_parquet_file(self):
        import pyarrow
        from pyarrow import parquet
        with tempfile.TemporaryDirectory() as folder:
            parquet.write_table(pyarrow.table({"gains.kp": [0.1, 0.2]}), Path(folder, "a.parquet"))
            file = Path(folder, "plan.toml")
            file.write_text(HEAD + '[table]\nfile = "a.parquet"\n')
            self.assertEqual(values(Plan(file), "gains.kp").tolist(), [0.1, 0.2])

    def test_a_grid_is_every_combination(self):
        found = plan(HEAD + '[grid]\ncontroller = ["fc", "afc"]\n'
                     '"plant.payload_kg" = {from = 0, to = 22, count = 3}\n')
        self.assertEqual([found.run(n)[1] for n in range(found.count)], [
            {"controller": c, "plant.payload_kg": m}
            for c in ("fc", "afc") for m in (0.0, 11.0, 22.0)])

    def test_a_logarithmic_grid(self):
        found = plan(HEAD + '[grid]\n"plant.payload_kg" = {from = 0.1, to = 10, count = 3, '
                     'scale = "log"}\n')
        np.testing.assert_allclose(values(found, "plant.payload_kg"), [0.1, 1, 10])

    def test_a_latin_hypercube_has_one_value_in_each_part_of_a_range(self):
        found = plan(HEAD + '[latin]\ncount = 50\n"plant.payload_kg" = [0.0, 10.0]\n'
                     '"plant.coulomb_N" = [5.0, 15.0]\n')
        mass, friction = values(found, "plant.payload_kg"), values(found, "plant.coulomb_N")
        self.assertEqual(sorted(np.floor(mass / 10 * 50)), list(range(50)))
        self.assertEqual(sorted(np.floor((friction - 5) / 10 * 50)), list(range(50)))
        self.assertLess(abs(np.corrcoef(mass, friction)[0, 1]), 0.5)

    def test_draws_are_those_of_the_seed_and_the_key(self):
        one = '[random]\ncount = 2000\n"plant.payload_kg" = {normal = [10.0, 2.0]}\n'
        first = values(plan("seed = 3\n" + HEAD + one), "plant.payload_kg")
        more = values(plan("seed = 3\n" + HEAD + one + '"plant.coulomb_N" = {log = [1.0, 10.0]}\n'),
                      "plant.payload_kg")
        other = values(plan("seed = 4\n" + HEAD + one), "plant.payload_kg")
        np.testing.assert_array_equal(first, more)
        self.assertTrue((first != other).all())
        self.assertAlmostEqual(first.mean(), 10, delta=0.2)
        self.assertAlmostEqual(first.std(), 2, delta=0.15)

    def test_each_part_draws_its_own(self):
        for drawn in ("random", "latin"):
            part = f'[[part]]\n{HEAD}[part.{drawn}]\ncount = 40\n"plant.payload_kg" = [0.0, 9.0]\n'
            both = values(plan(part + part), "plant.payload_kg")
            self.assertTrue((both[:40] != both[40:]).all(), drawn)
            np.testing.assert_array_equal(both[:40], values(plan(part), "plant.payload_kg"))

    def test_whole_numbers_stay_whole(self):
        found = plan(HEAD + '[random]\ncount = 400\n"run.window_clk" = [1, 4]\n')
        drawn = values(found, "run.window_clk")
        self.assertEqual(set(drawn.tolist()), {1, 2, 3, 4})
        self.assertGreater(np.bincount(drawn)[1:].min(), 60)
        for grid, wanted in (("from = 1, to = 10, count = 10", range(1, 11)),
                             ("from = 2.0, to = 8, count = 3", (2, 5, 8)),
                             ('from = 1, to = 1e5, count = 6, scale = "log"',
                              (10**k for k in range(6)))):
            found = plan(HEAD + f'[grid]\n"plant.seed" = {{{grid}}}\n')
            drawn = [found.run(n)[1]["plant.seed"] for n in range(found.count)]
            self.assertEqual((drawn, {type(v) for v in drawn}), (list(wanted), {int}))
        found = plan(HEAD + '[grid]\n"gains.shift_e" = {from = 0, to = 4, count = 3}\n')
        self.assertEqual(values(found, "gains.shift_e").tolist(), [0, 2, 4])
        found = plan(HEAD + '[random]\ncount = 9\n"plant.payload_kg" = [0, 22]\n')
        self.assertTrue((values(found, "plant.payload_kg") % 1 != 0).all())

    def test_a_table_of_own_points_with_a_grid(self):
        found = plan(HEAD + '[table]\nfile = "mine.csv"\n[grid]\ncontroller = ["fc", "afc"]\n',
                     **{"mine.csv": "plant.payload_kg,plant.coulomb_N\n1,2.5\n3,4\n"})
        self.assertEqual(found.count, 4)
        self.assertEqual(found.run(3)[1], {"controller": "afc", "plant.payload_kg": 3,
                                           "plant.coulomb_N": 4.0})

    def test_parts_are_numbered_through(self):
        found = plan('[[part]]\nscenario = "circle"\n[part.grid]\ncontroller = ["fc", "afc"]\n'
                     '[[part]]\nscenario = "window"\nengine = "rtl"\n')
        self.assertEqual((found.count, found.run(1)[0], found.run(2)), (3, 0, (1, {})))

    def test_identity_tells_plans_apart(self):
        text = HEAD + '[latin]\ncount = 5\n"plant.payload_kg" = [0.0, 10.0]\n'
        one = plan(text).identity()
        self.assertEqual(one, plan("# a comment\n" + text).identity())
        for other in (text.replace("5", "6"), text.replace("10.0", "11.0"), "seed = 2\n" + text,
                      text + '[keys]\ncontroller = "fc"\n', text.replace("circle", "window"),
                      'engine = "rtl"\n' + text, text.replace("payload_kg", "mass_kg"),
                      text.replace("latin", "random"), text + '[grid]\n"gains.kp" = [0.1]\n'):
            self.assertNotEqual(one, plan(other).identity(), other)
        grid = HEAD + '[grid]\n"gains.kp" = [0.1, 0.2]\n'
        for other in (grid.replace("0.2", "0.3"), grid.replace("0.1", "0.15")):
            self.assertNotEqual(plan(grid).identity(), plan(other).identity(), other)


class Refused(unittest.TestCase):
    def refused(self, message, text, **files):
        with self.assertRaisesRegex(PlanError, message, msg=text) as told:
            plan(text, **files)
        self.assertNotIn("\n", str(told.exception))

    def test_a_range_that_is_none(self):
        for given, message in (
                ("{from = 1, to = 1, count = 3}", "empty range: from must be below to"),
                ("{from = true, to = 3, count = 3}", "empty range"),
                ("{from = 1, to = 3, count = 1}", "count must be 2..10000000"),
                ("{from = 1, to = 3, count = 10000001}", "count must be 2..10000000"),
                ("{from = 1, to = 3, count = 2.0}", "count must be 2..10000000"),
                ('{from = 0, to = 3, count = 3, scale = "log"}', "log with from above 0"),
                ('{from = 1, to = 3, count = 3, scale = "cubic"}', "scale must be linear, or log"),
                ("{from = 1, to = 3}", "expects a list of values or"),
                ("{from = 1, to = 3, count = 3, step = 1}", "expects a list of values or"),
                ("3", "expects a list of values or"), ("[[1]]", "no list or table"),
                ("[1, {a = 1}]", "no list or table"),
                ("[-1, 2, 3]", "value -1.* is out of range 0..500"),
                ("[1, 501, 3]", "value 501.* is out of range 0..500")):
            self.refused(message, HEAD + f'[grid]\n"plant.payload_kg" = {given}\n')
        for given, message in (
                ("[2.0, 1.0]", "empty range"), ("[1.0]", "expects .low, high."),
                ("[1.0, 2.0, 3.0]", "expects .low, high."), ("[1.0, true]", "expects .low, high."),
                ("{normal = [1.0, 0.0]}", "the deviation must be above 0"),
                ("{cubic = [1.0, 2.0]}", "expects .low, high."),
                ("{log = [-1.0, 2.0]}", "log needs a range above 0"),
                ("[-1.0, 2.0]", "is out of range 0..500")):
            for name in ("latin", "random"):
                self.refused(message, HEAD + f'[{name}]\ncount = 400\n'
                             f'"plant.payload_kg" = {given}\n')
        for count in ("true", "1000000001", "1.0", '"3"'):
            self.refused(r"\[random\]: count must be 1..1000000000",
                         HEAD + f'[random]\ncount = {count}\n"plant.payload_kg" = [0.0, 1.0]\n')

    def test_a_table_that_is_none(self):
        table = HEAD + '[table]\nfile = "a.csv"\n'
        key = "plant.payload_kg,gains.kp\n"
        for text, content, message in (
                (table + "more = 1\n", key + "1,0.1\n", 'expects file = "points.csv"'),
                (table, key, "a.csv: holds no run"), (table, "", r"a.csv: \w"),
                (table, key + "1,0.1\n,0.2\n", "plant.payload_kg: run 2 of 2 has no value"),
                (table, key + "1,nan\n2,0.2\n", "gains.kp: run 1 of 2 has no value"),
                (table, key + "1,0.1\n-1,0.1\n2,0.2\n", "out of range 0..500"),
                (table, "controller\nfc\nfuzzy\nafc\n", "controller: .*fuzzy"),
                (table + '[grid]\n"gains.kp" = [0.1]\n', key + "1,0.1\n", "gains.kp: given twice"),
                (table + '[keys]\n"gains.kp" = 0.1\n', key + "1,0.1\n", "gains.kp: given twice"),
                (table + '[random]\ncount = 2\n"plant.coulomb_N" = [1, 2]\n', key + "1,0.1\n",
                 "a table and drawn points together; one part has one")):
            self.refused(message, text, **{"a.csv": content})
        self.refused("latin and random together; one part has one", HEAD + "".join(
            f'[{name}]\ncount = 2\n"{key}" = [1.0, 2.0]\n'
            for name, key in (("latin", "plant.payload_kg"), ("random", "plant.coulomb_N"))))

    def test_keys_that_every_run_would_be_refused_for(self):
        self.refused("run.audit|run.engine", HEAD + '[keys]\n"run.audit" = true\n')
        for name in ("engine", "files"):  # of the functions of the package, no keys
            self.refused(f"{name}: unknown key", HEAD + f'[keys]\n{name} = "rtl"\n')

    def test_the_part_that_is_wrong_is_named(self):
        good = '[[part]]\nscenario = "circle"\n'
        bad = good + '[part.grid]\n"gains.kp" = []\n'
        self.refused(r"plan.toml part 2 \[grid\]: gains.kp: an empty list", good + bad)
        self.refused(r"plan.toml part 1 \[grid\]: gains.kp: an empty list", bad + good)
        self.refused(r"plan.toml \[grid\]: gains.kp: an empty list", bad)
        for text in ("part = []\n", "part = 3\n", "part = [3]\n"):
            self.refused("expects one scenario, or several as", text)

    def test_a_file_that_is_too_long(self):
        text = HEAD + "#" * (MOST_BYTES - len(HEAD))
        self.assertEqual(plan(text).count, 1)
        self.refused("plan.toml: longer than 4 MiB$", text + "#")

    def test_one_line_says_what_and_where(self):
        for text, message in (
            ("scenario = 3\n", "scenario: expects a name"),
            ('scenario = "circel"\n', "did you mean circle"),
            (HEAD + "colour = 1\n", "colour: unknown"),
            (HEAD + 'engine = "fpga"\n', "run.engine: .*one of rtl, twin"),
            (HEAD + '[grid]\n"plant.mess_kg" = [1]\n', "unknown key; did you mean plant.mass_kg"),
            (HEAD + '[grid]\n"plant.payload_kg" = []\n', "empty list"),
            (HEAD + '[grid]\n"plant.payload_kg" = {from = 2, to = 1, count = 3}\n', "empty range"),
            (HEAD + '[grid]\n"plant.payload_kg" = [1, 1e9]\n', "out of range 0..500"),
            (HEAD + '[grid]\n"plant.seed" = {from = 1, to = 10, count = 7}\n',
             r"\[grid\]: plant.seed: takes whole numbers; 7 values from 1 to 10 have 2.5, 5.5, 8.5 "
             "among them$"),
            (HEAD + '[grid]\n"plant.seed" = {from = 1, to = 10, count = 8}\n',
             "have 2.28571, 3.57143, 4.85714, ... among them$"),
            (HEAD + '[grid]\n"plant.seed" = [1.5]\n', '"1.5" is not a whole number'),
            (HEAD + '[latin]\ncount = 3\n"plant.payload_kg" = [1.0, 1.0]\n', "empty range"),
            (HEAD + '[latin]\ncount = 0\n"plant.payload_kg" = [1.0, 2.0]\n', "count must be"),
            (HEAD + '[latin]\ncount = 3\n', "names no key"),
            (HEAD + '[random]\ncount = 9\n"plant.payload_kg" = [0.0, 9e9]\n', "out of range"),
            (HEAD + '[random]\ncount = 9\n"plant.payload_kg" = {log = [0.0, 1.0]}\n', "above 0"),
            (HEAD + '[random]\ncount = 9\n"run.window_clk" = [0.0, 1.5]\n', "whole numbers"),
            (HEAD + '[keys]\ncontroller = "fc"\n[grid]\ncontroller = ["fc"]\n', "given twice"),
            (HEAD + '[table]\nfile = "none.csv"\n', "none.csv"),
            (HEAD + "[[part]]\n", "belongs in a"),
            (HEAD + "grid = 3\n", "expects a table"),
            ("seed = -1\n" + HEAD, "seed"), ("seed = true\n" + HEAD, "seed: expects a whole"),
            (HEAD + "[", "plan.toml: "),
        ):
            with self.assertRaisesRegex(PlanError, message, msg=text) as told:
                plan(text)
            self.assertNotIn("\n", str(told.exception))


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
