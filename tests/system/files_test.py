#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `trammel` leaves when a disk, a folder or a file is against it.

usage: files_test.py PROGRAM [unittest options]      the built trammel program
"""

import contextlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from support.started import RUNS, WITH_WAVES, Case, limited, main


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

    def test_a_folder_without_a_name_is_refused(self):
        for verb in (["run", "circle"], ["report"]):
            self.refused(self.trammel(*verb, "-o", ""), "--out: needs a name")

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
        (self.folder / "one" / "run.json").unlink()
        before = trace.read_bytes()
        self.refused(self.trammel("track", "-o", "one/trace.csv"), "run's record")
        self.assertEqual(trace.read_bytes(), before)

    def test_folders_of_the_users_are_not_taken_for_ours(self):
        self.good(self.run_to("run"))
        (self.folder / "run" / "report.html").unlink()
        (self.folder / "run" / "report.html").mkdir()
        (self.folder / "run" / "report.html" / "notes").write_text("mine")
        (self.folder / ".run.trammel-backup").mkdir()
        (self.folder / ".run.trammel-backup" / "notes").write_text("mine")
        shutil.copytree(self.folder / "run", self.folder / ".run.trammel-copied")
        self.good(self.run_to("run", "--no-report"))
        self.refused(self.run_to("run"), "report.html there is not of the run")
        self.refused(self.trammel("report", "run"), "is a folder")
        for name in "run/report.html", ".run.trammel-backup", ".run.trammel-copied/report.html":
            self.assertEqual((self.folder / name / "notes").read_text(), "mine")
        self.nothing_else("run", ".run.trammel-backup", ".run.trammel-copied")

    def test_a_page_has_no_name_before_it_is_whole(self):
        self.good(self.run_to("run", "--no-report"))
        self.good(self.trammel("report", "run", "-o", "page.html"))
        whole = (self.folder / "page.html").stat().st_size
        parts = []  # that a kill would leave
        for _ in range(20):
            with subprocess.Popen([self.program, "report", "run", "-o", "page.html"],
                                  cwd=self.folder, stdout=subprocess.DEVNULL) as report:
                while report.poll() is None:
                    for entry in os.scandir(self.folder):
                        with contextlib.suppress(FileNotFoundError):
                            if entry.name != "run" and entry.stat().st_size != whole:
                                parts.append(entry.name)
        self.assertEqual(parts, [])
        self.nothing_else("page.html", "run")

    def test_a_folder_whose_name_is_no_text_is_named_as_bash_takes_it(self):
        odd = os.fsdecode(b"\xff'")
        self.good(self.run_to(odd, "-s", "name=mine", "--no-report"))
        command = json.loads((self.folder / odd / "metrics.json").read_text())["command"]
        self.assertEqual(command, r"./trammel run $'\xff\'/run.toml'")
        self.good(subprocess.run(
            ["bash", "-c", command.replace("./trammel", '"$0"') + " -o again", self.program],
            cwd=self.folder, capture_output=True, text=True, check=False, timeout=60))
        self.assertEqual(*((self.folder / name / "trace.csv").read_bytes()
                           for name in (odd, "again")))

    def test_a_view_names_its_files_in_a_line_each(self):
        odd = self.folder / "a\nb\"c"
        odd.mkdir()
        done = subprocess.run([self.program, *WITH_WAVES, "-o", "run"], cwd=odd, check=False,
                              timeout=60, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        view = (odd / "run" / "waves.gtkw").read_text(encoding="utf-8")
        self.assertIn('[dumpfile] "waves.fst"\n[savefile] "waves.gtkw"\n', view)

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
            run = subprocess.Popen([self.program, *RUNS[0], "-o", "run", "--no-report"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
            time.sleep(took * part)
            run.send_signal(signal.SIGKILL)
            run.wait()
            self.good(self.trammel("report", "run", "-o", "page.html"))
        self.good(self.run_to("run", "--no-report"))
        self.nothing_else("page.html", "run")

    def test_two_runs_at_once_leave_the_files_of_one(self):
        both = [subprocess.Popen([self.program, *RUNS[run], "-o", "run", "--no-report"],
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

    def test_a_table_has_a_most_of_rows(self):
        (self.folder / "long.csv").write_text("0,0\n600,0\n" * 1000, encoding="ascii")
        done = self.trammel("track", "-s", "path.kind=points", "-s", "path.points_file=long.csv")
        self.refused(done, "path.row_mm", "1199400 mm", "2398800 rows of 0.5 mm", "at most 250000")

    def test_names_are_told_without_what_has_no_shape(self):
        self.refused(self.trammel("run", "a\u202eb\u200bc"), "a\\u202eb\\u200bc")
        (self.folder / "a.lm628").write_text("\x1b[2J\n", encoding="ascii")
        self.refused(self.trammel("lm628", "a.lm628"), "\\u001b[2J: unknown command")
        (self.folder / "a.csv").write_text("1,2\n3,\x1b[2J\n", encoding="ascii")
        self.refused(self.trammel("track", "-s", "path.kind=points", "-s",
                                  "path.points_file=a.csv"), "found '3,\\u001b[2J'")

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


class Planted(Case):
    """What somebody else has put where a run is to be."""

    ALL = ("run", "--all", "--engine", "twin", "-s", "run.max_s=0.001")

    def test_experiments_are_not_put_among_files_of_the_user(self):
        (self.folder / "site").mkdir()
        (self.folder / "site" / "index.html").write_text("mine")
        self.refused(self.trammel(*self.ALL, "-o", "site"), "site", "holds no runs of --all")
        (self.folder / "file").write_text("mine")
        self.refused(self.trammel(*self.ALL, "-o", "file"), "is not a folder")
        (self.folder / "all" / ".step-fc.trammel-killed").mkdir(parents=True)
        self.assertEqual(self.trammel(*self.ALL, "-o", "all").returncode, 5)
        self.assertEqual(self.trammel(*self.ALL, "-o", "all").returncode, 5)
        (self.folder / "all" / "index.html").write_text("mine")
        self.refused(self.trammel(*self.ALL, "-o", "all"), "index.html there is no page of runs")
        (self.folder / "all" / "index.html").unlink()
        last = max((one for one in (self.folder / "all").iterdir() if one.is_dir()),
                   key=lambda one: one.stat().st_mtime_ns)
        shutil.rmtree(last)
        last.mkdir()
        (last / "notes").write_text("mine")
        before = {one: one.stat().st_ino for one in (self.folder / "all").iterdir()}
        self.refused(self.trammel(*self.ALL, "-o", "all"), last.name, "holds no run")
        self.assertEqual({one: one.stat().st_ino for one in (self.folder / "all").iterdir()},
                         before)
        self.nothing_else("all", "file", "site")

    def test_a_file_that_is_listed_and_not_the_runs_is_kept(self):
        self.good(self.run_to("run", "--no-report"))
        identity = self.folder / "run" / "run.json"
        listed = json.loads(identity.read_text())
        listed["files"] |= {name: {"bytes": 5, "crc32": "00000000"} for name in ("a", "b\0c")}
        identity.write_text(json.dumps(listed))
        self.refused(self.trammel("report", "run"), "run.json: is not the list of a run's files")
        del listed["files"]["b\0c"]
        identity.write_text(json.dumps(listed))
        (self.folder / "run" / "a").write_text("mine\n")
        self.good(self.run_to("run", "--no-report"))
        self.assertEqual((self.folder / "run" / "a").read_text(), "mine\n")
        self.good(self.trammel("report", "run"))

    def test_the_last_run_is_none_behind_a_link(self):
        self.good(self.run_to("away/run", "--no-report"))
        (self.folder / "out").mkdir()
        (self.folder / "out" / "x").symlink_to("../away/run")
        self.refused(self.trammel("report"), "no run in out/")
        self.assertFalse((self.folder / "away" / "run" / "report.html").exists())

    def test_a_lock_of_somebody_else_holds_no_run_up_for_ever(self):
        done = subprocess.run(["flock", ".", self.program, *RUNS[0], "-o", "run"], timeout=15,
                              cwd=self.folder, capture_output=True, text=True, check=False)
        self.good(done)

    def test_no_program_of_the_current_folder_is_started(self):
        tool = self.folder / "gnuplot"
        tool.write_text("#!/bin/sh\ntouch started\n", encoding="ascii")
        tool.chmod(0o755)
        for path in ({}, {"PATH": ""}, {"PATH": "/nowhere::"}):
            self.assertIn("gnuplot is missing", self.run_to("run", env=path).stderr)
        self.nothing_else("gnuplot", "run")

    def test_a_name_of_a_folder_is_no_address_in_a_page(self):
        self.good(self.run_to("one"))
        odd = "javascript:void(1)%2f?#&\u00e9"
        self.good(self.run_to(odd))
        self.good(self.trammel("report", "one", odd, "-o", "both.html"))
        page = (self.folder / "both.html").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r'"page":"([^"]*)"', page), [
            "one/report.html", "javascript%3Avoid%281%29%252f%3F%23%26%C3%A9/report.html"])

    def test_a_title_has_no_control_characters(self):
        self.good(self.run_to("run", "--no-report"))
        (self.folder / "run" / "run.json").unlink()  # as of an older version
        metrics = json.loads((self.folder / "run" / "metrics.json").read_text())
        metrics["scenario"] = "a\x1b\u202e</title>"
        (self.folder / "run" / "metrics.json").write_text(json.dumps(metrics))
        self.good(self.trammel("report", "run", "-o", "page.html"))
        page = (self.folder / "page.html").read_text(encoding="utf-8")
        title = page[page.index("<title>"):page.index("</title>")]
        self.assertFalse(set(title) & {"\x1b", "\u202e"}, title)

    def test_a_place_that_the_system_refuses_is_told_with_its_reason(self):
        (self.folder / "loop").symlink_to("loop")
        self.refused(self.run_to("loop/x"), "loop/x: Too many levels of symbolic links")
        self.refused(self.trammel(*self.ALL, "-o", "loop"), "loop: Too many levels")
        self.refused(self.run_to("a" * 5000), "File name too long")
        gone = self.folder / "gone"
        gone.mkdir()
        self.refused(self.run_to("run", preexec_fn=lambda: (os.chdir(gone), os.rmdir(gone))),
                     "current folder: No such file or directory")
        self.nothing_else("loop")


if __name__ == "__main__":
    main()
