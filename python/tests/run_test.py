# SPDX-License-Identifier: Apache-2.0
"""The package gives what the program gives: run_test.py PROGRAM."""

import contextlib
import importlib.util
import io
import json
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from interrupt import interrupt

import trammel
from trammel import _core, command_line
from trammel.results import Column, Result
from trammel.run_settings import text_of

PROGRAM = ""


def by_program(folder, scenario, *words):
    """Files of a run that the program made; what it ended with."""
    return subprocess.run([PROGRAM, "run", scenario, *words, "--no-report", "-o", folder],
                          capture_output=True, text=True, check=False)


def trace(result):
    """The text of trace.csv, made of the arrays."""
    columns = list(result.columns.values())
    lines = [",".join(result)]
    for row in zip(*(result[c.name].tolist() for c in columns)):
        lines.append(",".join(c.text(value) for c, value in zip(columns, row)))
    return "\n".join(lines) + "\n"


class SameAsTheProgram(unittest.TestCase):
    def check(self, scenario, **keys):
        words = [word for key, value in keys.items()
                 for word in ("-s", f"{key}={text_of(value)}")]
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch) / "run"
            by_program(folder, scenario, *words)
            metrics = json.loads((folder / "metrics.json").read_text())
            result = trammel.run(scenario, **keys)
            self.assertEqual(trace(result), (folder / "trace.csv").read_text())
            self.assertEqual(result.event_hash, metrics["run"]["event_hash"])
            self.assertEqual((result.end, result.verdict), (metrics["end"], metrics["verdict"]))
            listed = {f["id"]: (f["value"], f["unit"]) for f in metrics["figures"]}
            self.assertEqual({place: (float(f), f.unit) for place, f in result.figures.items()},
                             listed)
            for one in metrics["figures"]:
                figure = result.figures[one["id"]]
                self.assertEqual((figure.name, figure.expected, figure.printed, figure.source),
                                 (one["name"], one.get("expected"), one.get("printed"),
                                  one.get("source", "")))
                if "expected" in one:
                    self.assertEqual((figure.tolerance, figure.good),
                                     (one["tolerance"], one["within"]), one["id"])
            self.assertEqual(result.simulated_s, metrics["run"]["simulated_s"])
            self.assertEqual({name: one.end for name, one in result.companions.items()},
                             {name: one["end"]
                              for name, one in metrics.get("compared", {}).items()})
            own = Path(scratch) / "own"
            result.save(own, page=False)
            self.assertEqual((own / "trace.csv").read_bytes(),
                             (folder / "trace.csv").read_bytes())
            return result

    def test_a_whole_run_with_each_engine(self):
        for engine in ("rtl", "twin"):
            result = self.check("circle", **{"run.engine": engine, "plant.x.payload_kg": 11,
                                             "gains.feedforward": True})
            self.assertTrue(result.ok)
            self.assertEqual(result.end, "done")

    def test_a_cut_run_of_each_machine(self):
        tried = set()
        for scenario in trammel.scenarios():
            machine = trammel.settings(scenario).machine
            if machine not in tried:
                tried.add(machine)
                self.check(scenario, **{"run.max_s": 0.05})
        self.assertEqual(sorted(tried), sorted(_core.machines()))

    def test_a_run_by_systemc_has_the_same_events(self):
        keys = {"run.max_s": 0.1}
        other = trammel.run("circle", **keys, **{"run.platform": "systemc"})
        self.assertEqual(trammel.run("circle", **keys).event_hash, other.event_hash)


class Wrong(unittest.TestCase):
    def test_a_value_out_of_range_has_key_and_range(self):
        with self.assertRaises(trammel.SettingError) as told:
            trammel.run("circle", **{"plant.x.payload_kg": 1e9})
        error = told.exception
        self.assertEqual((error.key, error.value, error.range),
                         ("plant.x.payload_kg", 1e9, "0..500"))
        self.assertNotIn("\n", str(error))
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.key, again.value, again.range),
                         (str(error), error.key, error.value, error.range))
        self.assertRegex(str(error), "^plant.x.payload_kg: value 1")

    def test_an_unknown_key_has_a_suggestion(self):
        with self.assertRaisesRegex(trammel.SettingError, "did you mean controller") as told:
            trammel.run("circle", controler="fc")
        self.assertEqual((told.exception.key, told.exception.range), ("controler", None))

    def test_keys_that_do_not_fit_together(self):
        with self.assertRaises(trammel.SettingError) as told:
            trammel.run("circle", engine="twin", **{"run.audit": True})
        error = told.exception
        self.assertRegex(str(error), f"^{error.key}: ")
        self.assertEqual((error.key[:4], error.value), ("run.", None))
        keys = trammel.keys(trammel.settings("circle").machine)
        self.assertEqual(error.range, keys[error.key].range)

    def test_keys_beside_settings_are_not_lost(self):
        asked = trammel.settings("circle", engine="twin", **{"run.max_s": 0.02})
        for call in (trammel.run, trammel.open):
            with self.assertRaisesRegex(trammel.SettingError, "^controller: settings") as told:
                call(asked, controller="fc")
            self.assertEqual(told.exception.key, "controller")

    def test_what_is_no_scenario(self):
        with self.assertRaisesRegex(trammel.ConfigError, "did you mean circle"):
            trammel.run("circel")
        with self.assertRaisesRegex(trammel.ConfigError, "cannot be read|No such file"):
            trammel.run("no/such/file.toml")
        self.assertRaises(trammel.SettingError, trammel.run, "circle", controller=None)
        with self.assertRaises(trammel.SettingError) as told:
            trammel.keys("nothing")
        self.assertEqual(str(told.exception), "nothing: no such machine; there are "
                         + ", ".join(_core.machines()))

    def test_a_folder_of_others_is_kept(self):
        result = trammel.run("circle", engine="twin", **{"run.max_s": 0.02})
        with tempfile.TemporaryDirectory() as scratch:
            (Path(scratch) / "mine.txt").write_text("mine")
            self.assertRaises(trammel.ConfigError, result.save, scratch)
            self.assertEqual(os.listdir(scratch), ["mine.txt"])
            self.assertRaises(trammel.ConfigError, result.report, f"{scratch}/mine.txt/page.html")

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_a_full_disk(self):
        result = trammel.run("circle", engine="twin", **{"run.max_s": 0.02})
        with self.assertRaisesRegex((trammel.ConfigError, OSError), "No space left"):
            result.write_trace("/dev/full")


class Beside(unittest.TestCase):
    """Threads, signals and callbacks."""

    def test_two_threads_give_what_two_runs_in_a_row_give(self):
        for engine in ("rtl", "twin"):
            asked = [{"controller": c, "run.max_s": 0.3} for c in ("fc", "afc")]
            alone = [trammel.run("circle", engine=engine, **keys) for keys in asked]
            beside = [None, None]

            def one(n, engine=engine, asked=asked, beside=beside):
                beside[n] = trammel.run("circle", engine=engine, **asked[n])

            threads = [threading.Thread(target=one, args=(n,)) for n in range(2)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            self.assertNotEqual(alone[0].event_hash, alone[1].event_hash)
            for first, second in zip(alone, beside):
                self.assertEqual(first.event_hash, second.event_hash)
                for name in first:
                    self.assertEqual(first[name].tobytes(), second[name].tobytes(), name)

    def test_other_threads_go_on_meanwhile(self):
        steps, over = [0], threading.Event()

        def count():
            while not over.is_set():
                steps[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = steps[0]
        trammel.run("circle", **{"run.max_s": 0.4})
        during = steps[0] - before
        over.set()
        thread.join()
        self.assertGreater(during, 10)

    def test_an_interrupt_ends_a_run(self):
        script = ("import trammel, sys\n"
                  "print('begun', flush=True)\n"
                  "try: trammel.run('circle', **{'run.leap': False})\n"
                  "except KeyboardInterrupt: print('interrupted'); sys.exit(7)\n")
        self.assertEqual(interrupt(script, 20), ("begun\ninterrupted\n", 7))

    def test_progress_is_told_and_what_it_raises_ends_the_run(self):
        told = []
        trammel.run("circle", progress=told.append)
        self.assertEqual(told[-1], 1.0)
        self.assertEqual(told, sorted(told))

        def raise_it(fraction):
            raise ZeroDivisionError(fraction)

        begun = time.monotonic()
        self.assertRaises(ZeroDivisionError, trammel.run, "circle", progress=raise_it,
                          **{"run.leap": False})
        self.assertLess(time.monotonic() - begun, 15)


class Texts(unittest.TestCase):
    def test_a_figure_is_shown_with_its_unit(self):
        self.assertEqual(repr(trammel.Figure(2.3456789, "mm")), "2.34568 mm")
        self.assertEqual(repr(trammel.Figure(3)), "3")
        for value in 2.5, 1.5:
            figure = trammel.Figure(value, expected=2, tolerance=0.5)
            self.assertTrue(figure.good, f"{value} of 2 with a tolerance of 0.5 is good")

    def test_a_column_is_printed_with_its_digits(self):
        for digits, text in ((None, "12"), (0, "12"), (2, "12.35"), (-3, "12.3")):
            self.assertEqual(Column("a", "", "", digits).text(12.346), text)

    def test_values_as_the_command_line_has_them(self):
        for value, text in ((True, "true"), (False, "false"), (3, "3"), (0.1, "0.1"),
                            (np.int64(3), "3"), (np.float64(0.1), "0.1"), (np.True_, "true"),
                            ("fc", "fc"), (Path("a/b"), "a/b")):
            self.assertEqual(text_of(value), text)
        with self.assertRaisesRegex(trammel.SettingError, "not list$"):
            text_of([1])

    def test_the_later_of_two_files_wins_and_a_key_over_both(self):
        with tempfile.TemporaryDirectory() as scratch:
            files = [Path(scratch, name) for name in ("a.toml", "b.toml")]
            for file, mass in zip(files, (1, 2)):
                file.write_text(f"plant.x.payload_kg = {mass}\n")
            for keys, mass in (({}, 2), ({"plant.x.payload_kg": 3}, 3)):
                asked = trammel.settings("circle", files=files, **keys)
                self.assertEqual(float(asked.values["plant.x.payload_kg"]), mass)

    def test_engine_and_wiring_are_those_asked_for_last(self):
        with tempfile.TemporaryDirectory() as scratch:
            file = Path(scratch, "a.toml")
            file.write_text('run.engine = "rtl"\nrun.platform = "systemc"\n')
            names = ("run.engine", "run.platform")
            for given, wanted in (({}, ("rtl", "direct")), ({"engine": "twin"}, ("twin", "direct")),
                                  ({"files": [file], "engine": "twin"}, ("twin", "systemc")),
                                  ({"run.platform": "systemc"}, ("rtl", "systemc")),
                                  ({"files": [file], "run.platform": "direct"}, ("rtl", "direct")),
                                  ({"engine": "twin", "run.engine": "rtl"}, ("rtl", "direct"))):
                values = trammel.settings("circle", **given).values
                self.assertEqual(tuple(values[name] for name in names), wanted, given)

    def test_what_a_record_tells_is_each_its_own(self):
        record = SimpleNamespace(event_hash=0xab, code=5, end="tripped", verdict="it tripped",
                                 wall_s=0.5, simulated_s=2.0,
                                 settings=SimpleNamespace(scenario="a", command="b", values={}))
        result = Result(record)
        self.assertEqual((result.event_hash, result.ok, result.end, result.wall_s,
                          result.simulated_s, result.scenario, result.command, repr(result)),
                         ("00000000000000ab", False, "tripped", 0.5, 2.0, "a", "b",
                          "<a: it tripped>"))
        record.code = 0
        self.assertTrue(result.ok)

    def test_a_range_is_that_of_the_refusal(self):
        key = trammel.keys(trammel.settings("circle").machine)["plant.x.payload_kg"]
        with self.assertRaises(trammel.SettingError) as told:
            trammel.settings("circle", **{key.name: 1e9})
        self.assertEqual(key.range, told.exception.range)
        self.assertEqual(float(key.default),
                         float(trammel.settings("circle").values[key.name]))

    def test_how_a_verb_ends(self):
        def ended(error):
            def action():
                raise error
            told = io.StringIO()
            with contextlib.redirect_stderr(told):
                code = command_line.exit_code("sweep", action, "out")
            return code, told.getvalue()

        self.assertEqual(command_line.exit_code("sweep", lambda: 1, "out"), 1)
        for error, code, text in (
                (ImportError(name="dask"), 3, "dask is missing (trammel doctor)"),
                (KeyboardInterrupt(), 130, "interrupted; the same command goes on"),
                (OSError(28, "", "a"), 2, "a: No space left on device; what is done is kept"),
                (OSError(28, ""), 2, "out: No space left on device; what is done is kept"),
                (OSError("why"), 2, "out: why; what is done is kept"),
                (ValueError("why"), 2, "why")):
            self.assertEqual(ended(error), (code, f"sweep: {text}\n"))

    def test_options_that_are_not_given(self):
        for parser, name in ((command_line.sweep(), "plan"), (command_line.tune(), "study")):
            found = vars(parser.parse_args(["a.toml"]))
            wanted = {name: "a.toml", "out": None, "jobs": 0, "cluster": "local", "scheduler": "",
                      "limit": 60}
            self.assertEqual({key: found[key] for key in wanted}, wanted)
        found = command_line.sweep().parse_args(["a.toml"])
        self.assertEqual((found.shard, found.yes, found.count, found.empty),
                         ("1/1", False, False, False))
        self.assertEqual(command_line.tune().parse_args(["a.toml"]).trials, 0)


class Shapes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = trammel.run("circle", engine="twin", controller="fc")

    def test_columns_have_units(self):
        result = self.result
        self.assertEqual(set(result.units), set(result))
        self.assertEqual(result.units["t_s"], "s")
        self.assertEqual(result["t_s"].dtype, np.float64)
        self.assertEqual(result["x_encoder_count"].dtype, np.int64)
        self.assertEqual({len(result[name]) for name in result}, {len(result["t_s"])})

    def test_figures_have_units(self):
        figure = self.result.figures["tracking.model.mean_mm"]
        self.assertEqual(figure.unit, "mm")
        self.assertGreater(figure + 1, figure)
        self.assertEqual(self.result.metrics["tracking"]["model"]["mean_mm"], float(figure))
        whole = trammel.Figure(1.5, "mm", "error", 1.0, 0.25, 1.25, "a paper")
        self.assertEqual(vars(pickle.loads(pickle.dumps(whole))), vars(whole))
        self.assertEqual(vars(whole), {"unit": "mm", "name": "error", "expected": 1.0,
                                       "tolerance": 0.25, "printed": 1.25, "source": "a paper"})

    def test_a_figure_is_good_within_its_tolerance_on_either_side(self):
        for value, expected, good in ((2.0, 2.1, True), (2.2, 2.1, True), (1.9, 2.1, False),
                                      (2.3, 2.1, False), (2.0, None, True)):
            figure = trammel.Figure(value, "mm", expected=expected, tolerance=0.125)
            for same in (figure, pickle.loads(pickle.dumps(figure))):
                self.assertEqual(same.good, good, (value, expected))

    def test_a_data_frame(self):
        frame = self.result.to_pandas()
        self.assertEqual(list(frame), list(self.result))
        self.assertEqual(frame.attrs["units"]["t_s"], "s")

    @unittest.skipUnless(importlib.util.find_spec("polars"), "polars is not installed")
    def test_a_frame_of_polars(self):
        frame = self.result.to_polars()
        self.assertEqual(frame.columns, list(self.result))
        for name, values in self.result.items():
            self.assertEqual(frame[name].to_numpy().tobytes(), values.tobytes(), name)

    def test_settings_repeat_the_run(self):
        self.assertEqual(self.result.settings["controller"], "fc")
        self.assertIn("controller=fc", self.result.command)

    def test_pages(self):
        with tempfile.TemporaryDirectory() as scratch:
            self.result.report(f"{scratch}/page.html")
            self.assertIn("<html", Path(scratch, "page.html").read_text()[:500].lower())
            other = trammel.run("circle", engine="twin", controller="afc")
            trammel.compare([self.result, other], f"{scratch}/both.html")
            text = Path(scratch, "both.html").read_text()
            hashes = [text.index(one.event_hash) for one in (self.result, other)]
            self.assertEqual(hashes, sorted(hashes))  # the first is the reference
            self.assertNotIn("report.html", text)  # no link to what is gone
            self.assertEqual(sorted(os.listdir(scratch)), ["both.html", "page.html"])
            for page in (True, False):
                self.result.save(f"{scratch}/{page}", page=page)
                self.assertEqual("report.html" in os.listdir(f"{scratch}/{page}"), page)

    def test_keys_of_a_machine(self):
        for machine in _core.machines():
            keys = trammel.keys(machine)
            self.assertIn("0", keys["run.max_s"].range)
            self.assertTrue(all(key.help for key in keys.values()))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
