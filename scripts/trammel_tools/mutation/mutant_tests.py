# SPDX-License-Identifier: Apache-2.0
"""Runs a block's unit test against its mutants: one build, one process a mutant.

The test is compiled unmodified. The mutants' module has the block's name and ports; it asks
tests/support/mutant.cpp at the start of the simulation which mutant it is.
"""

import functools
import os
import resource
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor

from trammel_tools.mutation import mutants
from trammel_tools.mutation.mutants import MutationError
from trammel_tools.paths import CATCH_MAIN, ROOT, RTL, twin_sources
from trammel_tools.rtl import hierarchy, lint

DECLARATION = f"""  import "DPI-C" function int {mutants.SELECTOR}();
  reg [{mutants.WIDTH - 1}:0] selected;
  initial selected = {mutants.SELECTOR}();
"""
JOBS = 2
SLOWEST = 10  # a mutant that takes this many times the block's own time hangs
AT_LEAST = 5.0  # [s]


def has_test(layer, stem):
    return (ROOT / "tests" / layer / f"{stem}_test.cpp").exists()


@functools.cache
def chips():
    """{chip: all modules inside}, of chips with a unit test."""
    files = sorted(RTL.glob("chips/*.sv"))
    return {path.stem: hierarchy.modules(path.stem, files) for path in files
            if has_test("chips", path.stem)}


def top_of(block):
    """The module that the unit test of this block is about: itself, or a chip around it."""
    layer, stem = block.split("/")
    if layer != "chips" or has_test(layer, stem):
        return stem
    return next((chip for chip, inside in chips().items() if stem in inside), stem)


def test_of(block):
    return ROOT / "tests" / block.split("/")[0] / f"{top_of(block)}_test.cpp"


def mutated():
    """The blocks that a unit test has in it."""
    return [block for block in lint.blocks() if test_of(block).exists()]


def files_of(block):
    """The test, and its parts <stem>_<part>_test.cpp that are not the test of another block."""
    test = test_of(block)
    parts = sorted(test.parent.glob(f"{test.stem.removesuffix('_test')}_*_test.cpp"))
    blocks = RTL / block.split("/")[0]
    return [test, *(part for part in parts
                    if not (blocks / f"{part.stem.removesuffix('_test')}.sv").exists())]


def build(block):
    """Compiles the test with the mutants; returns the program."""
    folder, (layer, stem), top = mutants.folder_of(block), block.split("/"), top_of(block)
    netlist = mutants.with_selector(block, "split.v", DECLARATION, f"{stem}.sv")
    text = netlist.read_text(encoding="utf-8")
    head, declaration, body = text.partition(DECLARATION)
    netlist.write_text(head + declaration + body.replace(f"{mutants.SELECTOR} ==", "selected =="),
                       encoding="utf-8")
    rtl = [] if top == stem else [*map(str, lint.packages()), str(RTL / layer / f"{top}.sv")]
    search = [f"-I{d}" for d in sorted(RTL.iterdir()) if d.is_dir() and d.name != "boards"]
    sources = [ROOT / "tests" / "support" / f"{one}.cpp" for one in ("main", "first_failure")]
    main = map(str, [CATCH_MAIN] if CATCH_MAIN.exists() else sources)
    command = ["verilator", "--cc", "--exe", "--build", "-j", str(JOBS),
               "-Wno-fatal", "-Wno-lint", "-fno-dfg",
               "--top-module", top, "--prefix", f"V{top}", "--Mdir", str(folder / "obj"),
               "-CFLAGS", f"-std=c++17 -I{ROOT}", "-o", "mutants", *search,
               f"-I{RTL}/chips/generated", *rtl, str(netlist), *map(str, files_of(block)),
               *map(str, twin_sources(top)),
               str(ROOT / "tests" / "support" / "mutant.cpp"), *main]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False,
                          env={**os.environ, "OBJCACHE": "ccache"})
    (folder / "build.log").write_text(done.stdout + done.stderr, encoding="utf-8")
    if done.returncode != 0:
        raise MutationError(f"the test does not build with the mutants: {folder}/build.log")
    return folder / "obj" / "mutants"


def passes(program, number, limit):
    """Whether the test accepts a mutant; one that exceeds the limit [s] is not accepted."""
    try:
        done = subprocess.run([str(program), "--abort"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, check=False, timeout=limit,
                              preexec_fn=no_core,
                              env={**os.environ, "TRAMMEL_MUTANT": str(number)})
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def no_core():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))  # a mutant may crash the test


def survivors(block, program, numbers):
    """Numbers of the mutants that the test accepts."""
    begin = time.monotonic()
    if not passes(program, 0, 600):
        raise MutationError("the test fails without a mutant: the netlist is not the block")
    limit = max(AT_LEAST, SLOWEST * (time.monotonic() - begin))
    with ThreadPoolExecutor(JOBS) as pool:
        accepted = list(pool.map(lambda n: passes(program, n, limit), numbers))
    return [n for n, ok in zip(numbers, accepted) if ok]
