# SPDX-License-Identifier: Apache-2.0
"""`trammel sweep` from plan to page: sweep_test.py PROGRAM (which is not used)."""

import contextlib
import json
import logging
import os
import shlex
import signal
import subprocess
import sys
import time
import unittest

import distributed
import psutil
import sweeps

import trammel
from trammel import sweep
from trammel.sweep import store, work

SHORT = '"run.max_s" = 0.03\n'
PLAN = f"""[[part]]
scenario = "circle"
[part.keys]
{SHORT}[part.grid]
controller = ["fc", "afc"]
"plant.payload_kg" = {{from = 0, to = 22, count = 3}}
[[part]]
scenario = "%s"
[part.keys]
{SHORT}"""


def other_scenario():
    """One of another machine than the circle's."""
    first = trammel.settings("circle").machine
    return next(s for s in trammel.scenarios() if trammel.settings(s).machine != first)


def command(*words, script=""):
    start = ["-c", script] if script else ["-m", "trammel", "sweep"]
    return [sys.executable, *start, *map(str, words)]


def run(*words):
    return subprocess.run(command(*words), capture_output=True, text=True, check=False)


class Sweeps(sweeps.Case):
    def plan(self, text):
        return self.written("plan.toml", text)

    def test_rows_are_the_runs(self):
        plan = self.plan(PLAN % other_scenario())
        done = run(plan, "-o", self.out, "--jobs", 2)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stderr)
        self.assertIn("7 of 7 runs", done.stdout)
        rows = sweep.read(self.out).to_pylist()
        self.assertEqual([row["run"] for row in rows], list(range(7)))
        for row in (rows[4], rows[6]):
            keys = {"controller": row["controller"], "plant.payload_kg": row["plant.payload_kg"]}
            alone = trammel.run(row["scenario"], engine="twin", **{"run.max_s": 0.03},
                                **{k: v for k, v in keys.items() if v is not None})
            self.assertEqual((row["end"], row["event_hash"]), (alone.end, alone.event_hash))
            for place, figure in alone.figures.items():
                self.assertEqual(row[place], float(figure), place)
        again = run(plan, "-o", self.out)
        self.assertIn("0 of them now", again.stdout)
        page = (self.out / "page.html").read_text()
        data = json.loads(page.split('id="data">')[1].split("</script>")[0])
        self.assertEqual(data["runs"], list(range(7)))
        for number, row in enumerate(rows):  # the engine, the part's own keys, and what varies
            keys = ["run.engine=twin", "run.max_s=0.03"]
            keys += [f"{key}={row[key]}" for key in ("controller", "plant.payload_kg")
                     if row[key] is not None]
            self.assertEqual(shlex.split(data["commands"][number]),
                             ["./trammel", "run", row["scenario"],
                              *(word for key in keys for word in ("-s", key))], number)
        changed = self.plan((PLAN % other_scenario()).replace("22", "23"))
        refused = run(changed, "-o", self.out)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("another plan", refused.stderr)
        self.assertEqual(refused.stderr.count("\n"), 1)

    def test_a_run_that_cannot_be_made_is_kept_with_its_message(self):
        plan = self.plan('scenario = "circle"\n[keys]\n' + SHORT +
                         '[table]\nfile = "points.csv"\n')
        (self.folder / "points.csv").write_text("run.audit,gains.kp\nfalse,0.1\ntrue,0.2\n")
        done = run(plan, "-o", self.out, "--jobs", 1)
        self.assertEqual(done.returncode, 1, done.stderr)
        good, bad = sweep.read(self.out).to_pylist()
        self.assertEqual((good["end"], bad["end"]), ("timeout", "refused"))
        self.assertIn("run.", bad["message"])
        self.assertIsNone(bad["event_hash"])

    def test_parts_that_give_one_key_other_values_are_other_runs(self):
        parts = [("circle", "twin", {"run.max_s": seconds}) for seconds in (0.02, 0.03)]
        parts += [("window", "twin", {"run.max_s": 0.03}), parts[0]]
        rows, _ = work.chunk(parts, [(number, number, {}) for number in range(len(parts))])
        for (scenario, engine, keys), row in zip(parts, rows, strict=True):
            alone = trammel.run(scenario, engine=engine, **keys)
            self.assertEqual((row["scenario"], row["event_hash"]), (scenario, alone.event_hash),
                             (scenario, keys))
        self.assertEqual(len({row["event_hash"] for row in rows}), 3)

    def test_what_is_refused_or_lost_has_no_result(self):
        plan = self.plan('scenario = "circle"\n[grid]\n"gains.kp" = [0.1, 0.2, 0.3]\n')
        for ends, refused in (("done timeout tripped", 0), ("done refused done", 1),
                              ("lost refused lost", 3), ("lost done done", 1)):
            out = self.folder / ends
            with store.Store(out, sweep.Plan(plan).identity()) as kept:
                kept.add([{"run": number, "part": 0, "scenario": "circle", "end": end,
                           "message": ""} for number, end in enumerate(ends.split())])
            done = sweep.run(plan, out)  # all are there: it makes none
            self.assertEqual((done.runs, done.refused, done.left), (0, refused, 0), ends)
        last = run(plan, "-o", out)
        self.assertEqual((last.returncode, last.stderr), (1, ""), ends)
        self.assertIn("3 of 3 runs, 0 of them now; 1 without a result", last.stdout)

    def test_a_worker_is_killed_and_then_the_sweep(self):
        plan = self.plan(sweeps.plan(120, 0.4))
        words = (plan, "-o", self.out, "--jobs", 2)
        child = subprocess.Popen(command(*words, script=sweeps.EAGER.format("sweep")),
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        files = lambda: list((self.out / "runs").glob("*.parquet"))  # noqa: E731
        until = time.monotonic() + 90
        while len(files()) < 2 and time.monotonic() < until and child.poll() is None:
            time.sleep(0.02)
        workers = [p for p in psutil.Process(child.pid).children(recursive=True)
                   if "spawn_main" in " ".join(p.cmdline())]
        self.assertTrue(workers)
        workers[0].kill()
        before = len(files())
        while len(files()) < before + 2 and time.monotonic() < until and child.poll() is None:
            time.sleep(0.02)
        with contextlib.suppress(ProcessLookupError):
            child.send_signal(signal.SIGKILL)
        child.wait()
        first = sweep.read(self.out)["run"].to_pylist()
        self.assertGreater(len(first), 0)
        self.assertEqual(len(first), len(set(first)))
        done = run(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        table = sweep.read(self.out)
        self.assertEqual(table["run"].to_pylist(), list(range(120)))
        self.assertEqual(set(table["end"].to_pylist()), {"timeout"})
        self.assertFalse([f for f in os.listdir(self.out / "runs") if f.startswith(".")
                          and not f.endswith(str(child.pid))])

    def test_shards_make_one_data_set(self):
        plan = self.plan('scenario = "circle"\n[random]\ncount = 50\n"gains.kp" = [0.1, 0.2]\n')
        for shard, left in (("1/2", "25 of 50"), ("2/2", "50 of 50")):
            done = run(plan, "-o", self.out, "--jobs", 1, "--empty", "--shard", shard)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(left, done.stdout)

    def test_workers_of_a_scheduler_that_is_there(self):
        plan = self.plan('scenario = "circle"\n[keys]\n' + SHORT +
                         '[grid]\n"gains.kp" = [0.1, 0.2]\n')
        with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None,
                                      silence_logs=logging.CRITICAL) as cluster:
            done = run(plan, "-o", self.out, "--scheduler", cluster.scheduler_address)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 of 2 runs", done.stdout)

    def refused(self, message, *words):
        done = run(*words)
        self.assertEqual(done.returncode, 2, done)
        self.assertRegex(done.stderr, message)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_what_is_refused(self):
        plan = self.plan('scenario = "circle"\n[random]\ncount = 11\n"gains.kp" = [0.1, 0.2]\n')
        self.refused("expects i/n", plan, "--shard", "3/2")
        self.refused("invalid choice|choose", plan, "--cluster", "cloud")
        self.refused("no worker within 1 s", plan, "-o", self.out, "--limit", "1", "--scheduler",
                     "tcp://127.0.0.1:9")
        self.refused("--cluster htcondor: condor_status: No such file", plan, "-o",
                     self.out, "--cluster", "htcondor")
        mine = self.folder / "mine"
        mine.mkdir()
        (mine / "x").write_text("mine")
        self.refused("not empty", plan, "-o", mine)
        many = self.plan('scenario = "circle"\n[grid]\n'
                         '"gains.kp" = {from = 0.1, to = 0.2, count = 10000}\n'
                         '"gains.ki" = {from = 0.1, to = 0.2, count = 1001}\n')
        self.refused("10010000 runs, more than 10000000; --yes", many, "-o", self.out)
        self.assertEqual(run(many, "--count").stdout, "10010000\n")
        self.refused("cannot be read", self.folder / "none.toml")


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
