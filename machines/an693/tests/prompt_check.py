#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Talk with `trammel lm628` on a terminal: prompt, completion, history, Ctrl-C, end; pipe to it.

usage: prompt_check.py PROGRAM [FOLDER]
"""

import os
import pty
import select
import signal
import subprocess
import sys
import termios
import time
import unittest

LIMIT_S = 15


class Prompt(unittest.TestCase):
    program = None

    def setUp(self):
        self.seen = ""
        child, self.terminal = pty.fork()
        if child == 0:
            os.environ["TERM"] = "xterm"
            os.execl(self.program, self.program, "lm628")
        self.child = child
        self.until("lm628> ")

    def tearDown(self):
        os.close(self.terminal)

    def until(self, text):
        """Reads until that text; what is read before and with it."""
        end = time.monotonic() + LIMIT_S
        while text not in self.seen:
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.terminal], [], [], left)[0]:
                self.fail(f"no {text!r} in {self.seen!r}")
            try:
                self.seen += os.read(self.terminal, 4096).decode(errors="replace")
            except OSError:  # the program ended
                self.fail(f"ended without {text!r} after {self.seen!r}")
        before, _, self.seen = self.seen.partition(text)
        return before + text

    def type(self, keys, at_prompt=True):
        """Keys that are typed before the editor reads them are lines to the terminal."""
        end = time.monotonic() + LIMIT_S
        while at_prompt and termios.tcgetattr(self.terminal)[3] & termios.ICANON:
            self.assertLess(time.monotonic(), end, "no line is read")
            time.sleep(0.001)
        os.write(self.terminal, keys.encode())

    def answer(self, keys, text):
        self.type(keys)
        self.until(text)
        self.until("lm628> ")

    def ended(self):
        """The exit code; what is left to read is read, or the program might wait for us."""
        try:
            while os.read(self.terminal, 4096):
                pass
        except OSError:
            pass
        return os.waitstatus_to_exitcode(os.waitpid(self.child, 0)[1])

    def test_mnemonics_are_completed(self):
        self.answer("RDST\t\r", "RDSTAT  84h  motor off, trajectory complete")
        self.answer("wait co\t1 ms\r", "wait complete 1 ms: after ")
        self.answer("hel\tltr\t\r", "control word: bit 5 acceleration")
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)

    def test_lines_can_be_edited_and_come_back(self):
        self.answer("RDRX\bP\r", "00000000h  0 counts")
        self.answer("\x1b[A\r", "00000000h  0 counts")  # the arrow up
        self.type("\x04")  # Ctrl-D
        self.assertEqual(self.ended(), 0)

    def test_a_block_is_asked_for_up_to_its_end(self):
        self.type("repe\t 2\r")
        self.until("  ...> ")
        self.type("RDRP\r")
        self.until("  ...> ")
        self.type("end\r")
        self.until("00000000h  0 counts")
        self.until("00000000h  0 counts")
        self.until("lm628> ")
        self.type("repeat 2\r")
        self.until("  ...> ")
        self.answer("\x03", "\n")  # Ctrl-C drops it
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)

    def test_ctrl_c_ends_a_wait_and_no_more(self):
        self.type("wait hi 3000 s\r")
        self.until("\n")  # it is executed
        self.type("\x03", at_prompt=False)
        self.until("interrupted at ")
        self.until("lm628> ")
        self.type("RDR")
        self.until("RDR")
        self.answer("\x03", "\n")
        self.answer("RDRP\r", "00000000h  0 counts")
        self.answer("nonsense\r", "nonsense: unknown command")
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)

    def test_a_line_outlives_stops_resizes_and_other_letters(self):
        self.type("RD\u00b5R")
        self.until("RDR")
        for _ in range(3):
            os.kill(self.child, signal.SIGWINCH)
            os.kill(self.child, signal.SIGCONT)  # as after a stop
        self.answer("P\r", "00000000h  0 counts")
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)

    def test_a_pipe_is_a_script(self):
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)
        for arguments in ([], ["-"]):
            done = subprocess.run([self.program, "lm628", *arguments], input="rdrp\n", text=True,
                                  capture_output=True, check=False, timeout=LIMIT_S)
            self.assertEqual((done.returncode, done.stdout, done.stderr),
                             (0, "RDRP    00000000h  0 counts\n", ""))

    def test_a_note_and_why_a_script_ended_are_told_beside_its_answers(self):
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)
        done = subprocess.run([self.program, "lm628"], input="stt\nrdrp\nwait index 1 ms\nrdrp\n",
                              text=True, capture_output=True, check=False, timeout=LIMIT_S)
        self.assertEqual((done.returncode, done.stdout), (5, "RDRP    00000000h  0 counts\n"))
        notes = done.stderr.splitlines()
        self.assertEqual(len(notes), 2, notes)
        self.assertEqual(notes[0], "trammel: standard input:1: STT: the motor gets nothing before "
                                   "PORT12")
        self.assertIn("standard input:3: wait index 1 ms: not within 0.001 s; status ", notes[1])

    def test_an_answer_of_a_script_comes_when_it_is_given_not_when_the_script_ends(self):
        self.type("quit\r")
        self.assertEqual(self.ended(), 0)
        with subprocess.Popen([self.program, "lm628", "-", "-s", "run.max_s=3600"],
                              stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              bufsize=0) as script:
            try:
                script.stdin.write(b"rdrp\nwait 3000 s\n")
                script.stdin.close()
                said = b""
                if select.select([script.stdout], [], [], LIMIT_S)[0]:
                    said = os.read(script.stdout.fileno(), 4096)
                self.assertEqual(said, b"RDRP    00000000h  0 counts\n")
                self.assertIsNone(script.poll())
            finally:
                script.kill()


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if "--help" in sys.argv or "-h" in sys.argv else 2
    Prompt.program = sys.argv[1]
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Prompt)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
