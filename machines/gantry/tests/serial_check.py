#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A program with pyserial at the simulated track, by both verbs that give it a port: it reads the
configuration, sends bytes that mean nothing, moves the cart, and sees it arrive in the time of the
wall, which the stream's ticks are never ahead of.

usage: serial_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the run
"""

import os
import select
import signal
import subprocess
import sys
import termios
import time
import tty
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts"))
from trammel_tools import python_tools

OFFSET = 1 << 24  # of a position
TICKS = 4612  # a second


def frame(channel: int, value: int) -> bytes:
    """A value as Serial2002 has it."""
    out = [(value & 3) << 5 | channel]
    value >>= 2
    while True:
        out.insert(0, 0x80 | value & 0x7F)
        value >>= 7
        if value == 0:
            return bytes(out)


class Track(unittest.TestCase):
    program, folder = "", Path()

    def start(self, *words):
        self.run = subprocess.Popen([self.program, *words, "-o", str(self.folder)],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        words = ""
        while "serial port is" not in words:
            words = self.run.stderr.readline()
            self.assertTrue(words, "the run ended without a port")
        import serial
        self.port = serial.Serial(words.split()[-1], 115200, timeout=10)
        self.addCleanup(self.stop)

    def stop(self):
        self.port.close()
        self.run.send_signal(signal.SIGINT)
        code = self.run.wait(20)
        self.run.stderr.close()
        self.assertEqual(code, 130)

    def value(self) -> tuple[int, int]:
        """Channel and value of the next frame."""
        value = 0
        while True:
            byte = self.port.read(1)
            self.assertEqual(len(byte), 1, "no answer within 10 s")
            if byte[0] & 0x80 == 0:
                return byte[0] & 31, value << 2 | byte[0] >> 5
            value = value << 7 | byte[0] & 0x7F

    def position(self) -> int:
        self.port.write(b"\x60")
        channel, value = self.value()
        self.assertEqual(channel, 0)
        return value - OFFSET

    def test_the_verb_serial(self):
        self.start("serial", "gantry-p", "-s", "run.engine=twin")
        self.move()

    def test_what_no_program_reads_is_not_the_next_ones(self):
        self.start("serial", "gantry-p", "-s", "run.engine=twin")
        for leaves in (True, True, False):
            port = os.open(self.port.name, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(port, termios.TCSANOW)  # nothing is discarded, unlike with pyserial
            self.port.close()
            os.write(port, b"\x7f" if leaves else b"\x60")
            if leaves:
                time.sleep(0.2)  # its answer is there
            else:
                self.assertTrue(select.select([port], [], [], 10)[0])
                first = os.read(port, 1)[0]  # of a position: 2^24 in five bytes
                self.assertEqual(first, 0x82)
            os.close(port)
            time.sleep(0.2)

    def test_the_option_of_run_with_the_rtl_and_on_systemc(self):
        self.start("run", "gantry-p", "--serial")
        self.move()

    def test_the_ticks_of_the_stream_are_those_of_the_wall(self):
        self.start("run", "gantry-cascade", "--serial", "--engine", "twin", "-s",
                   "host.stream=true")
        # What waits in the port's buffers was made before: it is read first.
        opened, began, first, last = time.monotonic(), 0.0, 0, 0
        while last - first < 2 * TICKS:
            channel, value = self.value()
            if channel != 30 or time.monotonic() - opened < 1.5:
                continue
            last = value
            if first == 0:
                began, first = time.monotonic(), value
        self.assertGreater(time.monotonic() - began, 1.2)
        self.assertLess(time.monotonic() - began, 40)  # on a computer that is busy

    def test_a_machine_without_such_a_port_is_refused(self):
        done = subprocess.run([self.program, "run", "circle", "--serial", "-o", self.folder],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, "--serial: the machine [a-z]+ has no port")
        self.assertIn("permitted: scenarios of gantry", done.stderr)

    def move(self):
        self.port.write(b"\x7f")
        words = []
        while len(words) < 23:  # nothing that the chip sent before the port was open
            channel, value = self.value()
            self.assertEqual(channel, 31)
            words.append((channel, value))
        self.assertEqual(words[-1][1], 0)
        self.assertEqual(words[2][1], 25 << 10 | 5 << 5)
        self.port.write(b"\xff" * 9 + b"\x00" + frame(17, 3))  # overlong, and a channel for nobody
        self.port.write(b"\x81")  # alone: the gap ends it
        time.sleep(0.1)
        self.assertEqual(self.position(), 0)
        began = time.monotonic()
        self.port.write(frame(21, 100))
        while self.position() < 99:
            self.assertLess(time.monotonic() - began, 20, "the cart did not arrive")
            time.sleep(0.02)
        # The cart's 0.4 s are those of the wall; a computer that is busy makes them more.
        self.assertGreater(time.monotonic() - began, 0.25)
        self.assertLessEqual(self.position(), 101)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    python_tools.need("serial", "gantry_serial")
    Track.program, Track.folder = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
