# SPDX-License-Identifier: Apache-2.0
"""Seeds and dictionary of the fuzzers: from scenarios, scripts, keys and runs."""

import json
import subprocess

from trammel_tools import machines
from trammel_tools.paths import ROOT

FILES = ("metrics.json", "detail.json", "trace.csv", "run.json")  # as tests/fuzz/inputs.cpp
WORDS = ["true", "false", "nan", "inf", "-inf", "1e308", "-9223372036854775808", "0x7fffffff",
         "9223372036854775808", '"""', "'''", "[[", "]]", "\\u001b", "\\U0010ffff", "\x1b[2J",
         "\xff", "\xef\xbb\xbf", "../", "/dev/zero", "\r\n", "1979-05-27T07:32:00Z", "# "]

GCODE = ["%\nN10 G21 G90 G64\nG1 F6000 X200 Y.5 (a)\nG2 X210 Y10.5 I10 J0\nM30\n%\n",
         "g20g91\r\ng1f100x-1.5\r\ng3x.1r.1\r\ng3x-.1r-.1\r\n/g0\r\nm2\r\n",
         "G61 G3 I5 F90000\nG4 P0.5\nG28 X0 Y600\nZ5 S1 T2 M3 ; b\nG0 X+.1 Y-0",
         "G0 X10 F600\nG2 X29.99 Y250.01 I10\nG3 X10 Y250 I-9.995 J-.005\nG2 X10.0001 I5"]


class SeedError(Exception):
    """A run that seeds are made of ends otherwise than it should."""


def fuzz_of(machine):
    """The table [fuzz] of a machine's tests/runs.toml."""
    return machines.runs(machine).get("fuzz", {})


def targets():
    """{name: its table} of the inputs that machines have, with the `files` that are seeds."""
    found = {}
    for machine, folder in machines.folders().items():
        for table in fuzz_of(machine).get("targets", []):
            found[table["name"]] = table | {"files": sorted(folder.glob(table["seeds"]))}
    return found


def short_runs(program, folder):
    """Makes folder/<machine>, a run of each; their names in the program's order."""
    names = [entry["name"] for entry in machines.described(program)]
    for name in names:
        first = [next(s for s, machine in machines.scenarios().items() if machine == name)]
        done = subprocess.run(
            [program, "run", *fuzz_of(name).get("run", first), "-s", "run.max_s=0.02", "-s",
             "run.platform=direct", "-o", folder / name, "--no-report"],
            capture_output=True, text=True, errors="replace", check=False)
        if done.returncode not in (0, 5):
            raise SeedError(f"a run of {name} ends with {done.returncode}: {done.stderr.strip()}")
    return names


def keys_of(program, machine):
    done = subprocess.run([program, "list", "keys", machine, "--json"], capture_output=True,
                          check=True)
    return json.loads(done.stdout)


def assignments(program, machine):
    """key=value of each key's default, as -s takes it."""
    return [f"{one['key']}={one['default'].strip(chr(34))}" for one in keys_of(program, machine)]


def put(folder, number, content):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{number:04}").write_bytes(content)


def write_seeds(program, runs, folder):
    """folder/<target>/NNNN, the seeds of each target."""
    names = [entry["name"] for entry in machines.described(program)]
    number = 0
    for index, name in enumerate(names):
        lines = assignments(program, name)
        for begin in range(0, len(lines), 6):
            number += 1
            put(folder / "keys", number,
                bytes([index]) + "\n".join(lines[begin:begin + 6]).encode())
        variable = "$TRAMMEL_" + lines[-1].split("=")[0].upper().replace(".", "_")
        put(folder / "keys", number + 1000,
            bytes([index]) + f"{variable}={lines[-1].split('=')[1]}".encode())
        for place, file in enumerate(FILES):
            path = runs / name / file
            if path.exists():
                lines = path.read_bytes()
                short = b"\n".join(lines.split(b"\n")[:60]) if file == "trace.csv" else lines
                put(folder / "folder", 10 * index + place, bytes([index + 16 * place]) + short)
        put(folder / "scenario", index, (runs / name / "run.toml").read_bytes())
    seeds = {"scenario": sorted(ROOT.glob("machines/*/scenarios/*.toml"))}
    seeds["gcode"] = sorted(ROOT.glob("machines/*/scenarios/*.ngc"))
    seeds |= {target: table["files"] for target, table in targets().items()}
    for target, paths in seeds.items():
        for number, path in enumerate(paths):
            put(folder / target, 100 + number, path.read_bytes())
    for number, text in enumerate(["x_mm,y_mm\n1,2\n3.5,4e1\n", "# points\r\n1, 2\r\n\r\n",
                                   "\xef\xbb\xbf1,2\n-1,+2\n", "1,nan\n"]):
        put(folder / "points", number, text.encode("latin-1"))
    for number, text in enumerate(GCODE):
        put(folder / "gcode", number, text.encode("latin-1"))


def write_dictionary(program, file):
    """Keys, choices, commands and members, as libFuzzer reads them."""
    words = set(WORDS)
    for entry in machines.described(program):
        for one in keys_of(program, entry["name"]):
            words |= {one["key"], *one["key"].split("."), one["default"].strip('"')}
            if one["range"].startswith("one of "):
                words |= set(one["range"].removeprefix("one of ").split(", "))
    for path in (path for table in targets().values() for path in table["files"]):
        words |= {word for line in path.read_text(encoding="utf-8").split("\n")
                  for word in line.split("#")[0].split()}
    plain = sorted(word.encode("latin-1") for word in words if word)
    escaped = ("".join(chr(byte) if 0x20 <= byte < 0x7f and chr(byte) not in '"\\' else
                       f"\\x{byte:02x}" for byte in word) for word in plain)
    file.write_text("".join(f'"{word}"\n' for word in escaped), encoding="ascii")
    file.with_suffix(".words").write_bytes(b"\0".join(plain))  # as tests/fuzz/replay.cpp
