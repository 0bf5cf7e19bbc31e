# SPDX-License-Identifier: Apache-2.0
"""A script that is interrupted on its way."""

import signal
import subprocess
import sys
import time


def interrupt(script, limit_s):
    """What a script prints, whose first line says that it has begun, and its exit code: Ctrl-C
    comes 0.3 s after that line. limit_s is how long it may take then."""
    child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    begun = child.stdout.readline()
    time.sleep(0.3)
    child.send_signal(signal.SIGINT)
    said, _ = child.communicate(timeout=limit_s)
    return begun + said, child.returncode
