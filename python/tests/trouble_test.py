# SPDX-License-Identifier: Apache-2.0
"""What goes wrong on the way of a sweep or a study: full and read-only disks, Ctrl-C, callbacks
that raise, two at once, a scheduler that says nothing. One line each, and what is done is kept:
trouble_test.py PROGRAM (which is not used)."""

import contextlib
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import sweeps

from trammel import sweep, tune
from trammel.sweep import PlanError

RUNS = 40
PLAN = sweeps.plan(RUNS, 0.2)
STUDY = """trials = 12
[keys]
"run.max_s" = 20
[search]
"gains.kp" = {log = [0.3, 1.0]}
[[objective]]
figure = "tracking.model.mean_mm"
"""


@contextlib.contextmanager
def disk(size):
    """A small disk of its own; the test is skipped where that is not permitted."""
    with tempfile.TemporaryDirectory() as folder:
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", folder],
                              capture_output=True, check=False)
        if made.returncode != 0:
            raise unittest.SkipTest("no file system may be mounted here")
        try:
            yield Path(folder)
        finally:
            subprocess.run(["umount", "-l", folder], check=True)


class Trouble(sweeps.Case):
    def setUp(self):
        super().setUp()
        self.plan = self.written("plan.toml", PLAN)
        self.study = self.written("study.toml", STUDY)

    def begin(self, verb, out, *words):
        file = self.plan if verb == "sweep" else self.study
        return sweeps.begin(verb, file, "-o", out, "--jobs", "1", *words, start_new_session=True)

    def ended(self, child, code, message):
        """It has ended with this code and one line."""
        _, errors = child.communicate(timeout=120)
        self.assertEqual(child.returncode, code, errors)
        self.assertRegex(errors, message)
        self.assertEqual(errors.count("\n"), 1, errors)

    def kept(self, out):
        """Numbers of the runs that are there, each once."""
        found = sweep.read(out)["run"].to_pylist()
        self.assertEqual(len(found), len(set(found)))
        return found

    def until(self, child, test):
        limit = time.monotonic() + 60
        while not test() and child.poll() is None and time.monotonic() < limit:
            time.sleep(0.02)

    def files(self, out):
        return list((out / "runs").glob("*.parquet"))

    def test_a_full_disk_ends_a_sweep_that_goes_on_when_there_is_room(self):
        with disk("256k") as place:
            out = place / "out"
            child = self.begin("sweep", out)
            self.until(child, lambda: len(self.files(out)) > 1)
            ballast = place / "ballast"
            with contextlib.suppress(OSError), ballast.open("wb", buffering=0) as stream:
                while True:
                    stream.write(bytes(4096))
            self.ended(child, 2, "^sweep: .*out.*: No space left on device; what is done is kept$")
            before = self.kept(out)
            self.assertTrue(0 < len(before) < RUNS, before)
            self.assertFalse([f for f in os.listdir(out / "runs") if f.startswith(".")])
            ballast.unlink()
            subprocess.run(["mount", "-o", "remount,size=16m", place], check=True)
            done = sweep.run(self.plan, out, jobs=1)
            self.assertEqual((done.runs, done.left), (RUNS - len(before), 0))
            self.assertEqual(self.kept(out), list(range(RUNS)))

    def test_a_disk_that_is_full_from_the_start(self):
        with disk("8k") as place:
            with contextlib.suppress(OSError):
                (place / "ballast").write_bytes(bytes(1 << 16))
            self.ended(self.begin("sweep", place / "out"), 2, "No space left on device")
            self.ended(self.begin("tune", place / "study"), 2, "No space left on device")
            (place / "ballast").unlink()
            subprocess.run(["mount", "-o", "remount,size=16m", place], check=True)
            self.assertEqual(sweep.run(self.plan, place / "out", jobs=1, empty=True).left, 0)
            tune.run(self.study, place / "study", jobs=1, trials=1)

    def test_a_full_disk_of_a_worker_is_no_result(self):
        with disk("64k") as place:
            (place / "ballast").write_bytes(bytes(60 << 10))
            child = subprocess.Popen(
                [sys.executable, "-m", "trammel", "sweep", self.plan, "-o", self.out],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                env={**os.environ, "TMPDIR": str(place)})
            self.ended(child, 2, "No space left on device")
        done = sweep.run(self.plan, self.out, jobs=1)
        self.assertEqual((done.refused, done.left), (0, 0))

    def test_a_folder_that_cannot_be_written(self):
        with disk("1m") as place:
            subprocess.run(["mount", "-o", "remount,ro", place], check=True)
            for verb in ("sweep", "tune"):
                self.ended(self.begin(verb, place / "out"), 2, f"^{verb}: .*Read-only file system")

    def test_ctrl_c_keeps_what_is_done(self):
        """As a terminal sends it: to the workers, too."""
        child = self.begin("sweep", self.out)
        self.until(child, lambda: len(self.files(self.out)) > 1)
        os.killpg(child.pid, signal.SIGINT)
        self.ended(child, 130, "^sweep: interrupted; the same command goes on$")
        before = self.kept(self.out)
        self.assertTrue(0 < len(before) < RUNS, before)
        self.assertEqual(sweep.run(self.plan, self.out, jobs=1).runs, RUNS - len(before))

    def test_ctrl_c_ends_a_study_that_goes_on(self):
        child = self.begin("tune", self.out)
        journal = self.out / "trials.log"
        self.until(child, lambda: journal.is_file() and journal.read_text().count('"values"') > 2)
        os.killpg(child.pid, signal.SIGINT)
        self.ended(child, 130, "^tune: interrupted; the same command goes on$")
        self.assertTrue((self.out / "best.toml").is_file())
        with journal.open("a") as stream:
            stream.write('{"op_code": 5, "wor')  # what a kill leaves
        trials, best = tune.run(self.study, self.out, jobs=1)
        self.assertEqual((len(trials), len(best)), (12, 1))

    def test_a_callback_that_raises_ends_it(self):
        told = []

        def raise_it(made, count):
            told.append((made, count))
            if made >= 3:
                raise ZeroDivisionError(made)

        with self.assertRaises(ZeroDivisionError):
            sweep.run(self.plan, self.out, jobs=1, progress=raise_it)
        made, count = told[-1]
        self.assertEqual((len(self.kept(self.out)), count), (made, RUNS))
        study = self.folder / "study"
        with self.assertRaises(ZeroDivisionError):
            tune.run(self.study, study, jobs=1, progress=raise_it)
        self.assertTrue((study / "best.toml").is_file())
        self.assertTrue((study / "page.html").is_file())

    def test_two_at_once_in_one_folder(self):
        for verb in ("sweep", "tune"):
            out = self.folder / verb
            first = self.begin(verb, out)
            self.until(first, (out / "plan.json").exists if verb == "sweep"
                       else (out / "trials.log").exists)
            second = self.begin(verb, out)
            made = "sweep" if verb == "sweep" else "study"
            self.ended(second, 2, f"^{verb}: {out}: another {made} writes here now$")
            first.send_signal(signal.SIGINT)
            first.communicate(timeout=60)

    def test_a_scheduler_that_never_answers(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
            for verb in ("sweep", "tune"):
                begun = time.monotonic()
                child = self.begin(verb, self.folder / verb, "--scheduler", address, "--limit", "2")
                self.ended(child, 2, f"^{verb}: {address}: no worker within 2 s: .")
                self.assertLess(time.monotonic() - begun, 20)

    def test_a_batch_system_that_takes_no_job(self):
        """Programs of Slurm's names that hang, refuse a job, or never begin it."""
        programs = self.folder / "bin"
        programs.mkdir()

        def write(**texts):
            for name, text in texts.items():
                (programs / name).write_text(f"#!/bin/sh\n{text}\n")
                (programs / name).chmod(0o755)

        path = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}
        for sinfo, sbatch, message in (
                ("exec sleep 60", "exit 1", "sinfo: no answer within 2 s$"),
                ("exit 0", "echo 'sbatch: error: no such partition' >&2; exit 1",
                 "sbatch: error: no such partition$"),
                ("exit 0", "echo 'Submitted batch job 1'", "no worker within 2 s: none has come; "
                 "jobs that were sent may wait for their turn$")):
            write(sinfo=sinfo, sbatch=sbatch, scancel="exit 0")
            child = subprocess.Popen(
                [sys.executable, "-m", "trammel", "sweep", self.plan, "-o", self.out, "--limit",
                 "2", "--cluster", "slurm"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                text=True, env=path)
            self.ended(child, 2, f"^sweep: --cluster slurm: {message}")

    def test_no_run_can_be_made(self):
        self.plan.write_text(PLAN.replace("[random]", '"run.audit" = true\n[random]'))
        with self.assertRaisesRegex(PlanError, "run.audit|run.engine"):
            sweep.run(self.plan, self.out)
        self.plan.write_text('scenario = "circle"\n[grid]\n"run.audit" = [true]\n')
        done = sweep.run(self.plan, self.out, jobs=1)
        self.assertEqual((done.runs, done.refused), (1, 1))


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
