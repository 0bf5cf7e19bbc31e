# SPDX-License-Identifier: Apache-2.0
"""`trammel tune`: tune_test.py PROGRAM (which is not used)."""

import contextlib
import io
import json
import subprocess
import sys
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import sweeps

import trammel
from trammel.tune import Study, StudyError
from trammel.tune import main as tune
from trammel.tune.study import Goal

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
TARGETS = """[[objective]]
targets = [
  {figure = "a", value = 2.0, within = 0.5, "plant.payload_kg" = 0},
  {figure = "b", value = -3, within = 2},
]
"""
LIMIT = '[[constraint]]\nfigure = "peak_current_A"\nat_most = %g\n'


def run(*words):
    return subprocess.run([sys.executable, "-m", "trammel", "tune", *map(str, words)],
                          capture_output=True, text=True, check=False)


class Tune(sweeps.Case):
    def study(self, text):
        return self.written("study.toml", text)

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

    def test_what_no_study_can_mean(self):
        least = '[search]\n"gains.kp" = [0.1, 0.3]\n' + ERROR
        self.assertEqual(Study(self.study(least)).cases, [("circle", {})])
        for text, message in (
            ("colour = 1\n" + least, "colour: unknown; a study has cases, constraint, engine, "),
            ("seed = -1\n" + least, "seed: must be 0..1000000"),
            ("trials = true\n" + least, "trials: must be 1..1000000"),
            ("trials = 1000001\n" + least, "trials: must be 1..1000000"),
            ("scenario = 3\n" + least, "scenario: expects a name"),
            ("keys = 3\n" + least, "keys: expects a table"),
            ("objective = 3\n[search]\n\"gains.kp\" = [0.1, 0.3]\n", "expects ..objective.."),
            (ERROR, "search: names no key"),
            (least + "[cases]\nscenario = [3]\n", "cases: scenario: expects a list of names"),
            (least + '[cases]\n"plant.payload_kg" = 3\n', "payload_kg: expects a list of values"),
            (least + '[cases]\n"plant.payload_kg" = [0, 501]\n', "out of range 0..500"),
            (least + '[cases]\n"gains.kp" = [0.1]\n', "search: gains.kp: given twice"),
            (least + '[cases]\ncontroller = ["fc"]\n[keys]\ncontroller = "fc"\n',
             "controller: given twice"),
            (least + '[keys]\nengine = "rtl"\n', "engine: unknown key"),
            (least + '[cases]\n"plant.payload_kg" = [0.0' + ", 1.0" * 1000 + "]\n",
             "cases: 1001 of them, more than 1000"),
            (least.replace("[0.1, 0.3]", "{choice = []}"), "choice: expects a list of values"),
            (least.replace("[0.1, 0.3]", "{choice = [0.1, -1.0, 0.2]}"), "value -1.* is out of"),
            (least.replace("[0.1, 0.3]", "[-0.1, 0.3]"), "value -0.1 is out of range"),
            (least.replace("[0.1, 0.3]", "{normal = [1.0, 0.1]}"), "expects .low, high., .log = "),
            (least + 'over = ["max"]\n', "objective: over: must be one of max, mean, min"),
            (least + 'over = "median"\n', "objective: over: must be one of max, mean, min"),
            (least + 'goal = "best"\n', "objective: goal: must be one of minimize, maximize"),
            (least + "at_most = 3\n", "objective: expects figure, goal, over"),
            (least + LIMIT % 3 + 'goal = "maximize"\n', "expects at_least, at_most, figure, over"),
            (least + LIMIT % 3 + 'at_least = "1"\n', "constraint: a limit must be a number"),
            (least + (LIMIT % 3).replace("3", "nan"), "constraint: a limit must be a number"),
            (least.replace('"tracking.model.mean_mm"', "3"), "objective: expects figure"),
            (least + TARGETS.replace("value = 2.0", 'value = "2"'), "expects figure, value and"),
            (STUDY + TARGETS.replace("within = 2", "within = 0"), "within, which is above 0"),
            (least + TARGETS.replace(', "plant.payload_kg" = 0', ', colour = "red"'),
             "targets: a: no case has colour = red"),
            (STUDY.replace("[0, 11]", "[1, 11]") + TARGETS, "a: no case has plant.payload_kg = 0"),
            (least + "[[objective]]\ntargets = []\n", "targets: expects a list of tables"),
            (least + TARGETS + 'over = "min"\n', "with targets must be one of rms, max, mean"),
            (least + TARGETS + 'figure = "a"\n', "expects nothing else than over"),
            (least + LIMIT % 3 + "targets = []\n", "constraint: expects"),
        ):
            with self.assertRaisesRegex(StudyError, message, msg=text) as told:
                Study(self.study(text))
            self.assertRegex(str(told.exception), f"^{self.folder}/study.toml.*: ")
            self.assertNotIn("\n", str(told.exception))

    def test_a_case_is_every_combination_of_the_lists(self):
        study = Study(self.study(STUDY.replace('["circle"]', '["circle", "window"]') + ERROR))
        self.assertEqual(study.cases, [(scenario, {"plant.payload_kg": mass})
                                       for scenario in ("circle", "window") for mass in (0, 11)])
        trial = mock.Mock()
        study.suggest(trial)
        self.assertEqual(trial.mock_calls, [
            mock.call.suggest_float("gains.kp", 0.1, 3.0, log=True),
            mock.call.suggest_categorical("controller", ("fc", "afc")),
            mock.call.suggest_int("gains.shift_e", 0, 1)])

    def test_a_goal_is_judged_over_all_cases(self):
        rows = [{"a": value} for value in (3.0, 1.0, 5.0)]
        for over, value in (("max", 5), ("mean", 3), ("min", 1)):
            self.assertEqual(Goal("a", over).value(rows), value, over)
            self.assertEqual(Goal("a", over).name, f"{over} a")
            for least, most, outside in ((value - 1, value + 2, [-1, -2]), (value + 1, None, [1]),
                                         (None, value - 2, [2]), (None, None, []),
                                         (0, 0, [-value, value])):
                limits = {"at_least": least, "at_most": most}
                goal = Goal("a", over, **{k: v for k, v in limits.items() if v is not None})
                self.assertEqual(goal.outside(rows), outside, (over, limits))
                self.assertEqual(goal.limits, [v for v in (least, most) if v is not None])

    def test_the_distance_from_targets_is_in_tolerances_of_each(self):
        rows = [{"end": "done", "a": 2.5, "b": -3.0}, {"end": "done", "b": 5.0}]
        for over, value in (("rms", (17 / 3) ** 0.5), ("max", 4), ("mean", 5 / 3)):
            study = Study(self.study(STUDY + TARGETS + f'over = "{over}"\n'))
            goal = study.objectives[0]
            self.assertEqual((goal.value(rows), goal.maximize), (value, False))
            self.assertEqual(goal.name, f"{over} distance from 3 targets")
            found, trial = mock.Mock(), mock.Mock()
            tune.judge(study, found, trial, rows)  # the second case need not have the figure a
            found.tell.assert_called_once_with(trial, [value])
        with self.assertRaisesRegex(StudyError, "a: no figure of every case"):
            tune.judge(study, mock.Mock(), mock.Mock(), rows[::-1])
        best = SimpleNamespace(number=3, values=[4], user_attrs=dict(
            call.args for call in trial.set_user_attr.mock_calls), params={})
        self.assertEqual(tune.scenario_text(study, best).splitlines()[1:4], [
            "#   mean distance from 3 targets over 2 cases: 4",
            "#     2.5 for 2, a of circle plant.payload_kg=0",
            "#     1 for -3, b of circle plant.payload_kg=0; circle plant.payload_kg=11"])

    def test_identity_tells_studies_apart(self):
        text = "seed = 2\n" + STUDY + ERROR + LIMIT % 3
        one = Study(self.study(text)).identity()
        self.assertEqual(one, Study(self.study("# a comment\n" + text)).identity())
        self.assertEqual(one, Study(self.study(text.replace("= 8", "= 9"))).identity())
        for old, new in (("seed = 2", "seed = 3"), ('"run.max_s" = 20', '"run.max_s" = 21'),
                         ("3.0", "2.0"), ("{log = [0.1, 3.0]}", "[0.1, 3.0]"),
                         ("[0, 11]", "[0, 12]"),
                         ('["fc", "afc"]', '["fc"]'), ("at_most = 3", "at_most = 4"),
                         ("at_most", "at_least"), ("mean_mm", "max_mm"),
                         ("[search]", '[search]\n"gains.ki" = [0.1, 0.2]'),
                         ("trials", 'engine = "rtl"\ntrials'),
                         (ERROR, ERROR + 'over = "mean"\n'),
                         (ERROR, ERROR + TARGETS),
                         (ERROR, ERROR + 'goal = "maximize"\n')):
            self.assertIn(old, text)
            other = Study(self.study(text.replace(old, new, 1))).identity()
            self.assertNotEqual(one, other, (old, new))

    def test_what_optuna_is_told_of_a_trial(self):
        import optuna
        state = optuna.trial.TrialState
        study = Study(self.study(STUDY + ERROR + LIMIT % 3 + "at_least = 1\n"))
        rows = [{"scenario": "circle", "end": "done", "message": "", "peak_current_A": peak,
                 "tracking.model.mean_mm": mean} for mean, peak in ((0.5, 2.0), (0.25, 3.5))]
        found, trial = mock.Mock(), mock.Mock()
        tune.judge(study, found, trial, rows)
        found.tell.assert_called_once_with(trial, [0.5])
        self.assertEqual(trial.set_constraint.mock_calls,
                         [mock.call("0", -2.5), mock.call("1", 0.5)])
        trial.set_user_attr.assert_has_calls([mock.call("outside", [-2.5, 0.5]),
                                              mock.call("constraints", [3.5])])
        del rows[1]["peak_current_A"]
        with self.assertRaisesRegex(StudyError, "peak_current_A: no figure of every case$"):
            tune.judge(study, mock.Mock(), mock.Mock(), rows)
        rows[1] |= {"end": "tripped", "message": "why"}
        for text, wanted in ((ERROR, state.PRUNED), (ERROR + PEAK, state.FAIL)):
            found, trial = mock.Mock(), mock.Mock()
            tune.judge(Study(self.study(STUDY + text + LIMIT % 3 + "at_least = 1\n")), found, trial,
                       rows)
            found.tell.assert_called_once_with(trial, state=wanted)
            trial.set_user_attr.assert_called_once_with("message", "circle: tripped: why")
            self.assertEqual(trial.set_constraint.mock_calls,
                             [mock.call("0", 1.0), mock.call("1", 1.0)])

    def test_a_folder_goes_on_with_its_trials(self):
        import optuna
        study = Study(self.study(STUDY + ERROR + PEAK + 'goal = "maximize"\n'))
        self.out.mkdir()
        found = tune.open_study(study, self.out)
        self.assertEqual([one.name for one in found.directions], ["MINIMIZE", "MAXIMIZE"])
        found.tell(found.ask(), [1.0, 2.0])
        study.suggest(found.ask())  # is killed
        with (self.out / "trials.log").open("a") as stream:
            stream.write('{"op_code": 5, "wor')
        (self.out / "trials.log.lock").write_text("")
        again = tune.open_study(study, self.out)
        self.assertEqual([(t.state, t.values) for t in again.get_trials()],
                         [(optuna.trial.TrialState.COMPLETE, [1.0, 2.0]),
                          (optuna.trial.TrialState.FAIL, None)])
        self.assertFalse((self.out / "trials.log.lock").exists())

    def test_the_scenario_of_a_trial(self):
        study = Study(self.study(STUDY + ERROR + PEAK))
        trial = SimpleNamespace(number=7, values=[0.25, 3.5], params={
            "gains.kp": 0.125, "controller": "fc", "gains.shift_e": 1})
        text = tune.scenario_text(study, trial)
        self.assertEqual(text.splitlines()[:3], [
            "# study.toml, trial 7:", "#   max tracking.model.mean_mm over 2 cases: 0.25",
            "#   mean peak_current_A over 2 cases: 3.5"])
        file = self.folder / "best.toml"
        file.write_text(text)
        kept = trammel.settings(file).values
        self.assertEqual([kept[key] for key in ("name", "run.max_s", "gains.x.kp", "gains.y.kp",
                                                "controller", "gains.x.shift_e")],
                         ["study-7", 20, 0.125, 0.125, "fc", 1])

    def test_what_a_page_shows_of_trials(self):
        from optuna.trial import TrialState

        from trammel.sweep import page
        study = Study(self.study(STUDY + ERROR + LIMIT % 3))
        trials = [SimpleNamespace(number=n, values=values, state=state, user_attrs=told,
                                  params={"gains.kp": 0.5, "controller": "fc", "gains.shift_e": n})
                  for n, (values, state, told) in enumerate((
                      ([0.25], TrialState.COMPLETE, {"constraints": [2.5]}),
                      (None, TrialState.PRUNED, {"message": "circle: tripped: why"}),
                      (None, TrialState.RUNNING, {}),
                      ([0.125], TrialState.COMPLETE, {"constraints": [3.5]})))]
        data = page.trials_data(study, trials, {0})
        self.assertEqual((data["runs"], data["end"], data["of"], data["title"]),
                         ([0, 1, 3], ["done", "failed", "done"], 4, "study"))
        self.assertEqual(data["message"], ["", "circle: tripped: why", ""])
        self.assertEqual({a["name"]: (a["key"], a["values"]) for a in data["axes"]}, {
            "gains.kp": (True, [0.5, 0.5, 0.5]), "gains.shift_e": (True, [0, 1, 3]),
            "max tracking.model.mean_mm": (False, [0.25, None, 0.125]),
            "max peak_current_A (limited)": (False, [2.5, None, 3.5])})
        self.assertEqual([w["values"] for w in data["words"]], [["best", "", ""], ["fc"] * 3])
        self.assertEqual(data["commands"][1], "./trammel run circle -s run.engine=twin "
                         "-s run.max_s=20 -s plant.payload_kg=0 -s gains.kp=0.5 -s controller=fc "
                         "-s gains.shift_e=1")

    def test_what_is_printed_of_a_study(self):
        file = self.study(STUDY + ERROR + PEAK)
        trials = [SimpleNamespace(number=n, values=[n + 0.123456, 2.0] if n else None,
                                  params={"gains.kp": n / 8, "controller": "fc"})
                  for n in range(9)]
        for front, code in ((trials[1:8], 0), (trials[1:2], 0), ([], 1)):
            with mock.patch.object(tune, "perform", return_value=(trials, front)) as perform, \
                    mock.patch.object(sys, "argv", ["tune", str(file), "--trials", "9"]), \
                    contextlib.redirect_stdout(io.StringIO()) as said, \
                    contextlib.redirect_stderr(io.StringIO()) as told:
                self.assertEqual(tune.main(), code)
            self.assertEqual(perform.call_args.args[1], Path("out/study"))
            self.assertEqual(perform.call_args.kwargs["trials"], 9)
            lines = said.getvalue().splitlines()
            self.assertEqual(lines[:2], [f"study: 9 trials, 1 of them failed; {len(front)} best",
                                         "  results in out/study"])
            self.assertEqual(len(lines), 2 + min(5, len(front)))
            self.assertEqual(bool(told.getvalue()), not front)
        self.assertIn("tune: no trial ended well and within all constraints\n", told.getvalue())

    def test_of_earlier_calls_no_best_trial_is_left(self):
        study = Study(self.study(STUDY + ERROR + PEAK))
        self.out.mkdir()
        mine = dict.fromkeys(("best-of.toml", "best_1.toml", "best-01.toml", "best.toml.old",
                              "bestseller.toml", "best-2.txt"), "mine")
        for name, text in mine.items():
            (self.out / name).write_text(text)
        for count in 3, 1, 2, 0, 1, 0:
            front = [SimpleNamespace(number=n) for n in range(count)]
            with mock.patch.object(tune, "best_of", lambda *_, front=front: front), \
                    mock.patch.object(tune, "scenario_text", lambda _, trial: f"{trial.number}"), \
                    mock.patch("trammel.sweep.page.write_trials"):
                tune.write(study, mock.Mock(), self.out)
            record = json.loads((self.out / "study.json").read_text())
            names = ["best.toml"] if count == 1 else [f"best-{n + 1}.toml" for n in range(count)]
            self.assertEqual(record, {**study.identity(), "best": names})
            self.assertEqual({f.name: f.read_text() for f in self.out.glob("best*")},
                             mine | {name: f"{n}" for n, name in enumerate(names)})

    def test_a_scenario_of_the_users_is_not_replaced(self):
        two = Study(self.study(STUDY + ERROR + PEAK))
        one = Study(self.study(STUDY + ERROR))
        for study, name, refused in ((one, "best.toml", True), (one, "best-2.toml", False),
                                     (two, "best.toml", True), (two, "best-2.toml", True)):
            out = self.folder / f"{len(study.objectives)}-{name}"
            out.mkdir()
            (out / "study.json").write_text(json.dumps(study.identity()))
            (out / name).write_text("mine")
            with mock.patch.object(tune, "open_study"), \
                    mock.patch.object(tune, "search") as search, \
                    mock.patch.object(tune, "best_of", return_value=[]), \
                    mock.patch("trammel.sweep.page.write_trials"):
                if refused:
                    with self.assertRaisesRegex(StudyError, f"^{out / name}: is not of the study"):
                        tune.perform(study, out)
                else:
                    tune.perform(study, out)
            self.assertEqual((out / name).read_text(), "mine")
            self.assertEqual(search.called, not refused)  # before anything runs


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
