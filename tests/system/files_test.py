#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `trammel` leaves when a disk, a stream, a folder or a signal is against it.

usage: files_test.py PROGRAM [unittest options]      the built trammel program

Each machine names runs of less than a second in its tests/runs.toml.
"""

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import machines

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ""
RUNS = [["run", case["scenario"], *case["arguments"]]
        for name in machines.folders() for case in machines.runs(name).get("files", [])]


def limited(size):
    """No file may grow beyond size, as on a disk that is full."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


def lines(text):
    return [line for line in text.split("\n") if line]


class Case(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def trammel(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, text=True, check=False,
                              timeout=60, **options)

    def run_to(self, out, *more, run=0, **options):
        return self.trammel(*RUNS[run], "-o", str(out), *more, **options)

    def good(self, done):
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(lines(done.stderr)), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def nothing_else(self, *names):
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), sorted(names))


class Disk(Case):
    def test_a_full_disk_leaves_the_whole_record_or_nothing(self):
        for run in range(len(RUNS)):
            self.good(self.run_to("whole", run=run))
            largest = max(p.stat().st_size for p in (self.folder / "whole").iterdir())
            for part in (0, 0.001, 0.01, 0.1, 0.3, 0.6, 0.8, 0.95, 0.999):
                done = self.run_to("cut", run=run, preexec_fn=limited(int(largest * part)))
                with self.subTest(run=RUNS[run], part=part):
                    self.refused(done, "cannot be")
                    self.nothing_else("whole")
            self.good(self.run_to("all", run=run, preexec_fn=limited(largest)))
            shutil.rmtree(self.folder / "all")
            shutil.rmtree(self.folder / "whole")

    def test_a_full_disk_keeps_the_run_that_was_there(self):
        self.good(self.run_to("run", "--no-report"))
        before = {p.name: p.read_bytes() for p in (self.folder / "run").iterdir()}
        self.refused(self.run_to("run", preexec_fn=limited(5000)), "cannot be")
        self.assertEqual(before, {p.name: p.read_bytes() for p in (self.folder / "run").iterdir()})
        self.nothing_else("run")


class Streams(Case):
    COMMANDS = (["--help"], ["--version"], ["list"], ["list", "keys"], ["doctor"],
                ["list", "--json"], RUNS[0] + ["-o", "run"])

    def test_results_that_stdout_does_not_take_are_an_error(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for command in self.COMMANDS:
                with self.subTest(command=command):
                    self.refused(self.trammel(*command, stdout=full), "standard output: cannot be "
                                 "written: No space left on device")

    def test_the_launcher_and_the_tools_do_the_same(self):
        for command in (["trammel", "--help"], ["trammel", "doctor"], ["trammel", "test", "--help"],
                        ["scripts/tool", "--list"], ["scripts/tool", "prove", "--help"]):
            def call(command=command, **options):
                return subprocess.run([ROOT / command[0], *command[1:]], stderr=subprocess.PIPE,
                                      text=True, check=False, timeout=60, **options)
            with self.subTest(command=command), open("/dev/full", "w", encoding="utf-8") as full:
                self.refused(call(stdout=full), "standard output: cannot be written: No space")
                self.refused(call(preexec_fn=lambda: os.close(1)),
                             "standard output: cannot be written: it is closed")
                ours, theirs = os.pipe()
                os.close(ours)
                with os.fdopen(theirs, "w") as pipe:
                    done = call(stdout=pipe)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_reader_that_goes_away_is_no_error(self):
        for command in self.COMMANDS:
            ours, theirs = os.pipe()
            os.close(ours)
            with self.subTest(command=command), os.fdopen(theirs, "w") as pipe:
                done = self.trammel(*command, stdout=pipe)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_closed_stdout_is_an_error_and_no_file_takes_its_place(self):
        done = self.run_to("run", stdout=None, preexec_fn=lambda: os.close(1))
        self.refused(done, "standard output: cannot be written")
        self.good(self.trammel("report", "run"))

    def test_without_stderr_the_code_is_that_of_the_run(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for options in ({"stderr": full}, {"stderr": None, "preexec_fn": lambda: os.close(2)}):
                self.assertEqual(self.run_to("run", **options).returncode, 0)
                self.assertEqual(self.trammel("run", "nothing", **options).returncode, 2)
                self.assertEqual(self.trammel("nothing", **options).returncode, 2)


class Folders(Case):
    def test_a_second_run_replaces_the_first_and_carries_over_what_is_not_its(self):
        self.good(self.run_to("run", run=-1))
        self.good(self.trammel("report", "run"))
        (self.folder / "run" / "notes.txt").write_text("mine")
        (self.folder / "run" / "more").mkdir()
        (self.folder / "run" / "more" / "data").write_text("mine too")
        self.good(self.run_to("run", "--no-report"))
        names = {p.name for p in (self.folder / "run").iterdir()}
        listed = set(json.loads((self.folder / "run" / "run.json").read_text())["files"])
        self.assertEqual(names, listed | {"run.json", "notes.txt", "more"})
        self.assertEqual((self.folder / "run" / "more" / "data").read_text(), "mine too")
        self.good(self.trammel("report", "run"))
        self.nothing_else("run")

    def test_a_file_of_the_user_keeps_its_name(self):
        self.good(self.run_to("run", "--no-report"))
        listed = json.loads((self.folder / "run" / "run.json").read_text())
        del listed["files"]["trace.csv"]
        (self.folder / "run" / "run.json").write_text(json.dumps(listed))
        self.refused(self.run_to("run"), "trace.csv", "is not of the run")
        self.nothing_else("run")

    def test_a_folder_that_holds_no_run_is_refused(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine" / "table.csv").write_text("mine")
        (self.folder / "file").write_text("mine")
        (self.folder / "away").symlink_to("nowhere")
        self.refused(self.run_to("mine"), "mine", "holds no run")
        self.refused(self.run_to("."), "current folder")
        self.refused(self.run_to(".."), "current folder")
        self.refused(self.run_to("file"), "is not a folder")
        self.refused(self.run_to("away"), "is not a folder")
        self.nothing_else("away", "file", "mine")
        (self.folder / "mine" / "table.csv").unlink()
        self.good(self.run_to("mine"))

    def test_a_mixture_of_two_runs_is_refused(self):
        self.good(self.run_to("one", "--no-report"))
        trace = self.folder / "one" / "trace.csv"
        text = trace.read_text()
        trace.write_text(text.replace("0.00", "0.01", 1))
        self.refused(self.trammel("report", "one"), "trace.csv", "not what the run wrote")
        trace.write_text(text)
        self.good(self.trammel("report", "one"))
        identity = (self.folder / "one" / "run.json").read_text()
        (self.folder / "one" / "run.json").write_text(identity[:-20])
        self.refused(self.trammel("report", "one"), "run.json", "not the list of a run's files")
        (self.folder / "one" / "run.json").write_text(identity)
        (self.folder / "one" / "run.toml").unlink()
        self.refused(self.trammel("report", "one"), "run.toml", "is missing")

    def test_a_page_replaces_pages_only(self):
        self.good(self.run_to("run", "--no-report"))
        os.mkfifo(self.folder / "fifo")
        (self.folder / "link").symlink_to("target")
        for name in ("run/trace.csv", "run/metrics.json", "run/run.json"):
            before = (self.folder / name).read_bytes()
            self.refused(self.trammel("report", "run", "-o", name), "run's record")
            self.assertEqual((self.folder / name).read_bytes(), before)
        for name in ("fifo", "link", "/dev/null"):
            self.refused(self.trammel("report", "run", "-o", name), "not a regular file")
        self.good(self.trammel("report", "run", "-o", "page.html"))
        self.good(self.trammel("report", "run", "-o", "page.html"))
        self.nothing_else("fifo", "link", "page.html", "run")

    def test_what_killed_runs_have_left_is_removed(self):
        self.good(self.run_to("run", "--no-report"))
        begin = time.monotonic()
        self.good(self.run_to("run", "--no-report"))
        took = time.monotonic() - begin
        for part in (0.2, 0.5, 0.7, 0.8, 0.85, 0.9, 0.95, 1.0):
            run = subprocess.Popen([PROGRAM, *RUNS[0], "-o", "run", "--no-report"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(took * part)
            run.send_signal(signal.SIGKILL)
            run.wait()
            self.good(self.trammel("report", "run", "-o", "page.html"))
        self.good(self.run_to("run", "--no-report"))
        self.nothing_else("page.html", "run")

    def test_two_runs_at_once_leave_the_files_of_one(self):
        both = [subprocess.Popen([PROGRAM, *RUNS[run], "-o", "run", "--no-report"],
                                 cwd=self.folder, stdout=subprocess.DEVNULL,
                                 stderr=subprocess.PIPE) for run in (0, -1, 0, -1)]
        for run in both:
            _, said = run.communicate(timeout=60)
            self.assertEqual((run.returncode, said), (0, b""))
        self.good(self.trammel("report", "run", "-o", "page.html"))
        listed = set(json.loads((self.folder / "run" / "run.json").read_text())["files"])
        self.assertEqual({p.name for p in (self.folder / "run").iterdir()}, listed | {"run.json"})
        self.nothing_else("page.html", "run")


class Input(Case):
    """What is read: regular files to a limit, and standard input where it is named."""

    def setUp(self):
        super().setUp()
        os.mkfifo(self.folder / "fifo")
        (self.folder / "empty").mkdir()
        self.refusals = {"fifo": "not a regular file", "/dev/zero": "not a regular file",
                         "empty": "it is a folder", "/proc/self/mem": "Input/output error",
                         "none/at/all": "No such file or directory"}

    def test_scenarios_and_tables_are_regular_files(self):
        for name, why in self.refusals.items():
            with self.subTest(name=name):
                self.refused(self.trammel("run", self.folder / name), why)
                for run in RUNS:
                    self.refused(self.trammel(*run, "-c", name, "-o", "out"), name, why)
                self.refused(self.trammel("run", "circle", "-s", "path.kind=points", "-s",
                                          f"path.points_file={name}"), why)
        self.nothing_else("empty", "fifo")

    def test_a_pipe_is_refused_with_that_reason(self):
        for verb in "run", "track", "lm628":
            done = self.trammel(verb, "/dev/stdin", input="[run]\nmax_s = 0.01\n")
            self.refused(done, "/dev/stdin: cannot be read: it is not a regular file")

    def test_a_script_of_standard_input_is_read_to_its_limit(self):
        self.good(self.trammel("lm628", "-", input="RDSTAT\n"))
        with open("/dev/zero", encoding="utf-8") as endless:
            self.refused(self.trammel("lm628", stdin=endless), "standard input", "than 4 MiB")
        folder = os.open(self.folder, os.O_RDONLY)
        self.refused(self.trammel("lm628", "-", stdin=folder), "Is a directory")
        os.close(folder)

    def test_names_that_are_no_utf_8_are_told_as_bytes(self):
        script = self.folder / os.fsdecode(b"\xff.lm628")
        script.write_text("wait 1 s\n", encoding="ascii")
        self.refused(self.trammel("lm628", script.name), 'name: "\\xff" cannot name')
        done = self.trammel("lm628", script.name, "-s", "name=a", "-s", "run.max_s=0.001", "-o",
                            os.fsdecode(b"out\xff"))
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("trammel: \\xff.lm628:1: ", done.stderr)
        done = self.trammel("report", os.fsdecode(b"out\xff"), "--json")
        self.good(done)
        json.loads(done.stdout)

    def test_files_of_a_run_are_regular_files(self):
        self.good(self.run_to("run"))
        names = [*json.loads((self.folder / "run" / "run.json").read_text())["files"]]
        for name in names:
            path = self.folder / "run" / name
            before = path.read_bytes()
            path.unlink()
            os.mkfifo(path)
            with self.subTest(name=name):
                self.refused(self.trammel("report", "run"), name)
            path.unlink()
            path.write_bytes(before)
        self.good(self.trammel("report", "run"))

    def test_a_lack_of_memory_is_told_with_its_limit(self):
        def little():
            resource.setrlimit(resource.RLIMIT_DATA, (40 << 20, 40 << 20))
        with (self.folder / "large.csv").open("w", encoding="utf-8") as table:
            table.writelines(f"{k % 100},{k % 77}\n" for k in range(2_000_000))
        self.refused(self.trammel("track", "-s", "path.kind=points", "-s",
                                  "path.points_file=large.csv", preexec_fn=little),
                     "memory did not suffice: ulimit -d allows 40960 KiB")

    def test_a_table_replaces_tables_only(self):
        self.good(self.run_to("run", "--no-report"))
        (self.folder / "link").symlink_to("target")
        before = (self.folder / "run" / "trace.csv").read_bytes()
        self.refused(self.trammel("track", "-o", "run/trace.csv"), "run's record")
        self.assertEqual((self.folder / "run" / "trace.csv").read_bytes(), before)
        for name in ("fifo", "link", "/dev/null"):
            self.refused(self.trammel("track", "-o", name), "not a regular file")
        self.refused(self.trammel("track", "-o", "empty"), "is a folder")
        self.good(self.trammel("track", "-o", "new/table.csv"))
        self.good(self.trammel("track", "-o", "new/table.csv"))
        self.nothing_else("empty", "fifo", "link", "new", "run")


if __name__ == "__main__":
    PROGRAM = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
