# SPDX-License-Identifier: Apache-2.0
"""Links, pipes, devices and files of others where a sweep or a study has its own. One line refuses
each, nothing waits, and nothing that is not theirs changes: planted_test.py PROGRAM (which is not
used)."""

import errno
import json
import os
import resource
import stat
import sys
import unittest
from pathlib import Path
from unittest import mock

import pyarrow as pa
import sweeps
from pyarrow import parquet

from trammel import sweep, tune
from trammel.sweep import PlanError, files, store
from trammel.tune import StudyError

PLAN = 'scenario = "circle"\n[grid]\n"gains.kp" = [0.1, 0.2]\n'
STUDY = '''trials = 1
[search]
"gains.kp" = [0.1, 0.3]
[[objective]]
figure = "tracking.model.mean_mm"
'''
ROW = {"part": 0, "scenario": "circle", "end": "done", "message": ""}


def kinds(place):
    """Makes one after the other what is no regular file at a place."""
    place.symlink_to("../victim")
    yield "link"
    place.unlink()
    place.symlink_to("../absent")
    yield "dangling link"
    place.unlink()
    os.mkfifo(place)
    yield "pipe"
    place.unlink()
    place.mkdir()
    yield "folder"
    place.rmdir()


class Planted(sweeps.Case):
    def setUp(self):
        super().setUp()
        self.out.mkdir()
        self.victim = self.folder / "victim"
        self.victim.write_text("theirs")
        self.plan = self.written("plan.toml", PLAN)
        self.study = self.written("study.toml", STUDY)

    def harmed(self):
        """What should not be there, or is not as it was."""
        there = set(os.listdir(self.folder)) - {"out", "victim", "plan.toml", "study.toml"}
        return there or self.victim.read_text() != "theirs"

    def refused(self, message, action, *words, kind=PlanError):
        with self.assertRaisesRegex(kind, message) as told:
            action(*words)
        self.assertNotIn("\n", str(told.exception))
        self.assertFalse(self.harmed(), message)

    def filled(self):
        """A sweep of two runs."""
        with store.Store(self.out, sweep.Plan(self.plan).identity()) as kept:
            kept.add([{"run": n, "gains.kp": 0.1 * n, **ROW} for n in range(2)])
        return next((self.out / "runs").glob("*.parquet"))

    def test_in_the_place_of_the_lock(self):
        lock = self.out / ".lock"
        for kind in kinds(lock):
            with self.subTest(kind):
                for verb, file in ((sweep, self.plan), (tune, self.study)):
                    self.refused(f"^{lock}: not a regular file$", verb.run, file, self.out)
        lock.write_text("kept")
        store.lock(self.out, "", "sweep").close()
        self.assertEqual(lock.read_text(), "kept")

    def test_in_the_place_of_other_files(self):
        for verb, file, name in ((sweep, self.plan, "plan.json"), (tune, self.study, "study.json")):
            for kind in kinds(self.out / name):
                with self.subTest(f"{name}: {kind}"):
                    self.refused(f"^{self.out / name}: not a regular file$", verb.run, file,
                                 self.out)
        (self.out / "study.json").write_text(json.dumps(tune.Study(self.study).identity()))
        for kind in kinds(self.out / "page.html"):
            with self.subTest(f"page: {kind}"):
                self.refused("page.html: cannot be written: not a regular file$", tune.run,
                             self.study, self.out)
                self.refused("page.html: cannot be written: not a regular file$", sweep.run,
                             self.plan, self.out)
        for kind in kinds(self.out / "trials.log"):
            with self.subTest(f"journal: {kind}"):
                self.refused("trials.log: not a regular file$", tune.run, self.study, self.out)

    def test_in_the_place_of_the_runs(self):
        self.filled()
        runs, aside = self.out / "runs", self.folder / "aside"
        runs.rename(aside)
        runs.symlink_to(aside)
        for action in (lambda: sweep.run(self.plan, self.out), lambda: sweep.read(self.out)):
            with self.assertRaisesRegex(PlanError, f"^{runs}: is not a folder$"):
                action()
        self.assertEqual(len(list(aside.iterdir())), 1)
        runs.unlink()
        for kind in kinds(runs):
            if kind != "folder":
                with self.subTest(f"runs: {kind}"):
                    self.assertRaisesRegex(PlanError, "is not a folder$", sweep.run, self.plan,
                                           self.out)
        aside.rename(runs)
        for kind in kinds(runs / "x.parquet"):
            with self.subTest(kind):
                self.refused("x.parquet: not a regular file$", sweep.run, self.plan, self.out)
                self.refused("x.parquet: not a regular file$", sweep.read, self.out)

    def test_a_folder_of_others(self):
        for name in (".lock.txt", ".lock-1", ".locksmith", ".lock-1-of-2x", ".plan.json"):
            (self.out / name).write_text("theirs")
            for verb, file, made in ((sweep, self.plan, "sweep"), (tune, self.study, "study")):
                self.refused(f"^{self.out}: is not empty and holds no {made}; give another",
                             verb.run, file, self.out)
            self.assertEqual(os.listdir(self.out), [name])
            (self.out / name).unlink()
        # What another shard has there before it writes the record, and what a kill leaves of it.
        (self.out / ".lock-1-of-2").touch()
        (self.out / f".plan.json.{'0' * 16}-12").touch()
        self.filled()

    def test_a_file_is_replaced_whole(self):
        file = self.folder / "out" / "file"
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        for text in (b"one", b"two"):
            files.replace(file, text)
            self.assertEqual((file.read_bytes(), os.listdir(self.out)), (text, ["file"]))
            self.assertEqual(stat.S_IMODE(file.stat().st_mode), 0o640)
        before, most = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (2, most))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_FSIZE, (before, most))
        with self.assertRaises(OSError) as told:
            files.replace(file, b"three")
        resource.setrlimit(resource.RLIMIT_FSIZE, (before, most))
        self.assertEqual((told.exception.errno, told.exception.filename), (errno.EFBIG, str(file)))
        self.assertEqual((file.read_bytes(), os.listdir(self.out)), (b"two", ["file"]))
        for kind in kinds(self.out / "other"):
            with self.subTest(kind):
                self.refused("other: cannot be written: not a regular file$", files.replace,
                             self.out / "other", b"three")
        self.assertFalse(self.harmed())

    def test_plans_that_are_no_files(self):
        pipe = self.folder / "out" / "pipe.toml"
        os.mkfifo(pipe)
        for file in (pipe, Path("/dev/zero"), self.out):
            for verb, kind in ((sweep.Plan, PlanError), (tune.Study, StudyError)):
                self.refused(f"^{file}: not a regular file$", verb, file, kind=kind)
        for name in ("out/points.csv", "out/points.parquet"):
            os.mkfifo(self.folder / name)
            self.plan.write_text(f'scenario = "circle"\n[table]\nfile = "{name}"\n')
            self.refused(rf"plan.toml \[table\]: {self.folder / name}: not a regular", sweep.Plan,
                         self.plan)
        points = self.folder / "out" / "table.parquet"
        self.plan.write_text(f'scenario = "circle"\n[table]\nfile = "{points}"\n')
        for value in ({"a": 1}, [1], b"1"):
            parquet.write_table(pa.Table.from_pylist([{"gains.kp": value}] * 2), points)
            self.refused("gains.kp: holds other values than", sweep.Plan, self.plan)
        link = self.out / "link.toml"
        link.symlink_to("../study.toml")  # the user's own way to name a plan
        self.assertEqual(tune.Study(link).scenario, "circle")

    def test_no_more_is_read_than_a_file_may_have(self):
        self.assertEqual(files.read(self.victim, 3), b"thei")
        record = self.out / "plan.json"
        record.write_text("{}" + " " * 8)
        for most in (10, 9):
            with mock.patch.object(files, "MOST_RECORD", most):
                self.refused("another plan" if most == 10 else "is corrupt$", sweep.run, self.plan,
                             self.out)

    def test_plans_that_cannot_be_read_as_toml(self):
        for text in (b"a = " + b"[" * 100_000, b"seed = " + b"9" * 5000, b"a = '\xff'", b"a = \0"):
            self.plan.write_bytes(text)
            for verb in (sweep.Plan, tune.Study):
                self.refused(f"^{self.plan}: ", verb, self.plan)

    def test_records_that_others_have_changed(self):
        for verb, file, name in ((sweep, self.plan, "plan.json"), (tune, self.study, "study.json")):
            record = self.out / name
            for text in (b"", b"[]", b"[1]", b"1", b"1.5", b"true", b"null", b'"plan"', b"{",
                         b"\xff", b'{"plan": "\xff"}', b"[" * 100_000, b"9" * 5000):
                record.write_bytes(text)
                self.refused(f"^{record}: is corrupt$", verb.run, file, self.out)
            record.write_text('{"version": [], "runs": {}, "plan": null}')
            self.refused("holds the .* of another", verb.run, file, self.out)
            record.unlink()
        identity = tune.Study(self.study).identity()
        for best in (3, None, {}, [3], ["../victim"], ["study.toml"], [["best.toml"]]):
            (self.out / "study.json").write_text(json.dumps({**identity, "best": best}))
            self.refused("study.json: is corrupt$", tune.run, self.study, self.out)
        (self.out / "study.json").write_text(json.dumps(identity))
        for text in (b"[]\n", b"3\n", b"{}\n", b"\xff\n", b"{\n", b'{"op_code": 0}\n',
                     b'{"op_code": 0, "worker_id": "a", "study_name": "study", '
                     b'"directions": [1, 2]}\n'):
            (self.out / "trials.log").write_bytes(text)
            self.refused("trials.log: is corrupt$", tune.run, self.study, self.out)

    def test_runs_that_others_have_changed(self):
        file = self.filled()
        whole = file.read_bytes()
        middle = len(whole) // 2
        for text in (b"", b"PAR1", b"theirs", whole[:-9], b"PAR1" + b"\xff" * 64 + b"PAR1",
                     whole[:4] + bytes(middle) + whole[4 + middle:]):
            file.write_bytes(text)
            self.refused(f"^{self.out / 'runs'}.*: is corrupt$", sweep.run, self.plan, self.out)
        row = {"run": 0, **ROW}
        for change in ({"run": "0"}, {"run": 0.5}, {"end": 3}, {"message": None}, {"scenario": 1},
                       {"x": b"bytes"}, {"x": [1]}, {"x": {"y": 1}}):
            parquet.write_table(pa.Table.from_pylist([row | change]), file)
            self.refused(f"^{file}: holds no runs$", sweep.run, self.plan, self.out)
            self.refused(f"^{file}: holds no runs$", sweep.read, self.out)
        for name in row:
            rest = {k: v for k, v in row.items() if k != name}
            parquet.write_table(pa.Table.from_pylist([rest]), file)
            self.refused(f"^{file}: holds no runs$", sweep.run, self.plan, self.out)
        for number in (-1, 2, 1 << 40, None):
            parquet.write_table(pa.Table.from_pylist([row, row | {"run": number}]), file)
            self.refused(f"^{file}: holds a run that is not of this plan$", sweep.run, self.plan,
                         self.out)


if __name__ == "__main__":
    sys.argv[1:] = sys.argv[2:]
    unittest.main()
