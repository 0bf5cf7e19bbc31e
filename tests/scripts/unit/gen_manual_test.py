# SPDX-License-Identifier: Apache-2.0
"""Pages that are made of what the program says."""

import unittest

from trammel_tools.generate import figures_page, gen_manual


def key(name, default, text="a gain", limits="0 to 1"):
    return {"key": name, "default": default, "range": limits, "help": text}


class GenManualTest(unittest.TestCase):
    def test_the_longest_end_of_a_name_is_its_unit(self):
        for name, unit in (("x_m", "m"), ("v_m_s", "m/s"), ("v_max_m_s", "m/s"), ("kt_N_A", "N/A"),
                           ("limit_m_max", "m"), ("gain", ""), ("plant.mass_kg", "kg")):
            self.assertEqual(gen_manual.unit(name), unit, name)

    def test_axes_of_one_key_are_one_row(self):
        text = gen_manual.sections_text([key("name", "circle"), key("gains.x.kp", "1"),
                                         key("gains.y.kp", "1"), key("gains.x.ki", "2"),
                                         key("gains.y.ki", "3"), key("gains.mode", "a|b", "<or>")])
        self.assertIn("\n## run\n", text)
        self.assertEqual([line for line in text.split("\n") if line.startswith("| `gains")], [
            "| `gains.[x.\\|y.]kp` | 1 |  | 0 to 1 | a gain |",
            "| `gains.[x.\\|y.]ki` | x 2, y 3 |  | 0 to 1 | a gain |",
            "| `gains.mode` | a\\|b |  | 0 to 1 | &lt;or&gt; |"])

    def test_columns_of_both_axes_are_one_row(self):
        names = ("t_s", "x_e", "x_lone", "y_e", "v|w")
        text = gen_manual.column_rows([{"column": name, "unit": "<m>", "help": f"of {name[-1]}"}
                                       for name in names])
        self.assertEqual(text.split("\n"), [
            "| `t_s` | &lt;m&gt; | of s |", "| `[x_\\|y_]e` | &lt;m&gt; | of e |",
            "| `x_lone` | &lt;m&gt; | of e |", "| `v|w` | &lt;m&gt; | of w |", ""])

    def test_only_the_text_between_the_marks_is_replaced(self):
        page = "a\n<!-- begin x -->\nold\n<!-- end x -->\nb\n"
        self.assertEqual(gen_manual.replaced(page, "x", "new\n"), page.replace("old", "new"))
        for broken in ("a\n", page.replace("end", "stop")):
            with self.assertRaisesRegex(gen_manual.NotSaid, "no lines <!-- begin x --> and"):
                gen_manual.replaced(broken, "x", "new\n")

    def test_a_command_that_fails_says_nothing(self):
        with self.assertRaisesRegex(gen_manual.NotSaid, "exit 3: the last line"):
            gen_manual.said("sh", "-c", "echo first >&2; echo the last line >&2; exit 3")


def figure(name, **more):
    return {"id": name, "name": name.replace("x.", "X "), "value": 1, "unit": "m", **more}


class FiguresPageTest(unittest.TestCase):
    def rows(self, runs, cuts):
        return [(row[0], *row[3:]) for row in figures_page.rows_of(runs, cuts, "m")]

    def test_a_figure_is_listed_once_with_the_scenarios_that_report_it(self):
        runs = {"m-a": [figure("t"), figure("e", digits=3, tile="E")],
                "b": [figure("t", shown=False), figure("n.1"), figure("n.2")]}
        self.assertEqual(self.rows(runs, {"m-a": [figure("t")], "b": []}), [
            ("t", "whole", "", "a; hidden: b; cut: a"), ("e", "3", "E", "a; cut: none"),
            ("n.[1..2]", "whole", "", "b; cut: none")])

    def test_an_order_that_differs_between_scenarios_or_axes_is_told(self):
        with self.assertRaisesRegex(figures_page.Contradiction, "in another order: t, e"):
            figures_page.merged([["t", "e"], ["e", "t"]])
        axes = [figure("x.t"), figure("x.e"), figure("y.e"), figure("y.t")]
        for one in axes[2:]:
            one["name"] = one["name"].replace("y.", "Y ")
        with self.assertRaisesRegex(figures_page.Contradiction, "another order than those of X"):
            self.rows({"a": axes}, {"a": axes})
        self.assertEqual(len(self.rows({"a": axes[:3]}, {"a": axes[:3]})), 2)

    def test_expected_values_stand_with_tolerance_and_source(self):
        judged = figure("t", printed=2.05, expected=2.1, tolerance=0.0683, source="Kung")
        self.assertEqual(figures_page.expected_rows({"a": [judged], "b": [figure("t")]}, "m"),
                         [("t", "2.05", "2.1", "0.0683", "Kung", "a")])
