#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A program with pyserial at the simulated track: it reads the configuration, sends bytes
that mean nothing, moves the cart, and sees it arrive in the time of the wall.

usage: serial_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the run
"""

import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "scripts"))
from trammel_tools import python_tools

OFFSET = 1 << 24  # of a position


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

    def setUp(self):
        self.run = subprocess.Popen(
            [self.program, "serial", "gantry-p", "-s", "run.engine=twin", "-o", str(self.folder)],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        words = ""
        while "serial port is" not in words:
            words = self.run.stderr.readline()
            self.assertTrue(words, "the run ended without a port")
        import serial
        self.port = serial.Serial(words.split()[-1], 115200, timeout=2)

    def tearDown(self):
        self.port.close()
        self.run.send_signal(signal.SIGINT)
        self.code = self.run.wait(20)
        self.run.stderr.close()
        self.assertEqual(self.code, 130)

    def value(self) -> tuple[int, int]:
        """Channel and value of the next frame."""
        value = 0
        while True:
            byte = self.port.read(1)
            self.assertEqual(len(byte), 1, "no answer within 2 s")
            if byte[0] & 0x80 == 0:
                return byte[0] & 31, value << 2 | byte[0] >> 5
            value = value << 7 | byte[0] & 0x7F

    def position(self) -> int:
        self.port.write(b"\x60")
        channel, value = self.value()
        self.assertEqual(channel, 0)
        return value - OFFSET

    def test_a_program_moves_the_cart(self):
        self.port.write(b"\x7f")
        words = [self.value() for _ in range(23)]
        if words[0] == (9, 42):  # the reset message, where opening the port did not drop it
            words = [*words[1:], self.value()]
        self.assertEqual({channel for channel, _ in words}, {31})
        self.assertEqual(words[-1][1], 0)
        self.assertEqual(words[2][1], 25 << 10 | 5 << 5)
        self.port.write(b"\xff" * 9 + b"\x00" + frame(17, 3))  # overlong, and a channel for nobody
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
