#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `trammel` does when a stream or a signal is against it.

usage: streams_test.py PROGRAM [unittest options]      the built trammel program
"""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from support.started import RUNS, WITH_WAVES, Case, limited, lines, main

from trammel_tools.paths import ROOT


class Streams(Case):
    COMMANDS = (["--help"], ["--version"], ["list"], ["list", "keys"], ["doctor"],
                ["list", "--json"], ["lm628", "absolute"], ["track"], RUNS[0] + ["-o", "run"])

    def test_results_that_stdout_does_not_take_are_an_error(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for command in self.COMMANDS:
                with self.subTest(command=command):
                    self.refused(self.trammel(*command, stdout=full), "standard output: cannot be "
                                 "written: No space left on device")

    def test_the_launcher_and_the_tools_do_the_same(self):
        for command in (["trammel", "--help"], ["trammel", "doctor"], ["trammel", "test", "--help"],
                        ["scripts/tool", "--list"], ["scripts/tool", "prove", "--help"],
                        ["scripts/new_block.py", "--help"], ["scripts/new_machine.py", "--help"]):
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

    def test_the_launcher_exits_with_2_where_nothing_is_asked_that_there_is(self):
        for code, *words in ((2,), (0, "help"), (0, "-h"), (0, "--help"), (2, "test", "a/b"),
                             (0, "test", "-h"), (0, "prove", "--help")):
            with self.subTest(words=words):
                done = subprocess.run([ROOT / "trammel", *words], check=False, timeout=60,
                                      capture_output=True, text=True,
                                      env={**os.environ, "TRAMMEL_NO_APT": "1"})
                self.assertEqual(done.returncode, code, done.stderr)

    def test_the_launcher_and_the_tools_need_no_stderr(self):
        for code, *command in ((0, "trammel", "--help"), (2, "trammel", "test", "a/b"),
                               (0, "scripts/tool", "--list"), (2, "scripts/tool", "nothing"),
                               (2, "scripts/new_block.py", "nothing"),
                               (2, "scripts/new_machine.py", "X")):
            def call(command=command, **options):
                done = subprocess.run([ROOT / command[0], *command[1:]], check=False, timeout=60,
                                      **{"stdout": subprocess.PIPE, **options})
                return done.returncode, bool(done.stdout)
            with self.subTest(command=command), open("/dev/full", "w", encoding="utf-8") as full:
                self.assertEqual(call(stderr=full), (code, code == 0))
                self.assertEqual(call(preexec_fn=lambda: os.close(2)), (code, code == 0))
                self.assertEqual(call(stdout=full, stderr=full)[0], 2)
                self.assertEqual(call(stdout=None, preexec_fn=lambda: os.closerange(1, 3))[0], 2)

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


    def test_a_closed_stdin_is_no_empty_script(self):
        for words in (["lm628", "-"], ["lm628"]):
            done = self.trammel(*words, stdin=None, preexec_fn=lambda: os.close(0))
            self.refused(done, "standard input: cannot be read")

    def test_a_script_that_is_cut_on_a_full_disk_is_one_message(self):
        (self.folder / "long.lm628").write_text("wait 1 s\n", encoding="ascii")
        self.refused(self.trammel("lm628", "long.lm628", "-s", "run.max_s=0.002", "-o", "out",
                                  preexec_fn=limited(2000)), "metrics.json: cannot be written")
        self.nothing_else("long.lm628")


class Signals(Case):
    def own_tool(self, name, text):
        """A program of the user's that stands before the one of that name."""
        tools = self.folder / "tools"
        tools.mkdir(exist_ok=True)
        (tools / name).write_text(f"#!/bin/sh\n{text}\nexec {shutil.which(name)} \"$@\"\n",
                                  encoding="ascii")
        (tools / name).chmod(0o755)
        return {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}

    def test_a_signal_to_all_while_a_tool_works_leaves_the_whole_record(self):
        run = ["vcd" if word == "fst" else word for word in WITH_WAVES]
        self.good(self.trammel(*run, "-o", "whole"))
        names = sorted(p.name for p in (self.folder / "whole").iterdir())
        for name in "gnuplot", "fst2vcd":
            for sent in "INT", "TERM":
                path = self.own_tool(name, f"kill -s {sent} -- -$PPID")
                done = self.trammel(*run, "-o", "run", env=path, start_new_session=True)
                with self.subTest(name=name, sent=sent):
                    self.assertEqual(done.returncode, 130, done.stderr)
                    self.assertEqual(len(lines(done.stderr)), 1, done.stderr)
                    self.assertIn("interrupted after the run; record kept in run", done.stderr)
                    self.assertEqual(sorted(p.name for p in (self.folder / "run").iterdir()), names)
                    self.good(self.trammel("report", "run"))
            shutil.rmtree(self.folder / "tools")
        self.nothing_else("run", "whole")

    def test_a_second_signal_ends_the_program_at_once(self):
        sent = "kill -s INT $PPID; sleep 0.3; kill -s INT $PPID; sleep 0.3"
        done = self.run_to("run", env=self.own_tool("gnuplot", sent))
        self.assertEqual(done.returncode, -signal.SIGINT, done.stderr)
        self.assertFalse((self.folder / "run").exists())
        shutil.rmtree(self.folder / "tools")
        self.good(self.run_to("run"))
        self.nothing_else("run")

    def test_a_gnuplot_that_fails_is_told_as_such(self):
        done = self.run_to("run", env=self.own_tool("gnuplot", "exit 1"))
        self.assertEqual((done.returncode, done.stderr),
                         (0, "trammel: no pictures: gnuplot failed\n"))

    def test_a_table_in_the_making_ends_at_the_first_signal(self):
        with (self.folder / "long.csv").open("w", encoding="ascii") as table:
            table.write("0,0\n" * 4_000_000)
        for sent in signal.SIGINT, signal.SIGTERM:
            track = subprocess.Popen([self.program, "track", "-s", "path.kind=points", "-s",
                                      "path.points_file=long.csv", "-o", "table.csv"],
                                     cwd=self.folder, stderr=subprocess.DEVNULL)
            time.sleep(0.3)
            track.send_signal(sent)
            self.assertEqual(track.wait(timeout=60), -sent)
        self.nothing_else("long.csv")


if __name__ == "__main__":
    main()
