# SPDX-License-Identifier: Apache-2.0
"""The fuzzers in process: tests/fuzz with libFuzzer, the sanitizers and Clang."""

import os
import re
import shutil
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools.fuzz import fuzz_seeds
from trammel_tools.paths import ROOT

BUILD = ROOT / "build" / "fuzz"
BINARY = BUILD / "tests" / "fuzz" / "trammel_fuzz"
FINDINGS = BUILD / "findings"
# Longest input; share of the cases. An input of a run's folder makes files and a page.
TARGETS = {"folder": (20000, 0.03), "keys": (1000, 0.15), "scenario": (4000, 0.25),
           "points": (2000, 0.1), "gcode": (3000, 0.2)} | {name: (table["longest"], table["share"])
                                     for name, table in fuzz_seeds.targets().items()}
REPLAY = ROOT / "build" / "asan" / "tests" / "fuzz" / "trammel_fuzz_replay"
REPLAYED = {"keys": 1500, "scenario": 2000, "points": 4000, "gcode": 8000, "folder": 60}
ENVIRONMENT = os.environ | {"ASAN_OPTIONS": "detect_stack_use_after_return=0",
                            "UBSAN_OPTIONS": "print_stacktrace=1"}


def build():
    """The last lines of what failed, or None."""
    log = ROOT / "build" / "fuzz.log"
    with log.open("w", encoding="utf-8") as out:
        for command in ["cmake", "--preset", "fuzz"], ["ninja", "-C", BUILD, "trammel_fuzz"]:
            if subprocess.run(command, cwd=ROOT, stdout=out, stderr=out, check=False).returncode:
                return log.read_text(encoding="utf-8")[-4000:]
    return None


def run_one(target, budget, seed, seeds, scratch):
    """(cases, coverage, seconds, what was found) of one target; budget: options of libFuzzer."""
    folder = scratch / f"of-{target}"
    corpus = folder / "corpus"
    corpus.mkdir(parents=True)
    options = [f"-seed={seed}", f"-max_len={TARGETS[target][0]}", "-timeout=10",
               "-rss_limit_mb=3000", "-print_final_stats=1", "-reload=0",
               f"-dict={scratch / 'words.dict'}", f"-artifact_prefix={FINDINGS}/{target}-"]
    begin = time.monotonic()
    done = subprocess.run(
        [BINARY, *options, *budget, corpus, seeds / target], cwd=folder, capture_output=True,
        text=True, errors="replace", check=False,
        env=ENVIRONMENT | {"TRAMMEL_FUZZ_TARGET": target,
                           "TRAMMEL_FUZZ_RUNS": str(scratch / "runs")})
    cases = re.search(r"number_of_executed_units: (\d+)", done.stderr)
    covered = re.findall(r" cov: (\d+)", done.stderr)
    found = "" if done.returncode == 0 else done.stderr[-6000:]
    return (int(cases[1]) if cases else 0, int(covered[-1]) if covered else 0,
            time.monotonic() - begin, found)


def prepared(program, scratch):
    """Seeds, dictionary and runs in this folder."""
    fuzz_seeds.short_runs(program, scratch / "runs")
    fuzz_seeds.write_seeds(program, scratch / "runs", scratch / "seeds")
    fuzz_seeds.write_dictionary(program, scratch / "words.dict")


def scratch_folder():
    """In memory where there is such a file system: each case of a folder writes files."""
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    return tempfile.TemporaryDirectory(prefix="trammel-fuzz-", dir=memory)


def run(program, seed, count=None, seconds=None):
    """Runs all targets, one a processor; prints a line each. The number of findings."""
    FINDINGS.mkdir(parents=True, exist_ok=True)
    budgets = {target: [f"-runs={int(count * share)}"] if seconds is None else
               [f"-max_total_time={max(1, int(seconds * (os.cpu_count() or 1) / len(TARGETS)))}"]
               for target, (_, share) in TARGETS.items()}
    with scratch_folder() as folder, ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        scratch = Path(folder)
        prepared(program, scratch)
        results = dict(zip(TARGETS, pool.map(
            lambda target: run_one(target, budgets[target], seed, scratch / "seeds", scratch),
            TARGETS), strict=True))
    for target, (cases, covered, took, found) in results.items():
        print(f"fuzz: {target:<9} seed {seed}: {cases:>8} cases in {took:5.0f} s, coverage "
              f"{covered} edges, {'a finding' if found else 'no finding'}")
        if found:
            print(found)
    print(f"fuzz: {sum(r[0] for r in results.values())} cases in process")
    return sum(bool(result[3]) for result in results.values())


def replay(program, seed):
    """Some cases of each target with the sanitized build of the tests. The number of findings."""
    found = 0
    with scratch_folder() as folder:
        scratch = Path(folder)
        prepared(program, scratch)
        # Not counted: coverage.cpp is that of the tests that know what they expect.
        environment = ENVIRONMENT | {"GCOV_PREFIX": str(scratch / "counts")}
        for target in TARGETS:
            cases = REPLAYED.get(target, 4000)
            command = [REPLAY, target, str(cases), str(seed), scratch / "runs",
                       scratch / "seeds" / target, scratch / "words.words"]
            done = subprocess.run(command, cwd=scratch, env=environment, capture_output=True,
                                  text=True, errors="replace", check=False, timeout=200)
            print(f"fuzz: {target:<9} seed {seed}: {cases} cases, exit {done.returncode}")
            if done.returncode != 0:
                found += 1
                FINDINGS.mkdir(parents=True, exist_ok=True)
                shutil.copy(scratch / "last-input", FINDINGS / f"{target}-replay")
                print(done.stderr[-6000:])
    return found
