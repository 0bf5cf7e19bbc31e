# SPDX-License-Identifier: Apache-2.0
"""A run by the package takes at most 1.05 times what the program takes: time_test.py PROGRAM.

Both do the circle without a page, in turn; processor time of the program as a whole, with its
trace but without the pictures of gnuplot, against that of run() with all columns. What else the
computer does only adds time, so the least of each side counts; where it does much, more pairs are
taken before the verdict.
"""

import os
import subprocess
import sys
import tempfile
import time

import trammel

PAIRS = 9
MOST_PAIRS = 36
MOST = 1.05


def program_s(program, engine, folder):
    """Of the program itself: a PATH without gnuplot makes no pictures."""
    child = subprocess.Popen([program, "run", "circle", "--engine", engine, "--no-report",
                              "-o", f"{folder}/run"], stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, env={**os.environ, "PATH": "/nowhere"})
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"time: the program ended with {child.returncode}")
    return used.ru_utime + used.ru_stime


def package_s(engine):
    begun = time.process_time()
    result = trammel.run("circle", engine=engine)
    for name in result:
        result[name].sum()
    return time.process_time() - begun


def compare(program, engine, folder):
    """Ratio of the least times, with the number of pairs that it took."""
    package_s(engine)
    program_s(program, engine, folder)
    ours, theirs = [], []
    while True:
        ours.append(package_s(engine))
        theirs.append(program_s(program, engine, folder))
        ratio = min(ours) / min(theirs)
        if len(ours) >= MOST_PAIRS or (len(ours) >= PAIRS and ratio <= MOST):
            return ratio, len(ours)


def main():
    slow = False
    with tempfile.TemporaryDirectory() as folder:
        for engine in ("rtl", "twin"):
            ratio, pairs = compare(sys.argv[1], engine, folder)
            print(f"{engine}: {ratio:.3f} of the program's time ({pairs} pairs)")
            slow = slow or ratio > MOST
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
