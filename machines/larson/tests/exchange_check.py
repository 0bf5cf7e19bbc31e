#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""X and Y of Larson's table are alike: a script with exchanged arguments moves the axes the other
way round. The processor serves X before Y, so times differ by some microseconds.

usage: exchange_check.py PROGRAM FOLDER     PROGRAM: trammel; FOLDER: for the runs, made anew
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "tests" / "support"))
import checks
import exchange

SCRIPTS = {
    "moves": ["CALTBL", "VELTBL 3000 300", "ABSTBL 300 500", "WTTBL", "WHRTBL", "VELTBL 1500 2500",
              "RELTBL -120 40", "WTTBL", "ABSTBL 700 20", "WTTBL", "WAIT 200"],
    "lost": ["CALTBL", "VELTBL 4000 400", "ABSTBL 2000 500", "WTTBL", "WHRTBL", "WAIT 300"],
    "clipped": ["CALTBL", "VELTBL 3000 3000", "ABSTBL 20000 300", "WTTBL", "RELTBL -300 -9000",
                "WTTBL", "WAIT 200"],
}
KEYS = {"axis.start_x_step": 70, "axis.start_y_step": 30}


def turned(line):
    """The call with its two arguments exchanged."""
    return re.sub(r"^(\w+) (-?\d+) (-?\d+)$", r"\1 \3 \2", line)


class Exchange(exchange.Pairs):
    def test_records_are_exchanged(self):
        for name, lines in SCRIPTS.items():
            with self.subTest(script=name):
                self.check(name, lines)

    def check(self, name, lines):
        codes, words, metrics = [], [], []
        for side, calls, keys in (("xy", lines, KEYS), ("yx", map(turned, lines), {
                exchange.exchanged(key): value for key, value in KEYS.items()})):
            script = self.folder / f"{name}.table"
            script.write_text("\n".join(calls) + "\n")
            code, said = exchange.run(self.program, "larson-step", {
                "script": script, "name": name, "record.every_ms": 1, **keys}, self.folder / side)
            codes.append(code)
            words.append(said)
            metrics.append(exchange.records(self.folder / side)[1])
        self.assertEqual(*codes)
        self.assertEqual(words[0], exchange.exchanged(words[1]))
        one, other = metrics
        self.assertEqual([call["call"] for call in one["calls"]],
                         [turned(call["call"]) for call in other["calls"]])
        numbers = [[[float(n) for n in re.findall(r"-?\d+", call["answer"])]
                    for call in run["calls"]] for run in metrics]
        self.assertEqual(numbers[0], [answer[::-1] for answer in numbers[1]])
        order = [sorted((event["what"], axis) for event in run["events"] for axis in
                        [event["axis"] if run is one else exchange.exchanged(event["axis"])])
                 for run in metrics]
        self.assertEqual(*order)
        for run in metrics:
            for key in ("options", "run", "versions", "command", "calls", "events"):
                run.pop(key)
        self.assertEqual(list(exchange.differences(one, other, part=2e-3, least=5e-3)), [])


if __name__ == "__main__":
    sys.exit(checks.main(Exchange, __doc__))
