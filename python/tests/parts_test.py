# SPDX-License-Identifier: Apache-2.0
"""The parts of `trammel sweep`, each by itself and without long runs: workers, the data set, its
page, the verb. parts_test.py PROGRAM (which is not used)."""

import contextlib
import errno
import io
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import dask_jobqueue
import distributed
import numpy as np

import trammel
from trammel import _core, command_line, sweep
from trammel.sweep import cluster, page, store, work
from trammel.sweep import main as verb


class Scratch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Workers(Scratch):
    """What is around a run, without one."""

    def test_what_is_kept_of_a_run(self):
        made = SimpleNamespace(end="done", verdict="good", wall_s=0.5, simulated_s=2.0,
                               event_hash="0a", figures={"a.b": trammel.Figure(3.0, "mm")})
        with mock.patch.object(_core, "run"), mock.patch.object(work, "Result", lambda _: made):
            rows, _ = work.chunk([("circle", "twin", {}), ("window", "twin", {})],
                                 [(7, 1, {"gains.kp": 0.1})])
        self.assertEqual(rows, [{"run": 7, "part": 1, "scenario": "window", "gains.kp": 0.1,
                                 "end": "done", "message": "good", "wall_s": 0.5,
                                 "event_hash": "0a", "a.b": 3.0}])

    def test_a_run_has_nothing_of_the_one_before(self):
        parts = [("circle", "twin", {"run.max_s": 0.02})]
        rows, _ = work.chunk(parts, [(0, 0, {"controller": "fc"}), (1, 0, {})])
        self.assertEqual([row["event_hash"] for row in rows], [
            trammel.run("circle", engine="twin", **{"run.max_s": 0.02}, **keys).event_hash
            for keys in ({"controller": "fc"}, {})])
        engines = [work._base("circle", engine, {}).values["run.engine"]
                   for engine in ("twin", "rtl", "twin")]
        self.assertEqual(engines, ["twin", "rtl", "twin"])

    def test_a_computer_that_cannot_run_is_no_row(self):
        for code in (errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO, errno.EMFILE,
                     errno.ENFILE):
            with mock.patch.object(_core, "run", side_effect=OSError(code, "why")), \
                    self.assertRaisesRegex(work.WorkerError, f"on .*: {os.strerror(code)}$"):
                work.one("circle", "twin", {}, {})
        with mock.patch.object(_core, "run", side_effect=OSError(errno.ENOENT, "why")):
            self.assertEqual(work.one("circle", "twin", {}, {})["end"], "refused")
        row = work.one("circle", "twin", {}, {"gains.kp": -1.0})
        self.assertEqual(row["end"], "refused")
        self.assertRegex(row["message"], "^gains.x.kp: value -1")
        self.assertEqual(work.one("circle", "twin", {}, {"run.audit": True})["end"], "refused")

    def rows(self, chunk, count=40, workers=1, there=1):
        """Rows by a client that makes each chunk at once, and how long the chunks were; `ahead`:
        how many of them were on their way at most."""
        sent, taken = [], []
        self.ahead = 0

        class Ended:
            add, __next__ = staticmethod(sent.append), lambda self: sent.pop(0)

        def submit(_, parts, runs, empty, pure, retries):
            taken.append(len(runs))
            self.ahead = max(self.ahead, len(sent) + 1)
            self.assertEqual((pure, retries), (False, 2))
            return mock.Mock(result=lambda: chunk(parts, runs, empty))

        found = SimpleNamespace(submit=submit, scheduler_info=lambda n_workers: {
            "workers": dict.fromkeys(range(there))})
        parts = [("circle", "twin", {}), ("window", "twin", {})]
        runs = ((n, n % 2, {"gains.kp": n / 100}) for n in range(count))
        with mock.patch.object(distributed, "as_completed", lambda with_results: Ended()):
            made = [row for some in cluster.rows(found, parts, runs, workers, True)
                    for row in some]
        return made, taken

    def test_tasks_grow_with_what_they_take(self):
        for each_s, wanted in ((1e-9, [1, 1, 1, 4, 16, 17]), (1.0, [1, 1, 1] + [2] * 18 + [1]),
                               (5.0, [1] * 40)):
            made, taken = self.rows(lambda parts, runs, empty, each_s=each_s: (
                work.chunk(parts, runs, empty)[0], each_s * len(runs)))
            self.assertEqual([row["run"] for row in made], list(range(40)))
            self.assertEqual(taken, wanted, each_s)
        _, taken = self.rows(lambda parts, runs, empty: ([], 1e-9), 20000)
        self.assertEqual(max(taken), cluster.MOST_CHUNK)

    def test_each_worker_has_work_before_it_those_that_come_later_too(self):
        def slow(parts, runs, empty):
            return work.chunk(parts, runs, empty)[0], 5.0 * len(runs)

        for workers, there, most in ((1, 1, 3), (2, 2, 6), (2, 1, 6), (1, 4, 12)):
            made, _ = self.rows(slow, 60, workers, there)
            self.assertEqual(sorted(row["run"] for row in made), list(range(60)))
            self.assertEqual(self.ahead, most, (workers, there))

    def test_the_first_worker_is_waited_for(self):
        def waited(after, said=()):
            """Calls until a worker has come `after` so many seconds, with a limit of 5 s."""
            now, asked = [100.0], []

            def wait_for_workers(count, timeout):
                self.assertEqual(count, 1)
                asked.append(timeout)
                now[0] += timeout
                if now[0] < 100 + after:
                    raise TimeoutError("of Dask")

            found = SimpleNamespace(wait_for_workers=wait_for_workers)
            with mock.patch.object(cluster.time, "monotonic", lambda: now[0]):
                cluster._wait(found, 5.0, list(said))
            return asked

        self.assertEqual(waited(0.5), [1])
        self.assertEqual(waited(3), [1, 1, 1])
        self.assertEqual(waited(1, ["not asked for"]), [1])
        with self.assertRaisesRegex(TimeoutError, "^none has come; jobs"):
            waited(60)
        with self.assertRaisesRegex(sweep.PlanError, "^no such queue$"):
            waited(60, ["no such queue", "more"])

    def test_runs_that_are_lost_have_a_row_each(self):
        def lost(parts, runs, empty):
            raise RuntimeError("why\nand more")

        made, _ = self.rows(lost, 3)
        self.assertEqual(made, [{"run": n, "part": n % 2, "scenario": ("circle", "window")[n % 2],
                                 "gains.kp": n / 100, "end": "lost", "message": "why"}
                                for n in range(3)])

        def full(parts, runs, empty):
            raise work.WorkerError("worker on a: full")

        with self.assertRaisesRegex(sweep.PlanError, "^worker on a: full; what is done is kept$"):
            self.rows(full)

    def test_a_batch_system_says_why_in_one_line(self):
        for said, message in (("echo 'qstat: no one' >&2; echo b >&2; echo c; exit 3", "no one"),
                              ("echo ' b'; exit 1", "b"), ("exit 3", "exit code 3")):
            (self.folder / "qstat").write_text(f"#!/bin/sh\n{said}\n")
            (self.folder / "qstat").chmod(0o755)
            with mock.patch.dict(os.environ, PATH=f"{self.folder}:/bin"):
                with self.assertRaisesRegex(sweep.PlanError, f"^--cluster pbs: qstat: {message}$"):
                    cluster._ask("pbs", 10)
                (self.folder / "qstat").write_text("#!/bin/sh\necho why >&2\n")
                cluster._ask("pbs", 10)

    def test_every_kind_of_cluster_is_there(self):
        for kind, (_, name) in cluster.BATCH.items():
            self.assertRegex(name.lower(), f"^{kind}cluster$")
            self.assertTrue(hasattr(dask_jobqueue, name), name)
        for parser in (command_line.sweep(), command_line.tune()):
            kinds = next(a.choices for a in parser._actions if a.dest == "cluster")
            self.assertEqual(set(kinds), {"local", *cluster.BATCH})


class Kept(Scratch):
    """The data set and its page."""

    def test_whose_runs_a_folder_holds(self):
        identity = {"plan": "a", "runs": 3, "version": "1"}
        (self.folder / ".lock-2-of-3").write_text("")  # of another shard, which begins too
        store.Store(self.folder, identity).__exit__()
        for other, message in (({"plan": "b"}, "holds the runs of another plan; give"),
                               ({"version": "2"}, "holds the runs of another version; give")):
            with self.assertRaisesRegex(sweep.PlanError, message):
                store.Store(self.folder, identity | other)
        with store.Store(self.folder, identity, "-1-of-2"), \
                store.Store(self.folder, identity, "-2-of-2"), \
                self.assertRaisesRegex(sweep.PlanError, "another sweep writes here now$"):
            store.Store(self.folder, identity, "-1-of-2")
        (self.folder / "plan.json").write_text("{")
        with self.assertRaisesRegex(sweep.PlanError, "plan.json: is corrupt$"):
            store.Store(self.folder, identity)

    def test_rows_of_several_files(self):
        with self.assertRaisesRegex(sweep.PlanError, "holds no runs"):
            store.read(self.folder)
        told = {"scenario": "circle", "end": "done", "message": ""}
        with store.Store(self.folder, {"runs": 5}) as kept:
            self.assertEqual(kept.done().tolist(), [])
            kept.add([{"b": 1, "run": 4, "part": 0, **told, "flag": True, "text": "a"},
                      {"b": 2.5, "run": 2, "part": 1, **told, "end": "tripped", "mixed": True}])
            kept.add([{"run": 3, "part": 0, "b": 7, **told, "none": None, "mixed": 1.5,
                       "text": "3"}, {"run": 0, "part": 0, "b": None, **told, "late": 5}])
            self.assertEqual(kept.done().tolist(), [0, 2, 3, 4])
        table = sweep.read(self.folder)
        self.assertEqual(table.column_names[:2], ["run", "part"])  # then those of the key
        columns = table.to_pydict()
        left = {"mixed", "none", "scenario", "message"}
        self.assertEqual({name: columns[name] for name in columns if name not in left},
                         {"run": [0, 2, 3, 4], "part": [0, 1, 0, 0], "b": [None, 2.5, 7.0, 1.0],
                          "flag": [None, None, None, True], "text": [None, None, "3", "a"],
                          "end": ["done", "tripped", "done", "done"],
                          "late": [5.0, None, None, None]})
        self.assertEqual(table.schema.names.count("mixed"), 1)
        self.assertEqual(columns["mixed"], [None, "true", "1.5", None])  # of two kinds
        self.assertEqual(store.column("a", [True, 1.5]).to_pylist(), ["True", "1.5"])
        self.assertEqual(store.column("a", [1, None, 2]).to_pylist(), [1.0, None, 2.0])

    def test_what_a_page_shows(self):
        file = self.folder / "plan.toml"
        file.write_text('scenario = "circle"\n[keys]\nname = "it is"\n[grid]\n'
                        'controller = ["fc", "afc"]\n"gains.kp" = [0.1, 0.2, 0.3]\n')
        plan = sweep.Plan(file)
        with store.Store(self.folder / "out", plan.identity()) as kept:
            kept.add([{"run": n, **plan.run(n)[1], "part": 0, "scenario": "circle", "end": "done",
                       "message": f"m{n}", "event_hash": "0", "wall_s": 0.5,
                       "a.b_mm": (1.23456789, float("nan"), float("inf"), 4.0, None)[n]}
                      for n in range(5)])
            data = page.data(plan, kept.table())
            with mock.patch.object(page, "MOST", 3):
                few = page.data(plan, kept.table())
            with mock.patch.object(page, "MOST", 5):
                self.assertEqual(page.data(plan, kept.table()), data)
        self.assertEqual({a["name"]: (a["key"], a["values"]) for a in data["axes"]}, {
            "gains.kp": (True, [0.1, 0.2, 0.3, 0.1, 0.2]), "wall_s": (False, [0.5] * 5),
            "a.b_mm": (False, [1.23457, None, None, 4.0, None])})
        self.assertEqual(data["words"], [
            {"name": "controller", "key": True, "values": ["fc"] * 3 + ["afc"] * 2}])
        self.assertEqual((data["of"], data["title"], data["what"], data["message"]),
                         (6, "plan", "runs", [f"m{n}" for n in range(5)]))
        self.assertEqual(data["commands"][4], "./trammel run circle -s run.engine=twin "
                         "-s 'name=it is' -s controller=afc -s gains.kp=0.2")
        self.assertEqual((few["runs"], few["of"], few["commands"]),
                         ([0, 2, 4], 6, data["commands"][::2]))


class Verb(Scratch):
    """What the verb makes of its command line, without a run."""

    def test_a_shard_is_one_of_several(self):
        for text, shard in (("1/1", (1, 1)), ("1/3", (1, 3)), ("3/3", (3, 3))):
            self.assertEqual(verb.shard_of(text), shard)
        for text in ("0/3", "4/3", "-1/3", "2", "1/2/3", "a/3", "", "1.0/2"):
            with self.assertRaisesRegex(sweep.PlanError, f"^--shard {text}: expects i/n"):
                verb.shard_of(text)

    def swept(self, *words, count=3, done=None):
        """Exit code, output, and what perform() was called with."""
        given = command_line.sweep().parse_args(["some/plan.toml", *words])
        plan = SimpleNamespace(count=count, file=Path(given.plan))
        with mock.patch.object(verb, "Plan", lambda _: plan), contextlib.redirect_stdout(
                io.StringIO()) as said, mock.patch.object(
                verb, "perform", return_value=done or verb.Done(2, 0, 1, 0.5)) as perform:
            code = verb._sweep(given)
        return code, said.getvalue(), perform

    def test_what_is_asked_of_a_sweep(self):
        code, said, perform = self.swept("--shard", "2/3", "--limit", "7.5", "--empty")
        (_, folder), options = perform.call_args
        self.assertEqual(folder, Path("out/plan"))
        self.assertEqual(options, {"jobs": 0, "cluster": "local", "scheduler": "", "shard": (2, 3),
                                   "limit_s": 7.5, "show": True, "empty": True})
        self.assertEqual((code, said), (0, "plan: 2 of 3 runs, 2 of them now, 4 per s; 0 without a "
                                        "result\n  results in out/plan\n  page: "
                                        "out/plan/page.html\n"))
        for words, jobs in ((["--cluster", "pbs"], 4), (["--cluster", "pbs", "--jobs", "3"], 3),
                            (["--jobs", "2"], 2)):
            self.assertEqual(self.swept(*words)[2].call_args.kwargs["jobs"], jobs, words)
        self.assertEqual(self.swept("-o", "a/b")[2].call_args.args[1], Path("a/b"))
        for refused, left, code in ((0, 1, 0), (0, 0, 0), (1, 0, 1)):
            self.assertEqual(self.swept(done=verb.Done(2, refused, left, 1.0))[0], code)

    def test_many_runs_are_asked_for(self):
        self.assertEqual(self.swept(count=10**7)[0], 0)
        self.assertEqual(self.swept("--yes", count=10**7 + 1)[0], 0)
        self.assertEqual(self.swept("--count", count=10**7 + 1)[:2], (0, "10000001\n"))
        with self.assertRaisesRegex(sweep.PlanError, "10000001 runs, more than 10000000; --yes"):
            self.swept(count=10**7 + 1)

    def test_the_verbs_of_the_package(self):
        for words, code, said in (([], 2, "usage: python -m trammel sweep PLAN.toml, or tune"),
                                  (["swap"], 2, "usage: python -m trammel sweep PLAN.toml, or"),
                                  (["sweep"], 2, "sweep: .*PLAN.toml; see trammel sweep --help$"),
                                  (["tune"], 2, "tune: .*STUDY.toml; see trammel tune --help$")):
            done = subprocess.run([sys.executable, "-m", "trammel", *words], capture_output=True,
                                  text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (code, ""), words)
            self.assertRegex(done.stderr, f"^{said}")
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_options_are_not_cut_short(self):
        with self.assertRaises(SystemExit) as told, contextlib.redirect_stderr(io.StringIO()):
            command_line.sweep().parse_args(["a.toml", "--sched", "x"])
        self.assertEqual(told.exception.code, 2)

    def test_the_line_of_a_terminal(self):
        told, screen = [], io.StringIO()
        screen.isatty = lambda: True
        with mock.patch.object(sys, "stderr", screen), mock.patch.object(
                verb.time, "monotonic", side_effect=[0, 0, 2, 2.1, 4]):
            progress = verb.Progress(True, lambda *both: told.append(both), "trials")
            progress.begin(40)
            for _ in range(3):
                progress.add(10)
        self.assertEqual(screen.getvalue(), "\r\x1b[K10 of 40 trials, 5 per s, 6 s left"
                                            "\r\x1b[K30 of 40 trials, 7.5 per s, 1 s left")
        self.assertEqual(told, [(10, 40), (20, 40), (30, 40)])
        with mock.patch.object(sys, "stderr", io.StringIO()) as silent:
            verb.Progress(True).add(1)
            verb.Progress(True).close()
        self.assertEqual(silent.getvalue(), "")

    def made(self, sizes, error=None):
        """What _make() gives of tasks of these sizes, and the lengths of the files it kept."""
        plan = SimpleNamespace(parts=[], run=lambda n: (0, {}))
        files = []

        def rows(*_):
            yield from ([{}] * size for size in sizes)
            if error:
                raise error

        workers = SimpleNamespace(client=lambda *_: contextlib.nullcontext(), rows=rows)
        kept = SimpleNamespace(add=lambda some: files.append(len(some)))
        with mock.patch.object(verb, "FLUSH_ROWS", 5), contextlib.suppress(ZeroDivisionError):
            return verb._make(plan, kept, np.arange(9), workers, 1, "local", "", 1,
                              verb.Progress(False), False), files
        return None, files

    def test_rows_are_kept_as_they_come(self):
        self.assertEqual(self.made([2, 2, 1, 1]), (6, [5, 1]))
        self.assertEqual(self.made([5]), (5, [5]))
        self.assertEqual(self.made([2, 2]), (4, [4]))
        self.assertEqual(self.made([5, 2], ZeroDivisionError()), (None, [5, 2]))
        with mock.patch.object(verb, "FLUSH_S", -1):
            self.assertEqual(self.made([2, 1]), (3, [2, 1]))


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
