# SPDX-License-Identifier: Apache-2.0
"""List, convert, compare and draw wave files (VCD or FST).

usage: trammel wave list FILE [--signals GLOB ...] [--json]
       trammel wave convert IN OUT               .fst to .vcd or back
       trammel wave compare A B [--window a:b] [--signals GLOB ...] [--first N] [--json]
       trammel wave draw FILE --window a:b --signals [LABEL=]NAME[:FORMAT] ... -o PICTURE.svg
                         [--measure LABEL LABEL] [--clock NAME] [--around N] [--title TEXT]

Times are from the start of the run and end in s, ms, us, ns or clk: --window 2ms:2.1ms. A name may
begin at any scope (u_afc.e_q), * and ? are wild.

compare checks the values in the window, signal by signal, and prints the first differences.
draw writes PICTURE.svg and the WaveJSON beside it (PICTURE.json). Clocks in which nothing drawn
changes are left out where there are more than a few (--around N are kept before and after each
change); the first row then says at which clock it continues. FORMAT is d (signed), u, x or b.
--measure draws an arrow from the first change of one signal to the next one of another and counts
the clocks.

What convert and draw write replaces a regular file only, and none of a run's record. A PICTURE.json
that is not of the form that draw writes is yours and stays: nothing is drawn.

Exit codes: 0 equal or done, 1 the files differ, 2 a file or an argument is wrong, 3 a tool is
missing.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from trammel_tools import output_file, python_tools
from trammel_tools.output_file import Refused
from trammel_tools.waves import wave_picture
from trammel_tools.waves.wave_file import WaveFile, time_text, within

CONVERTERS = {(".fst", ".vcd"): ["fst2vcd", "-f", "{}", "-o", "{}"],
              (".vcd", ".fst"): ["vcd2fst", "-v", "{}", "-f", "{}"]}
SHOWN = 12  # differences, unless told


def list_signals(args):
    wave = WaveFile(args.file)
    names = wave.select(args.signals)
    if args.json:
        print(json.dumps([{"name": name, "bits": wave.bits(name)} for name in names], indent=1))
        return 0
    for name in names:
        bits = wave.bits(name)
        print(f"{name}[{bits - 1}:0]" if bits > 1 else name)
    return 0


def convert(args):
    source, target = Path(args.input), Path(args.output)
    command = CONVERTERS.get((source.suffix, target.suffix))
    if command is None:
        raise Refused(f"convert: {source.suffix or source} to {target.suffix or target}: only "
                      ".fst to .vcd and .vcd to .fst")
    if shutil.which(command[0]) is None:
        print(f"wave: {command[0]} is missing (trammel doctor)", file=sys.stderr)
        return 3
    WaveFile(source)  # a broken file is told before a tool chokes on it
    with output_file.replacing(target) as scratch:  # vcd2fst makes another file beside its own
        paths = iter([source, scratch])
        done = subprocess.run([str(next(paths)) if word == "{}" else word for word in command],
                              capture_output=True, check=False)
        if done.returncode != 0 or not scratch.exists() or scratch.stat().st_size == 0:
            raise Refused(f"{source}: {command[0]} could not convert it")
    print(f"wrote {target}")
    return 0


def differences(one, two, names, windows):
    """(femtoseconds, name, value in one, value in two) of each first difference; signals seen."""
    seen = set()
    compared = 0
    found = []
    for name in names:
        pair = (one.identity(name), two.identity(name))
        if pair in seen:
            continue
        seen.add(pair)
        compared += 1
        sides = []
        for wave, window in zip((one, two), windows):
            first, inside = within(wave.changes(name), window)
            begin = window[0] if first is not None else 0
            sides.append([(begin * wave.step, first), *((t * wave.step, v) for t, v in inside)])
        difference = first_difference(*sides)
        if difference:
            found.append((difference[0], name, *difference[1:]))
    return sorted(found, key=lambda d: d[:2]), compared


def first_difference(one, two):
    """Of two lists of (time, value): when the values part, and what they are."""
    if one == two:
        return None
    index = 0
    while index < min(len(one), len(two)) and one[index] == two[index]:
        index += 1
    rest = [side[index] if index < len(side) else None for side in (one, two)]
    time = min(change[0] for change in rest if change)
    values = []
    for side, change in zip((one, two), rest):
        held = side[index - 1][1] if index else None
        values.append(change[1] if change and change[0] == time else held)
    return (time, *values)


def compare(args):
    one, two = WaveFile(args.a), WaveFile(args.b)
    names = one.select(args.signals)
    other = set(two.select(args.signals))
    common = [name for name in names if name in other]
    alone = [(one.path, name) for name in names if name not in other]
    alone += [(two.path, name) for name in sorted(other - set(names))]
    windows = [wave.reached(args.window) for wave in (one, two)]
    found, compared = differences(one, two, common, windows)
    equal = not found and not alone
    if args.json:
        print(json.dumps({"equal": equal, "compared": compared, "differing": len(found),
                          "only_in_one": len(alone),
                          "first": [{"t_s": d[0] / 1e15, "signal": d[1], "a": d[2], "b": d[3]}
                                    for d in found[:args.first]]}, indent=1))
        return 0 if equal else 1
    for time, name, value_one, value_two in found[:args.first]:
        print(f"{time_text(time):<18}{name}: {value_one} and {value_two}")
    for path, name in alone[:args.first]:
        print(f"only in {path}: {name}")
    if equal:
        print(f"equal: {compared} signals")
    else:
        print(f"{len(found)} of {compared} signals differ, {len(alone)} are in one file only")
    return 0 if equal else 1


def draw(args):
    wave = WaveFile(args.file)
    target = Path(args.output)
    if target.suffix != ".svg":
        raise Refused(f"-o {target}: the picture's name ends in .svg")
    source = target.with_suffix(".json")
    for file in target, source:
        output_file.check(file)
    if source.exists() and not wave_picture.is_own(source):
        raise Refused(f"{source}: is not of the form that draw writes: move it away, or name "
                      "another picture")
    picture = wave_picture.wave_json(wave, args)
    text = wave_picture.svg(picture)
    with output_file.replacing(source) as scratch:
        scratch.write_text(wave_picture.json_text(picture), encoding="utf-8")
        output_file.replace(target, text)
    print(f"wrote {target} and {source}")
    return 0


def arguments():
    parser = python_tools.Parser(prog="trammel wave", add_help=False)
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="VERB")

    def verb(name, action):
        sub = verbs.add_parser(name)
        sub.set_defaults(action=action)
        return sub

    listing = verb("list", list_signals)
    listing.add_argument("file")
    converting = verb("convert", convert)
    converting.add_argument("input")
    converting.add_argument("output")
    comparing = verb("compare", compare)
    comparing.add_argument("a")
    comparing.add_argument("b")
    comparing.add_argument("--first", type=int, default=SHOWN)
    drawing = verb("draw", draw)
    drawing.add_argument("file")
    drawing.add_argument("-o", "--output", required=True)
    drawing.add_argument("--clock")
    drawing.add_argument("--around", type=int, default=2)
    drawing.add_argument("--title", default="")
    drawing.add_argument("--measure", nargs=2, action="append", default=[])
    for sub in (comparing, drawing):
        sub.add_argument("--window", required=sub is drawing)
    for sub in (listing, comparing, drawing):
        sub.add_argument("--signals", nargs="+", required=sub is drawing, default=[])
    for sub in (listing, comparing):
        sub.add_argument("--json", action="store_true")
    return parser


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    args = arguments().parse_args()
    python_tools.need("pywellen", "wave")
    try:
        return args.action(args)
    except Refused as error:
        return python_tools.refuse("wave", error)
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:  # whoever reads a long list has closed the pipe
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        return python_tools.refuse("wave", f"{error.filename}: {error.strerror}")
