# SPDX-License-Identifier: Apache-2.0
"""Runs with the sanitizers: which they are, and what of them is a finding."""

import os
from types import SimpleNamespace
from unittest import mock

from scratch import Scratch, call
from trammel_tools.check import sanitize


class SanitizeTest(Scratch):
    def test_faults_are_run_with_each_wiring_in_turn(self):
        plan = {"faults": {"wiring": {
            "scenario": "cut", "settings": ["run.max_s=0.1"],
            "with": {"short": ["inject.axis=x"]}}}}
        kinds = ["open", "short", "register_flip"]
        with mock.patch.object(sanitize.machines, "runs", return_value=plan):
            found = list(sanitize.fault_runs("saw", kinds))
        head, tail = (5, "run", "cut"), ("-o", "OUT/fault", "-s", "run.max_s=0.1", "-s")
        self.assertEqual(found, [
            (*head, "--engine", "twin", *tail, "inject.fault=open"),
            (*head, "--platform", "systemc", *tail, "inject.fault=short", "-s", "inject.axis=x"),
            (*head, "--platform", "direct", *tail, "inject.fault=register_flip")])
        with mock.patch.object(sanitize.machines, "runs", return_value={}):
            self.assertEqual(list(sanitize.fault_runs("saw", kinds)), [])

    def succeeds(self, script, code, says=None):
        program = self.write("program", f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        program = sanitize.Program(program, self.folder, dict(os.environ))
        return call(lambda: program.succeeds(code, says, ["run", "OUT/a"]))

    def test_a_run_ends_as_it_must_without_a_finding(self):
        line = "echo 'trammel: a: no such scenario' >&2; exit 2"
        notice = "echo 'trammel: waves of 1 ms take 1 MB' >&2; "
        for script, code, says, good in (
                ("exit 0", 0, None, True), ("exit 5", 0, None, False), ("exit 0", 5, None, False),
                ("echo 'ERROR: AddressSanitizer: leak' >&2; exit 0", 0, None, False),
                (line, 2, "no such", True), (notice + line, 2, "no such", True),
                (line, 2, "no other", False), ("exit 2", 2, "no such", False),
                ("echo more >&2; " + line, 2, "no such", False),
                (line.replace("trammel: ", ""), 2, "no such", False)):
            got, out, err = self.succeeds(script, code, says)
            self.assertEqual((got, out, bool(err)), (good, "", not good), script)
        _, _, err = self.succeeds("exit 5", 2, "why")
        self.assertIn("exit code 5, expected 2 and one line that says `why`", err)

    def test_the_program_gets_the_folder_of_all_in_place_of_its_word(self):
        self.assertTrue(self.succeeds(f'[ "$1 $2" = "run {self.folder}/a" ]', 0)[0])

    def test_a_leak_checker_that_died_is_asked_again_but_not_for_ever(self):
        died = f"echo x >> tries; echo '{sanitize.TRACER_DIED}' >&2; exit 99"
        self.assertFalse(self.succeeds(died, 0)[0])
        self.assertEqual((self.folder / "tries").read_text().count("x"), sanitize.ATTEMPTS)
        self.assertTrue(self.succeeds(f"[ -f once ] || {{ touch once; {died}; }}", 0)[0])

    def test_what_is_asked_is_a_group(self):
        for words in ([], ["all"], ["drive", "lab"]):
            self.assertEqual(call(sanitize.main, *words)[0], 2, words)

    def test_a_group_passes_where_its_tests_and_its_program_do(self):
        for failed, done, runs, code in (("", "3", 0, 0), ("no", "3", 0, 1), ("", None, 0, 1),
                                         ("", "3", None, 1)):
            with mock.patch.multiple(
                    sanitize, build=lambda _, failed=failed: failed,
                    unit=lambda *_, done=done: done, program_of=lambda *_, runs=runs: runs,
                    coverage_cpp=SimpleNamespace(begin=lambda _: {}, count=lambda _: {},
                                                 short=lambda _: ["lab/a.cpp 3"])):
                self.assertEqual(call(sanitize.main, "drive")[0], code)
