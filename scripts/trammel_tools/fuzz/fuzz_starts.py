# SPDX-License-Identifier: Apache-2.0
"""Starts of the whole program with random command lines, keys, files and run folders."""

import os
import random
import re
import shutil
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools import machines
from trammel_tools.fuzz import fuzz_seeds
from trammel_tools.paths import ROOT

LONGEST = 10  # [s] of a start
CODES = {0, 1, 2, 3, 4, 5, 130}  # docs/manual.md; 70 is an internal error
# Before the line of an error there may be notices and warnings of a run that was begun.
BEGUN = re.compile(r": (waves of|no pictures|and \d+ more such|row \d+: |the path takes )")
RAW = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")
ODD = ["", "-", "--", ".", "..", "../../x", "/nowhere/at/all", "a/b", "\x1b[31m", "a\nb", "\x7f",
       "\udcff", "\xe9", "-1", "1e999", "nan", "99999999999999999999", "true", "x" * 300,
       "k" * 5000, "%s%n", "$(touch x)", "`x`", "'", '"', "\\", "a=b", "=", "[[", "{",
       "\u202e", "\u009b2J"]
NESTED = [(b"\na", b".a", b" = 1\n"), (b"\n[a", b".a", b"]\n"), (b"\na = ", b"[", b""),
          (b"\na = ", b"{a = ", b""), (b"", b'{"a":', b"1"), (b"", b"[", b""), (b"", b"1e9,", b"")]
VERBS = ["run", "run", "run", "report", "report", "own", "own", "own", "list", "doctor"]
OPTIONS = {"run": ["--no-leap", "--audit", "--assert", "--json", "--check", "--all", "--no-report"],
           "report": ["--json"], "list": ["--json"], "doctor": ["--json"]}
VALUED = {"--engine": ["rtl", "twin"], "--platform": ["systemc", "direct"],
          "--wave": ["vcd", "fst"], "--wave-window": ["0:1ms", "-1ms:1ms", "1:0"],
          "--wave-pre": ["0.2ms"], "--wave-every": ["1ms"],
          "--wave-trigger": ["at 1ms", "x.e > 100", "fault", "a > 1", "x.e >"]}


class World:
    """What cases are made of: keys, scenarios, scripts, finished runs."""

    def __init__(self, program, folder):
        self.program = program
        self.runs = folder / "runs"
        self.names = fuzz_seeds.short_runs(program, self.runs)
        self.keys = {name: fuzz_seeds.keys_of(program, name) for name in self.names}
        self.scenarios = machines.scenarios()
        # (machine, its table) of the verbs that machines have.
        self.verbs = [(name, verb | {"files": sorted(folder.glob(verb["seeds"]))})
                      for name, folder in machines.folders().items()
                      for verb in fuzz_seeds.fuzz_of(name).get("verbs", [])]
        self.programs = [text.encode() for text in fuzz_seeds.GCODE]
        self.runs_programs = next(name for name, keys in self.keys.items()
                                  if any(key["key"].endswith(".gcode_file") for key in keys))
        self.texts = [path.read_bytes() for path in ROOT.glob("machines/*/scenarios/*.toml")]


def value(world, dice, machine):
    """key=value, mostly of a key that there is."""
    key = dice.choice(world.keys[machine])
    name = key["key"] if dice.random() < 0.9 else key["key"][:dice.randrange(1, 12)]
    if dice.random() < 0.3:
        name = re.sub(r"\.[xy]\.", ".", name)
    low, _, high = key["range"].partition("..")
    picks = [key["default"].strip('"'), low, high, dice.choice(ODD), f"{dice.uniform(-10, 10):g}"]
    if key["range"].startswith("one of "):
        picks += key["range"].removeprefix("one of ").split(", ") * 3
    try:
        picks += [f"{dice.uniform(float(low), float(high)):.6g}",
                  str(dice.randint(int(float(low)), int(float(high))))] * 2
    except ValueError:
        picks += ["true", "false"]
    return f"{name}={dice.choice(picks)}"


def damaged(dice, content):
    """These bytes with some of them changed, cut, doubled, or with parts nested without end."""
    content = bytearray(content)
    for _ in range(dice.randint(0, 4)):
        at = dice.randrange(len(content) + 1)
        what = dice.randrange(7)
        if what == 0:
            content[at:at + dice.randrange(1, 20)] = b""
        elif what == 1:
            content[at:at] = dice.choice(ODD).encode("utf-8", "surrogateescape")
        elif what == 2 and content:
            content[at % len(content)] = dice.randrange(256)
        elif what == 3:
            content[at:at] = content[:dice.randrange(200)]
        elif what == 4:
            content = content[:at]
        elif what == 5:
            before, part, behind = dice.choice(NESTED)
            at = max(at, content.find(b"\n", at))  # at the end of a line, if there is one
            content[at:at] = before + part * dice.choice([1, 3, 100, 100000]) + behind
        else:
            content[at:at] = re.sub(rb"\d", b"9", bytes(content[at:at + 40]))
    return bytes(content)


def put(dice, path, content):
    """The file, or what should be none: a folder, a pipe, a link."""
    kind = dice.random()
    if kind < 0.9:
        path.write_bytes(content)
    elif kind < 0.92:
        path.mkdir()
    elif kind < 0.95:
        os.mkfifo(path)
    elif kind < 0.98:
        path.symlink_to(dice.choice(["nowhere", "/dev/zero", "/dev/full", "..", path.name]))


def name_of(dice, ending):
    return dice.choice(["a", "a", "b c", "\xe9", "'q'", "\x1bx", "n\nl", "\udcff"]) + ending


def output(dice):
    return dice.choice(["out", "o", "a/b/c", ".", "..", "a", "\xe9", "\x1b", "\udcff", "fifo",
                        "folder", "file", "x" * 300, "", "r", "r/trace.csv", "r/report.html", "-"])


def damage_run(world, dice, machine, folder):
    """A finished run in folder/r, a file of which is mostly another."""
    shutil.copytree(world.runs / machine, folder / "r")
    if dice.random() < 0.7:
        (folder / "r" / "run.json").unlink()
    if dice.random() < 0.9:
        path = dice.choice(sorted((folder / "r").iterdir()))
        content = path.read_bytes()
        path.unlink()
        put(dice, path, damaged(dice, content))


def settings(world, dice, machine, folder):
    """Words that set keys, and the files that they name."""
    words = []
    for _ in range(dice.choice([0, 0, 1, 1, 2, 4])):
        words += ["-s", value(world, dice, machine)]
    if dice.random() < 0.1:
        words += ["-s", "name=" + dice.choice(ODD)]
    if dice.random() < 0.1:
        path = folder / "table.csv"
        put(dice, path, damaged(dice, b"x_mm,y_mm\n100,200\n100.5,200\n101,201\n"))
        words += ["-s", "path.kind=points", "-s", "path.points_file=table.csv"]
    if dice.random() < 0.15:
        path = folder / name_of(dice, ".more")
        put(dice, path, damaged(dice, dice.choice(world.texts)))
        words += ["-c", path.name]
    return words


def argument(dice, names, texts, ending, folder):
    """(word, standard input) of a verb that takes one of these names, a file, or standard input."""
    kind = dice.random()
    text = damaged(dice, dice.choice(texts))
    if kind < 0.45:
        return [dice.choice(names)], None
    if kind < 0.85:
        path = folder / name_of(dice, ending)
        put(dice, path, text)
        return [path.name], None
    return dice.choice([[], ["-"], ["/dev/stdin"]]), text


def case(world, dice, folder):
    """(arguments, standard input) of a start in this folder, whose files are made."""
    machine = dice.choice(world.names)
    verb = dice.choice(VERBS)
    (folder / "folder").mkdir()
    (folder / "file").write_bytes(b"mine")
    os.mkfifo(folder / "fifo")
    if dice.random() < 0.3 or verb == "report":
        damage_run(world, dice, machine, folder)
    given, options, simulates, words = None, OPTIONS.get(verb, []), verb == "run", [verb]
    if verb == "own":
        machine, own = dice.choice(world.verbs)
        files, options, simulates = own["files"], own["options"], own.get("simulates", False)
        words, given = argument(dice, [path.stem for path in files],
                                [path.read_bytes() for path in files], files[0].suffix, folder)
        words.insert(0, own["name"])
    elif verb == "run":
        texts, ending = dice.choice([(world.texts, ".toml")] * 3 + [(world.programs, ".ngc")])
        machine = world.runs_programs if ending == ".ngc" else machine
        names = [scenario for scenario, of in world.scenarios.items() if of == machine]
        words, given = argument(dice, names, texts, ending, folder)
        words.insert(0, verb)
        if ending == ".ngc" and dice.random() < 0.5:
            words += ["--engine", "twin"]
    elif verb == "report":
        words += dice.choice([["r"], ["r"], ["r"], ["r", "r"], [], ["folder"], ["r/"], ["."]])
    elif verb == "list":
        words += dice.choice([[], ["keys"], ["signals", machine], ["columns"], ["machines"]])
    if dice.random() < 0.05:
        words.append(dice.choice(ODD))
    if dice.random() < 0.03:
        words[0] = dice.choice([*ODD, "rnu", "--help", "-h", "--version"])
    if verb in ("run", "own"):
        words += settings(world, dice, machine, folder)
    for _ in range(dice.choice([0, 0, 0, 1, 2])):
        words.append(dice.choice(options))
    if simulates and dice.random() < 0.3:
        option = dice.choice(sorted(VALUED))
        words += [option, dice.choice([*VALUED[option], *VALUED[option], dice.choice(ODD)])]
    if dice.random() < (0.7 if simulates else 0.4):
        words += ["-o", output(dice)]
    if verb in ("run", "own"):
        slow = "--assert" in words or "--audit" in words
        words += ["-s", f"run.max_s={0.001 if slow else dice.choice([0.001, 0.003, 0.01])}"]
    return words, given


def variables(world, dice):
    every = {"PATH": "/nowhere", "HOME": "/nowhere", "LC_ALL": "C"}
    if dice.random() < 0.05:
        name, _, text = value(world, dice, dice.choice(world.names)).partition("=")
        every["TRAMMEL_" + name.upper().replace(".", "_")] = text
    return every


def wrong(code, said, printed, took):
    """What is not as documented about an end of the program; "" if nothing."""
    if took > LONGEST:
        return f"took {took:.1f} s"
    if code not in CODES:
        return f"exit code {code}"
    for stream, text in ("standard error", said), ("standard output", printed):
        if RAW.search(text):
            return f"{stream} has a raw character"
        try:
            text.decode("utf-8")
        except UnicodeDecodeError:
            return f"{stream} is not UTF-8"
    lines = said.decode("utf-8").split("\n")[:-1]
    if not all(line.startswith("trammel: ") for line in lines):
        return "a line of standard error that does not begin with `trammel: `"
    if code == 2 and sum(not BEGUN.search(line) for line in lines[:-1]) > 0:
        return "more than one line"
    if code == 2 and not lines:
        return "no line that says why"
    return ""


def start(world, seed):
    """"" or a report of what is wrong with the start of this seed."""
    dice = random.Random(seed)
    with tempfile.TemporaryDirectory(dir=world.runs.parent) as whole:
        outside = Path(whole)
        folder = outside / "one" / "two"
        folder.mkdir(parents=True)
        words, given = case(world, dice, folder)
        arguments = [os.fsencode(word) for word in words]
        begin = time.monotonic()
        try:
            done = subprocess.run([world.program, *arguments], cwd=folder, input=given or b"",
                                  env=variables(world, dice), capture_output=True, check=False,
                                  timeout=LONGEST + 5)
            why = wrong(done.returncode, done.stderr, done.stdout, time.monotonic() - begin)
            said = done.stderr.decode("utf-8", "backslashreplace")[-2000:]
        except subprocess.TimeoutExpired:
            why, said = f"does not end in {LONGEST + 5} s", ""
        there = [*outside.iterdir(), *folder.parent.iterdir()]
        above = "--all" in words and ".." in words  # folders of all runs, where they are asked for
        if not why and not above and there != [folder.parent, folder]:
            why = "a file outside of its folder"
        asked = any(words[k:k + 2] == ["-o", "file"] for k in range(len(words)))
        if not why and not asked and (folder / "file").read_bytes() != b"mine":
            why = "a file of the user is changed"
    return f"seed {seed}: {why}: trammel {words!a}\n{said}" if why else ""


def run(program, first, count, seconds=None):
    """Starts with the seeds from `first` on; prints findings. Their number."""
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    begin = time.monotonic()
    found = made = 0
    with tempfile.TemporaryDirectory(dir=memory, prefix="trammel-starts-") as scratch, \
            ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        world = World(program, Path(scratch))
        while made < count if seconds is None else time.monotonic() - begin < seconds:
            some = min(100, count - made) if seconds is None else 100
            for report in pool.map(lambda seed: start(world, seed),
                                   range(first + made, first + made + some)):
                if report:
                    found += 1
                    print(f"fuzz: {report}", flush=True)
            made += some
    print(f"fuzz: {made} starts, seeds {first} to {first + made - 1}, in "
          f"{time.monotonic() - begin:.0f} s: {found} findings")
    return found
