# SPDX-License-Identifier: Apache-2.0
"""`pip install .` into a fresh environment, then a run there: wheel_test.py PROGRAM.

The installed package simulates outside of the repository, with both engines, what the program does,
and has its first figure within 5 s of the interpreter's start. The time of the installation is the
processor time that it takes, divided by two processors: this computer may do something else, too.
Where ccache has what the build of this folder compiled, it is that of all else; without it, the
whole takes 190 to 390 s of two processors, by the computer. Skipped where pip gets no packages.
"""

import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INSTALLED_S = 300
FIRST_S = 5
SCRIPT = """
import json, sys, trammel
first = trammel.run("circle")
assert not trammel.__file__.startswith(sys.argv[1]), trammel.__file__
twin = trammel.run("circle", engine="twin")
first.report("page.html")
print(json.dumps([first.event_hash, twin.event_hash, len(trammel.scenarios())]))
"""


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(*command, **more):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False,
                          **more)


def main():
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    if shutil.which("ccache"):  # as the build of this folder does, under the compilers' same names
        environment |= {f"CMAKE_{n}_COMPILER_LAUNCHER": "ccache" for n in ("C", "CXX")}
        environment |= {"CC": "cc", "CXX": "c++"}
        environment |= {"CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1",
                        "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
    with tempfile.TemporaryDirectory() as scratch:
        python = Path(scratch) / "venv" / "bin" / "python3"
        run(sys.executable, "-m", "venv", Path(scratch) / "venv").check_returncode()
        if run(python, "-m", "pip", "download", "-q", "--no-deps", "-d", scratch,
               "nanobind").returncode != 0:
            print("wheel: pip gets no packages here", file=sys.stderr)
            return 77
        begun, used = time.monotonic(), processor_s()
        build = ROOT / "build-wheel"  # as deep as build/: paths in compile lines are relative
        shutil.rmtree(build, ignore_errors=True)
        made = run(python, "-m", "pip", "install", "-q", "-C", f"build-dir={build}", ROOT,
                   env=environment)
        shutil.rmtree(build, ignore_errors=True)
        took, used = time.monotonic() - begun, (processor_s() - used) / 2
        if made.returncode != 0:
            print(made.stdout[-3000:], made.stderr[-3000:], file=sys.stderr)
            return 1
        first = processor_s()
        run(python, "-c", "import trammel; trammel.run('circle').figures", env=environment,
            cwd=scratch).check_returncode()
        first = processor_s() - first
        done = run(python, "-c", SCRIPT, ROOT, env=environment, cwd=scratch)
        print(f"wheel: installed in {took:.0f} s, {used:.0f} s of two processors; first figure "
              f"after {first:.1f} s of one")
        if done.returncode != 0:
            print(done.stderr, file=sys.stderr)
            return 1
        rtl, twin, count = json.loads(done.stdout)
        run(sys.argv[1], "run", "circle", "--no-report", "-o", f"{scratch}/run").check_returncode()
        metrics = json.loads(Path(scratch, "run", "metrics.json").read_text())
        right = rtl == twin == metrics["run"]["event_hash"] and count > 0
        return 0 if right and used < INSTALLED_S and first < FIRST_S else 1


if __name__ == "__main__":
    sys.exit(main())
