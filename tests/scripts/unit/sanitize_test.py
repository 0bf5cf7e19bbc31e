# SPDX-License-Identifier: Apache-2.0
"""Runs with the sanitizers: which they are, and what of them is a finding."""

from unittest import mock

from scratch import Scratch, call
from trammel_tools.check import sanitize


class SanitizeTest(Scratch):
    def test_faults_are_run_with_each_wiring_in_turn(self):
        plan = {"faults": {"wiring": {
            "scenario": "cut", "kinds": ["open", "short", "register_flip"],
            "settings": ["run.max_s=0.1"], "with": {"short": ["inject.axis=x"]}}}}
        with mock.patch.object(sanitize.machines, "runs", return_value=plan):
            found = list(sanitize.fault_runs("saw"))
        head, tail = (5, "run", "cut"), ("-o", "OUT/fault", "-s", "run.max_s=0.1", "-s")
        self.assertEqual(found, [
            (*head, "--engine", "twin", *tail, "inject.fault=open"),
            (*head, "--platform", "systemc", *tail, "inject.fault=short", "-s", "inject.axis=x"),
            (*head, "--platform", "direct", *tail, "inject.fault=register_flip")])
        with mock.patch.object(sanitize.machines, "runs", return_value={}):
            self.assertEqual(list(sanitize.fault_runs("saw")), [])

    def succeeds(self, script, code, says=None):
        program = self.write("program", f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        self.patch(sanitize, PROGRAM=program, OUT=self.folder)
        return call(lambda: sanitize.succeeds(code, says, ["run", "OUT/a"]))

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
            self.assertEqual((got, bool(out), bool(err)), (good, good, not good), script)
        _, out, err = self.succeeds("exit 5", 2, "why")
        self.assertIn("exit code 5, expected 2 and one line that says `why`", err)

    def test_the_program_gets_the_folder_of_all_in_place_of_its_word(self):
        self.assertTrue(self.succeeds(f'[ "$1 $2" = "run {self.folder}/a" ]', 0)[0])

    def test_a_leak_checker_that_died_is_asked_again_but_not_for_ever(self):
        died = f"echo x >> tries; echo '{sanitize.TRACER_DIED}' >&2; exit 99"
        self.assertFalse(self.succeeds(died, 0)[0])
        self.assertEqual((self.folder / "tries").read_text().count("x"), sanitize.ATTEMPTS)
        self.assertTrue(self.succeeds(f"[ -f once ] || {{ touch once; {died}; }}", 0)[0])

    def test_what_is_asked_is_one_of_the_three(self):
        for words in ([], ["all"], ["unit", "program"]):
            self.assertEqual(call(sanitize.main, *words)[0], 2, words)
        for verb, function in (("build", "configure_and_build"), ("unit", "unit"),
                               ("program", "program")):
            with mock.patch.object(sanitize, function, return_value=7):
                self.assertEqual(call(sanitize.main, verb)[0], 7, verb)
