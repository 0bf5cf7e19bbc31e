# SPDX-License-Identifier: Apache-2.0
"""Build the firmware for a small RISC-V core (rv32im, no operating system) and check what it links.

usage: scripts/tool firmware
       scripts/tool firmware --words APP FILE [--ram BYTES]

Compiles sw_nios/ as freestanding C++17 with every warning an error. An app with its own main,
sw_nios/apps/<m>/rv32im/main.cpp, is linked with sw_nios/rv32im/link.ld, and its size is printed. It
fails when the program holds a heap, a stream, exceptions or floating-point arithmetic: code that
must run to completion with the same result on every core has none of these.

The drivers in C of parts, parts/<part>/driver/*.c, are compiled as freestanding C99; they must keep
no variables and need nothing but each other.

With --words it only links one app and writes the words of its memory, for a program or a memory of
the FPGA that holds them: 0x00000000, each, or for FILE.hex 00000000.

Exit codes: 0 as it should be, 1 it does not build or holds what it must not, 2 there is no such app
or FILE cannot be written, 3 the cross compiler is missing (under CTest 77). The programs
are build/firmware/<m>.elf.
"""

import argparse
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

from trammel_tools import output_file, python_tools
from trammel_tools.paths import ROOT

SOURCES = ROOT / "sw_nios"
OUT = ROOT / "build" / "firmware"
PREFIX = "riscv64-unknown-elf-"
RAM = 65536  # bytes; parameter Words of the chip with the core
CORE = ["-march=rv32im", "-mabi=ilp32"]
COMPILE = ["-std=c++17", "-ffreestanding", "-fno-exceptions", "-fno-rtti",
           "-fno-threadsafe-statics", "-fno-use-cxa-atexit", "-ffunction-sections",
           "-fdata-sections", "-O2", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror",
           "-I.", "-isystem", "sw_nios/rv32im/include"]
SMALL = {"console.cpp"}  # what is in no hurry: the memory must hold it all
LINK = ["--specs=picolibc.specs", "-nostartfiles", "-nostdlib", "-T", "sw_nios/rv32im/link.ld",
        "-Wl,--gc-sections,--fatal-warnings,--no-warn-rwx-segments"]
DRIVER = ["-std=c99", "-ffreestanding", "-Os", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow",
          "-Wconversion", "-Wcast-qual", "-Wstrict-prototypes", "-Werror"]
FORBIDDEN = {
    "heap": r"malloc|free|calloc|realloc|_?sbrk|_Zn[wa]j.*|_Zd[la]Pv.*",
    "floating point": r"__(add|sub|mul|div|neg|cmp|eq|ne|lt|le|gt|ge|unord|pow)[sdt]f[23i]+"
                      r"|__(fix|fixuns|float|floatun|extend|trunc)\w*[sdt]f\w*",
    "streams": r"_ZNSt8ios_base\w*|_ZSt4cout|_ZSt3cin|printf|puts",
    "exceptions": r"__cxa_(throw|begin_catch|allocate_exception)|_Unwind_\w+",
}


def tried(*command):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


def run(*command):
    done = tried(*command)
    if done.returncode != 0:
        print((done.stdout + done.stderr).strip(), file=sys.stderr)
    return done.stdout if done.returncode == 0 else None


def compiled(out, only=None):
    """{source: its object}, or None; all sources, or what one app needs."""
    out.mkdir(parents=True, exist_ok=True)
    objects = {}
    for source in sorted([*SOURCES.rglob("*.cpp"), *SOURCES.rglob("*.S")]):
        if only and app_of(source.relative_to(SOURCES)) not in (None, only):
            continue
        name = "_".join(source.relative_to(SOURCES).with_suffix(".o").parts)
        flags = COMPILE if source.suffix == ".cpp" else []
        if source.name in SMALL:
            flags = ["-Os" if flag == "-O2" else flag for flag in flags]
        if run(f"{PREFIX}g++", *CORE, *flags, "-c", str(source), "-o", str(out / name)) is None:
            return None
        objects[source.relative_to(SOURCES)] = str(out / name)
    return objects


def app_of(source):
    """The app that a source is of; None: all have it."""
    return source.parts[1] if source.parts[0] == "apps" else None


def programs(sources):
    """Apps that have a main for the core."""
    return [app_of(source) for source in sources
            if app_of(source) and source == Path("apps", app_of(source), "rv32im", "main.cpp")]


def link(app, objects, out, ram=RAM):
    """The program of an app, or None."""
    program = out / f"{app}.elf"
    own = [name for source, name in objects.items() if app_of(source) in (None, app)]

    def linked(size):
        return tried(f"{PREFIX}g++", *CORE, *LINK, f"-Wl,--defsym=ram_size={size}", *own,
                     "-Wl,--start-group", "-lc", "-lgcc", "-Wl,--end-group", "-o", str(program))

    done = linked(ram)
    if done.returncode == 0:
        return program
    over = re.search(r"region `ram' overflowed by (\d+) bytes", done.stderr)
    if over:
        print(f"firmware: {app} needs {ram + int(over[1])} bytes of memory, stack included; the "
              f"chip has {ram}", file=sys.stderr)
    else:
        print((done.stdout + done.stderr).strip(), file=sys.stderr)
    return None


def write_words(program, file):
    """The words that the memory holds before the core starts."""
    binary = program.with_suffix(".bin")
    if run(f"{PREFIX}objcopy", "-O", "binary", str(program), str(binary)) is None:
        return False
    image = binary.read_bytes()
    image += bytes(-len(image) % 4)
    form = "{:08x}\n" if file.suffix == ".hex" else "0x{:08x},\n"
    output_file.replace(file, "".join(form.format(word)
                                      for (word,) in struct.iter_unpack("<I", image)))
    return True


def words(app, file, ram):
    """Exit code."""
    output_file.check(file)
    out = file.parent / f"{file.stem}_firmware"
    objects = compiled(out, app)
    if objects is None:
        return 1
    if app not in programs(objects):
        return python_tools.refuse("firmware", f"sw_nios/apps/{app}/rv32im/main.cpp: no such file")
    program = link(app, objects, out, ram)
    return 0 if program and write_words(program, file) else 1


def forbidden(symbols):
    for what, pattern in FORBIDDEN.items():
        found = sorted(s for s in symbols if re.fullmatch(pattern, s))
        if found:
            yield f"firmware: {what} is linked: {', '.join(found)}"


def driver_problems(name, symbols):
    """What is wrong with a driver: lines of `nm --format=posix` of its objects."""
    words = [line.split()[:2] for line in symbols.split("\n") if len(line.split()) > 1]
    defined = {symbol for symbol, kind in words if kind not in "Uu"}
    needed = sorted({symbol for symbol, kind in words if kind == "U"} - defined)
    kept = sorted(symbol for symbol, kind in words if kind in "BbCDdGgSs")
    if needed:
        yield f"firmware: {name} needs {', '.join(needed)}"
    if kept:
        yield f"firmware: {name} keeps {', '.join(kept)}"


def drivers():
    """Compiles the drivers in C; what is wrong, or None where one does not compile."""
    wrong = []
    for folder in sorted((ROOT / "parts").glob("*/driver")):
        name, symbols = str(folder.relative_to(ROOT)), ""
        for source in sorted(folder.glob("*.c")):
            compiled = str(OUT / f"{folder.parent.name}_driver_{source.stem}.o")
            if run(f"{PREFIX}gcc", *CORE, *DRIVER, "-c", str(source), "-o", compiled) is None:
                return None
            symbols += run(f"{PREFIX}nm", "--format=posix", compiled)
            text = run(f"{PREFIX}size", compiled).split("\n")[1].split()[0]
            print(f"firmware: {name}/{source.name}: text {text} bytes")
        wrong += driver_problems(name, symbols)
    return wrong


def main():
    parser = argparse.ArgumentParser(prog="scripts/tool firmware", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--words", nargs=2, metavar=("APP", "FILE"))
    parser.add_argument("--ram", type=int, default=RAM, metavar="BYTES")
    asked = parser.parse_args()
    if shutil.which(f"{PREFIX}g++") is None:
        print(f"firmware: {PREFIX}g++ is missing (trammel doctor)", file=sys.stderr)
        return 77 if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    if asked.words:
        try:
            return words(asked.words[0], Path(asked.words[1]), asked.ram)
        except output_file.Refused as error:
            return python_tools.refuse("firmware", error)
    objects = compiled(OUT)
    if objects is None:
        return 1
    apps = programs(objects)
    if not apps:
        print("firmware: no app has an rv32im/main.cpp", file=sys.stderr)
        return 1
    wrong = []
    for program in [link(app, objects, OUT) for app in apps]:
        if program is None:
            return 1
        text, data, bss = run(f"{PREFIX}size", str(program)).split("\n")[1].split()[:3]
        print(f"firmware: {program.relative_to(ROOT)}: text {text}, data {data}, bss {bss} bytes")
        names = run(f"{PREFIX}nm", "--format=posix", str(program)).split("\n")
        wrong += forbidden({line.split()[0] for line in names if line})
    of_drivers = drivers()
    if of_drivers is None:
        return 1
    wrong += of_drivers
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0
