# SPDX-License-Identifier: Apache-2.0
"""Runs against small disks, kills, little memory, closed and full streams, and each other."""

import os
import random
import resource
import signal
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools import machines

CODES = {0, 2, 5}


class World:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.runs = []
        for name in machines.folders():
            for one in machines.runs(name).get("files", []):
                self.runs.append(["run", one["scenario"], *one["arguments"]])
        self.runs += [[*run[:2], "--platform", "systemc", "--engine", "rtl", "-s",
                       "run.max_s=0.02"] for run in self.runs]
        # What writes waves, a library of Verilator, does not ask whether it was given memory.
        self.plain = list(self.runs)
        self.runs += [[*run, "--wave", "fst", "--wave-window", "0:5ms"]
                      for run in self.plain[len(self.plain) // 2:]]
        self.environment = os.environ | {"PATH": "/nowhere"}
        begin = time.monotonic()
        subprocess.run([program, *self.runs[0], "-o", folder / "timed"], capture_output=True,
                       env=self.environment, check=True)
        self.took = time.monotonic() - begin
        self.disks = self.mounts()
        self.least = {kind: self.least_memory(kind)
                      for kind in (resource.RLIMIT_AS, resource.RLIMIT_DATA)}

    def least_memory(self, kind):
        """Bytes with which the system can begin the program; with fewer its libraries fail."""
        low, high = 0, 1 << 30
        while high - low > 1 << 16:
            middle = (low + high) // 2
            done = subprocess.run([self.program, "--version"], capture_output=True, check=False,
                                  preexec_fn=limit(kind, middle))
            low, high = (low, middle) if done.returncode == 0 else (middle, high)
        return high

    def mounts(self):
        """Whether this user may make a small disk."""
        place = self.folder / "disk"
        place.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", place],
                          capture_output=True, check=False).returncode != 0:
            return False
        subprocess.run(["umount", place], check=True)
        return True

    def begin(self, run, folder, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen([self.program, *run, "-o", "out"], cwd=folder,
                                env=self.environment, **options)

    def reports(self, folder):
        """What `trammel report` says of the run that is there; "" if it is whole."""
        done = subprocess.run([self.program, "report", "out", "-o", folder.parent / "page.html"],
                              cwd=folder, capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stderr


def ended(process):
    """(code, standard error) of an end."""
    try:
        _, said = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        return None, "does not end in 60 s"
    return process.returncode, (said or b"").decode("utf-8", "backslashreplace")


def documented(code, said):
    lines = [line for line in said.split("\n") if line and ": waves of " not in line
             and "no pictures" not in line and "record kept in" not in line]
    if code not in CODES:
        return f"exit code {code}: {said}"
    if code == 2 and len(lines) != 1:
        return f"not one line: {said}"
    return ""


def limit(kind, size):
    return lambda: resource.setrlimit(kind, (size, size))


def full_disk(world, dice, folder, run):
    """A limit of the size of a file, or a disk of that size."""
    size = int(2 ** dice.uniform(0, 22))
    if not world.disks or dice.random() < 0.3:
        return documented(*ended(world.begin(run, folder,
                                             preexec_fn=limit(resource.RLIMIT_FSIZE, size))))
    return documented(*ended(world.begin(run, folder)))


def little_memory(world, dice, folder, run):
    kind = dice.choice(sorted(world.least))
    size = world.least[kind] + int(2 ** dice.uniform(18, 28))
    return documented(*ended(world.begin(run, folder, preexec_fn=limit(kind, size))))


def killed(world, dice, folder, run):
    process = world.begin(run, folder)
    time.sleep(dice.uniform(0, 1.2 * world.took))
    process.send_signal(signal.SIGKILL)
    ended(process)
    return ""


def interrupted(world, dice, folder, run):
    process = world.begin(run, folder)
    time.sleep(dice.uniform(0.05, 1.2 * world.took))
    process.send_signal(dice.choice([signal.SIGINT, signal.SIGTERM]))
    code, said = ended(process)
    # Before it is ready for them, a signal ends the program as any other.
    return "" if code in (130, -signal.SIGINT, -signal.SIGTERM) else documented(code, said)


def together(world, dice, folder, run):
    several = [world.begin(dice.choice(world.runs), folder) for _ in range(dice.randint(1, 2))]
    several.append(world.begin(run, folder))
    return next(filter(None, [documented(*ended(one)) for one in several]), "")


def bad_stream(world, dice, folder, run):
    which = dice.choice(["stdout", "stderr"])
    kind = dice.randrange(3)
    if kind == 0:
        with open("/dev/full", "w", encoding="utf-8") as full:
            return documented(*ended(world.begin(run, folder, **{which: full})))
    if kind == 1:
        ours, theirs = os.pipe()
        os.close(ours)
        process = world.begin(run, folder, **{which: theirs})
        os.close(theirs)
        return documented(*ended(process))
    descriptor = 1 if which == "stdout" else 2
    return documented(*ended(world.begin(run, folder, **{which: None},
                                         preexec_fn=lambda: os.close(descriptor))))


HARM = [full_disk, full_disk, full_disk, little_memory, little_memory, killed, killed, interrupted,
        together, bad_stream]


def one(world, seed):
    """"" or a report of what is wrong with this case."""
    dice = random.Random(seed)
    harm = dice.choice(HARM)
    run = dice.choice(world.plain if harm is little_memory else world.runs)
    with tempfile.TemporaryDirectory(dir=world.folder) as whole:
        folder = Path(whole) / "work"
        folder.mkdir()
        disk = harm is full_disk and world.disks
        if disk:
            size = int(2 ** dice.uniform(3, 11))  # KiB
            subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", folder],
                           check=True)
        try:
            before = dice.random() < 0.5 and not disk
            if before:
                code, said = ended(world.begin(dice.choice(world.runs), folder))
                if code not in (0, 5):
                    return f"seed {seed}: a run that nothing harms ends with {code}: {said}"
                (folder / "out" / "mine.txt").write_text("mine")
            why = harm(world, dice, folder, run)
            there = (folder / "out").exists()
            if not why and before and not there:
                why = "the run that was there is gone"
            if not why and there:
                why = world.reports(folder)
            if not why and not disk:
                code, said = ended(world.begin(run, folder))
                left = sorted(path.name for path in folder.iterdir())
                if code not in (0, 5):
                    why = f"the next run ends with {code}: {said}"
                elif left != ["out"]:
                    why = f"the next run leaves {left}"
                elif before and not (folder / "out" / "mine.txt").exists():
                    why = "a file of the user is lost"
        finally:
            if disk:
                subprocess.run(["umount", folder], check=True)
    return f"seed {seed}, {harm.__name__}: {why}: trammel {' '.join(run)}" if why else ""


def run_all(program, first, count, seconds=None):
    """Cases with the seeds from `first` on; prints findings. Their number."""
    begin = time.monotonic()
    found = made = 0
    with tempfile.TemporaryDirectory(prefix="trammel-disks-") as scratch, \
            ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        world = World(program, Path(scratch))
        while made < count if seconds is None else time.monotonic() - begin < seconds:
            some = min(20, count - made) if seconds is None else 20
            for report in pool.map(lambda seed: one(world, seed),
                                   range(first + made, first + made + some)):
                if report:
                    found += 1
                    print(f"fuzz: {report}", flush=True)
            made += some
        disks = "disks of their own" if world.disks else "limits of file sizes (not root: no disks)"
    print(f"fuzz: {made} runs against {disks}, kills, streams and little memory, seeds {first} to "
          f"{first + made - 1}, in {time.monotonic() - begin:.0f} s: {found} findings")
    return found
