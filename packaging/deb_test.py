#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Debian package holds a program that runs where it is unpacked: deb_test.py BUILD.

It depends on the libraries that it is linked with, has its scenarios beside it, and simulates the
circle in under 10 s of processor time as the program of the build does. Skipped where dpkg-dev is
missing.
"""

import json
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

MOST_S = 10


def run(*command, **more):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False,
                          **more)


def event_hash(program, folder):
    done = run(program, "run", "circle", "--no-report", "-o", folder, cwd=folder.parent)
    if done.returncode != 0:
        raise SystemExit(f"deb: {program}: {done.stderr}")
    return json.loads((folder / "metrics.json").read_text())["run"]["event_hash"]


def main():
    if not shutil.which("dpkg-shlibdeps"):
        print("deb: dpkg-shlibdeps is missing", file=sys.stderr)
        return 77
    build = Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        made = run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder)
        package = next(folder.glob("trammel_*_*.deb"), None)
        if made.returncode != 0 or package is None:
            print(made.stdout[-2000:], made.stderr[-2000:], file=sys.stderr)
            return 1
        needs = run("dpkg-deb", "-f", package, "Depends").stdout
        listed = run("dpkg-deb", "-c", package).stdout
        if "libsystemc" not in needs or "scenarios/circle.toml" not in listed \
                or "/tests/" in listed:
            print(f"deb: depends on {needs} and holds\n{listed}", file=sys.stderr)
            return 1
        machines = Path(__file__).resolve().parents[1] / "machines"
        lacks = [str(file.relative_to(machines)) for folder_of in ("scenarios", "pictures")
                 for file in machines.glob(f"*/{folder_of}/*")
                 if f"/{file.relative_to(machines)}\n" not in listed]
        if lacks:
            print(f"deb: lacks {', '.join(lacks)}", file=sys.stderr)
            return 1
        run("dpkg-deb", "-x", package, folder / "tree").check_returncode()
        program = folder / "tree" / "usr" / "bin" / "trammel"
        said = run(program, "doctor").stdout
        if f"{folder}/tree/usr/share/trammel" not in said:
            print(f"deb: its scenarios are not its own: {said[-300:]}", file=sys.stderr)
            return 1
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        own = event_hash(program, folder / "own")
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        right = own == event_hash(build / "testbench" / "trammel", folder / "other")
        print(f"deb: {package.name}, {package.stat().st_size >> 10} KiB, circle in {took:.1f} s")
        return 0 if right and took < MOST_S else 1


if __name__ == "__main__":
    sys.exit(main())
