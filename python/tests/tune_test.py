# SPDX-License-Identifier: Apache-2.0
"""`trammel tune`: tune_test.py PROGRAM (which is not used)."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import trammel
from trammel.tune import Study, StudyError
from trammel.tune import main as tune

STUDY = """trials = 8
[keys]
"run.max_s" = 20
[search]
"gains.kp" = {log = [0.1, 3.0]}
controller = {choice = ["fc", "afc"]}
"gains.shift_e" = [0, 1]
[cases]
scenario = ["circle"]
"plant.payload_kg" = [0, 11]
"""
ERROR = '[[objective]]\nfigure = "tracking.model.mean_mm"\n'
PEAK = '[[objective]]\nfigure = "peak_current_A"\nover = "mean"\n'
LIMIT = '[[constraint]]\nfigure = "peak_current_A"\nat_most = %g\n'


def run(*words):
    return subprocess.run([sys.executable, "-m", "trammel", "tune", *map(str, words)],
                          capture_output=True, text=True, check=False)


class Tune(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.out = self.folder / "out"

    def study(self, text):
        file = self.folder / "study.toml"
        file.write_text(text)
        return file

    def page(self):
        text = (self.out / "page.html").read_text()
        return json.loads(text.split('id="data">')[1].split("</script>")[0])

    def test_the_best_trial_is_a_scenario_that_gives_its_figure(self):
        file = self.study(STUDY + ERROR + LIMIT % 3)
        done = run(file, "-o", self.out, "--jobs", 1)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        page = self.page()
        axes = {axis["name"]: axis["values"] for axis in page["axes"]}
        errors = axes["max tracking.model.mean_mm"]
        peaks = axes["max peak_current_A (limited)"]
        allowed = [e for e, peak in zip(errors, peaks) if e is not None and peak <= 3]
        best = next(w for w in page["words"] if w["name"] == "best")["values"].index("best")
        self.assertEqual(errors[best], min(allowed))
        cases = [trammel.run(self.out / "best.toml", engine="twin", **{"plant.payload_kg": m})
                 for m in (0, 11)]
        worst = max(case.figures["tracking.model.mean_mm"] for case in cases)
        self.assertAlmostEqual(worst, errors[best], delta=1e-5 * worst,
                               msg=f"payloads 0 and 11: {[one.command for one in cases]}")
        # It goes on, and a study always comes to the same.
        more = run(file, "-o", self.out, "--jobs", 1, "--trials", 10)
        self.assertIn("10 trials", more.stdout)
        self.assertEqual(self.page()["commands"][:8], page["commands"])
        first, self.out = self.page()["commands"], self.folder / "again"
        run(file, "-o", self.out, "--jobs", 1)
        self.assertEqual(self.page()["commands"], first[:8])
        other = run(self.study(STUDY + PEAK), "-o", self.out)
        self.assertEqual(other.returncode, 2)
        self.assertIn("another study", other.stderr)

    def test_several_objectives_have_several_best(self):
        done = run(self.study(STUDY + ERROR + PEAK), "-o", self.out, "--jobs", 2)
        self.assertEqual(done.returncode, 0, done.stderr)
        axes = {axis["name"]: axis["values"] for axis in self.page()["axes"]}
        points = list(zip(axes["max tracking.model.mean_mm"], axes["mean peak_current_A"]))
        marks = next(w for w in self.page()["words"] if w["name"] == "best")["values"]
        for point, mark in zip(points, marks):
            beaten = any(a <= b and c <= d and (a, c) != (b, d)
                         for a, c in points if None not in (a, c)
                         for b, d in [point] if None not in point)
            self.assertEqual(mark == "best", None not in point and not beaten, points)

    def test_the_best_of_goals_to_minimize_and_to_maximize(self):
        def trial(number, values, outside=()):
            return SimpleNamespace(number=number, values=values,
                                   user_attrs={"outside": list(outside)})

        trials = [trial(0, (3, 3)), trial(1, (1, 1)), trial(2, (2, 3)), trial(3, (1, 2)),
                  trial(4, (0, 9), [0.1]), trial(5, None)]
        found = SimpleNamespace(get_trials=lambda deepcopy: trials)
        for signs, best in (("-", [1]), ("+", [0]), ("--", [1]), ("-+", [3, 2]), ("+-", [0, 1]),
                            ("++", [0])):
            study = SimpleNamespace(
                objectives=[SimpleNamespace(maximize=sign == "+") for sign in signs])
            one = [SimpleNamespace(**{**vars(t), "values": t.values and t.values[:len(signs)]})
                   for t in trials]
            found.get_trials = lambda deepcopy, one=one: one
            self.assertEqual([t.number for t in tune.best_of(study, found)], best, signs)

    def test_a_trial_that_meets_a_limit_exactly_is_within_it(self):
        study = SimpleNamespace(objectives=[SimpleNamespace(maximize=False)])
        for outside, within in (([], True), ([0.0], True), ([-1.0, 0.0], True), ([1e-12], False),
                                ([0.0, 1e-12], False), ([1e-12, -1.0], False)):
            trial = SimpleNamespace(number=7, values=[1.0], user_attrs={"outside": outside})
            found = SimpleNamespace(get_trials=lambda deepcopy, trial=trial: [trial])
            self.assertEqual(tune.best_of(study, found), [trial] if within else [], outside)

    def test_none_within_the_constraints(self):
        done = run(self.study(STUDY + ERROR + LIMIT % 1e-3), "-o", self.out, "--trials", 2)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no trial", done.stderr)

    def test_what_is_refused(self):
        for text, message in (
            (STUDY, "objective"), (STUDY + ERROR + "colour = 1\n", "objective: expects"),
            (STUDY.replace("gains.kp", "gains.kq") + ERROR, "unknown key"),
            (STUDY.replace("3.0", "300.0") + ERROR, "out of range"),
            (STUDY.replace("trials = 8", "trials = 0") + ERROR, "trials: must be"),
            (STUDY.replace('["circle"]', "[]") + ERROR, "expects a list"),
            (STUDY + ERROR.replace("]]", "]", 1), "study.toml"),
            (STUDY + ERROR + '[[constraint]]\nfigure = "x"\n', "at_least or at_most"),
            (STUDY.replace("run.max_s", "gains.kp") + ERROR, "given twice"),
        ):
            with self.assertRaisesRegex(StudyError, message) as told:
                Study(self.study(text))
            self.assertNotIn("\n", str(told.exception))
        done = run(self.study(STUDY + '[[objective]]\nfigure = "no.such"\n'), "-o", self.out)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "no.such: no figure of every case\n$")

    def test_of_earlier_calls_no_best_trial_is_left(self):
        self.out.mkdir()
        for count in 3, 1, 2, 0, 1, 0:
            front = [SimpleNamespace(number=n) for n in range(count)]
            with mock.patch.object(tune, "best_of", lambda *_, front=front: front), \
                    mock.patch.object(tune, "scenario_text", lambda _, trial: f"{trial.number}"), \
                    mock.patch("trammel.sweep.page.write_trials"):
                tune.write(None, mock.Mock(), self.out)
            names = ["best.toml"] if count == 1 else [f"best-{n + 1}.toml" for n in range(count)]
            self.assertEqual({f.name: f.read_text() for f in self.out.iterdir()},
                             {name: f"{n}" for n, name in enumerate(names)})


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
