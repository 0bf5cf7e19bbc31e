# SPDX-License-Identifier: Apache-2.0
"""Runs of a machine with two axes, and the same with the axes exchanged: keys, path and faults of X
become those of Y. What is then recorded and told must be the same with X and Y exchanged."""

import csv
import json
import math
import random
import re
import shutil
import subprocess
import unittest
from pathlib import Path

OTHER = {"x": "y", "y": "x", "X": "Y", "Y": "X"}
RANGE = re.compile(r"(\S+) +(\S+) +(-?[\d.e+-]+)\.\.(-?[\d.e+-]+) ")


def exchanged(text):
    """X and Y exchanged where they are words, or parts of a name: x_mm, gains.x.kp."""
    return re.sub(r"(?<![A-Za-z0-9])[xyXY](?![A-Za-z0-9])", lambda m: OTHER[m[0]], text)


def keys_of(program, machine):
    """Keys that each axis has: {key: (default, least, most)}; numbers only."""
    listed = subprocess.run([program, "list", "keys", machine], capture_output=True, text=True,
                            check=True).stdout
    found = {m[1]: (m[2], float(m[3]), float(m[4])) for m in map(RANGE.match, listed.split("\n"))
             if m}
    return {key: found[key] for key in found if key != exchanged(key) and exchanged(key) in found}


def varied(keys, seed):
    """Values that differ from the defaults by up to a tenth."""
    chance, values = random.Random(seed), {}
    for key, (default, least, most) in keys.items():
        if "." in default:
            value = float(default) * chance.uniform(0.9, 1.1)
            values[key] = f"{min(max(value, least), most):.6g}"
    return values


def run(program, scenario, settings, folder):
    """Exit code and, without the folder's name, the outcome and what is said on stderr; what the
    folder held before is gone."""
    shutil.rmtree(folder, ignore_errors=True)
    words = [word for key, value in settings.items() for word in ("-s", f"{key}={value}")]
    done = subprocess.run([program, "run", scenario, "--engine", "twin", *words, "-o", folder],
                          capture_output=True, text=True, check=False)
    said = done.stdout.split("\n")[0] + "\n" + done.stderr
    return done.returncode, re.sub(rf"\S*/{Path(folder).name}(?![\w.])", "FOLDER", said)


def records(folder):
    with open(Path(folder, "trace.csv"), newline="", encoding="utf-8") as file:
        trace = list(csv.DictReader(file))
    return trace, json.loads(Path(folder, "metrics.json").read_text(encoding="utf-8"))


def differences(one, other, part=0, least=0, place=""):
    """Places of two values of JSON that are not alike, where the second one has exchanged axes;
    numbers may differ by a part of them, and by `least`."""
    more = (part, least)
    if isinstance(one, dict):
        one, other = ({key: value for key, value in of.items() if key != "tile"}
                      for of in (one, other))  # a page has that of one axis
        keys = {exchanged(key): key for key in other}
        if set(one) != set(keys):
            yield f"{place}: {sorted(set(one) ^ set(keys))}"
        for key in set(one) & set(keys):
            yield from differences(one[key], other[keys[key]], *more, f"{place}/{key}")
    elif isinstance(one, list):
        if len(one) != len(other):
            yield f"{place}: {len(one)} and {len(other)} of them"
        if one and isinstance(one[0], dict) and "id" in one[0]:
            yield from differences({f["id"]: f for f in one}, {f["id"]: f for f in other}, *more,
                                   place)
            return
        for k, (a, b) in enumerate(zip(one, other, strict=False)):
            yield from differences(a, b, *more, f"{place}[{k}]")
    elif isinstance(one, str):
        if one != exchanged(other):
            yield f"{place}: {one}; exchanged: {other}"
    elif one is None or other is None:
        if one is not other:
            yield f"{place}: {one}; exchanged: {other}"
    elif not math.isclose(one, other, rel_tol=part, abs_tol=least):
        yield f"{place}: {one}; exchanged: {other}"


class Pairs(unittest.TestCase):
    """Runs in folders xy and yx, or others, of a folder that is made anew."""

    program, folder = None, None

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)
        cls.folder.mkdir(parents=True)

    @classmethod
    def write_points(cls, name, points):
        """A path in mm as a file of points."""
        rows = "".join(f"{x:.4f},{y:.4f}\n" for x, y in points)
        (cls.folder / f"{name}.csv").write_text(f"x_mm,y_mm\n{rows}")

    @classmethod
    def write_both(cls, points):
        cls.write_points("xy", points)
        cls.write_points("yx", [(y, x) for x, y in points])
