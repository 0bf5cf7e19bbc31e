# SPDX-License-Identifier: Apache-2.0
"""Execute the tutorial's section that adds a machine, and check that nothing else had to change.

usage: scripts/tool machine-lesson

In a fresh copy of the repository's files, build/new_machine, it executes the blocks of the section,
with the launcher and its build of the program (the compiler cache helps), the new machine's own
tests, and check-layout. At the end every copied file must be unchanged, except generated pages.

Exit codes: 0 all of this holds, 1 it does not, 3 a tool is missing (under CTest 77).
"""

import os
import shutil
import subprocess
import sys

from trammel_tools import python_tools
from trammel_tools.check import check_docs, check_layout
from trammel_tools.paths import ROOT

PAGE = ROOT / "docs" / "tutorial.md"
FOLDER = ROOT / "build" / "new_machine"
GENERATED = {"docs/columns.md", "docs/figures.md", "docs/keys.md", "docs/manual.md",
             "docs/tools.md", "docs/generated/assertions.md", "tests/goldens/machines.txt"}
LIMIT_S = 3600  # of a block that builds


def copy():
    """Files of the repository there; {path: bytes}."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    kept = {}
    for path in check_layout.tracked(ROOT):
        kept[path] = (ROOT / path).read_bytes()
        (FOLDER / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / path, FOLDER / path)
    # The layout check looks at what git would add, and diffs are applied inside a repository.
    subprocess.run(["git", "init", "-q", "--template=", FOLDER], check=True)
    if (ROOT / ".venv").exists():
        (FOLDER / ".venv").symlink_to((ROOT / ".venv").resolve())
    return kept


def section():
    """The text behind the mark, and its first line."""
    head, found, text = PAGE.read_text(encoding="utf-8").partition(check_docs.BUILDS)
    if not found:
        raise SystemExit(f"machine-lesson: {PAGE.relative_to(ROOT)} has no line "
                         f"{check_docs.BUILDS.rstrip()}")
    return text, (head + found).count("\n") + 1


def findings(folder):
    """What the layout check of a copy says, without line numbers."""
    done = subprocess.run([folder / "scripts" / "tool", "check-layout"], capture_output=True,
                          text=True, check=False)
    return set(done.stdout.splitlines())


def problems(kept, before):
    text, line = section()
    environment = {**os.environ, "TRAMMEL_NO_APT": "1"}
    yield from check_docs.run_blocks(PAGE, text, line, FOLDER, environment, LIMIT_S)
    for finding in sorted(findings(FOLDER) - before):
        yield f"check-layout: {finding}"
    changed = sorted(str(path) for path, content in kept.items()
                     if not (FOLDER / path).exists() or (FOLDER / path).read_bytes() != content)
    own = [path for path in changed if path not in GENERATED]
    yield from (f"{path}: was changed" for path in own)
    print(f"{len(kept)} files, {len(own)} changed; written again: "
          f"{', '.join(path for path in changed if path in GENERATED) or 'none'}")


def main():
    python_tools.Parser(prog="scripts/tool machine-lesson", description=__doc__).parse_args()
    for program in ("git", "cmake", "ninja", "verilator"):
        if shutil.which(program) is None:
            print(f"machine-lesson: {program} is missing (trammel doctor)", file=sys.stderr)
            return 77 if "CTEST_INTERACTIVE_DEBUG_MODE" in os.environ else 3
    python_tools.need("pyosys", "machine-lesson")
    kept = copy()
    wrong = list(problems(kept, findings(FOLDER)))
    for problem in wrong:
        print(f"machine-lesson: {problem}", file=sys.stderr)
    return 1 if wrong else 0
