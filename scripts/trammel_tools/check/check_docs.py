# SPDX-License-Identifier: Apache-2.0
"""Check what the documentation says against the program.

usage: scripts/tool check-docs [--program FILE]     links, commands, defaults, files of a run
       scripts/tool check-docs [--program FILE] --run     executes the lessons

Links lead to files and headings that exist. In every code block, a line that begins with ./trammel
names a verb, options, keys and scenarios that exist. `section.key = value` in the text is the
default. files.md names every file a run can write.

--run executes quickstart and tutorial: it copies the repository to a scratch folder and there, in
order, executes the blocks marked sh and applies those marked diff; "# exit code N" at the end of a
line is the exit code that line must give; a block after "<!-- not run: reason -->" is skipped. The
lines of a block marked text must have been printed by the blocks before it. What follows the line
"<!-- executed by scripts/tool machine-lesson -->" is left to that tool. `trammel test` builds what
it needs there; all other verbs are those of the program FILE. Nothing is installed.

Exit codes: 0 ok, 1 something is wrong, 3 the program is not built.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from trammel_tools import machines, python_tools
from trammel_tools.check.check_layout import tracked
from trammel_tools.generate import gen_manual
from trammel_tools.paths import ROOT

FILES = ROOT / "docs" / "files.md"
# Files of a run, in the sources and in scripts of gnuplot.
WRITTEN = re.compile(r'(?:scratch|folder|parent_path\(\)) / "(\w+\.[\w.]+)"')
DRAWN = re.compile(r"set output '([\w.]+)'")
LESSONS = (ROOT / "docs" / "quickstart.md", ROOT / "docs" / "tutorial.md")
LIMIT_S = 300  # of one block
# A section with this line is executed by scripts/tool machine-lesson, for it builds the program.
BUILDS = "<!-- executed by scripts/tool machine-lesson -->\n"
FENCE = re.compile(r"^(<!-- not run: [^\n]*-->\n)?```(\w*)\n(.*?)^```$", re.M | re.S)

LAUNCHER = r"""#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
set -euo pipefail
optional() { "$@" || { code=$?; [ $code = 3 ] || [ $code = 77 ] || exit $code; }; }
tool() { optional "$PYTHON" scripts/tool "$@"; }
case $1 in
  test) optional ./launcher "$@" ;;
  *)
    if [[ $TOOLS == *" $1 "* ]]; then tool "$@"; else exec "$PROGRAM" "$@"; fi
    ;;
esac
"""


def pages():
    """All pages but templates, which become pages once their names are filled in."""
    return [ROOT / p for p in tracked(ROOT)
            if p.suffix == ".md" and "machine_template" not in p.parts]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def anchors(page):
    """Anchors of the headings, as the usual renderers make them."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M):
        found.add(re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-"))
    return found


def check_links():
    for page in pages():
        text = page.read_text(encoding="utf-8")
        plain = FENCE.sub(lambda m: "\n" * m[0].count("\n"), text)
        for link in re.finditer(r"\]\(([^)\s]+)\)", plain):
            name, _, anchor = link[1].partition("#")
            if name.startswith(("http:", "https:")):
                continue
            at = f"{page.relative_to(ROOT)}:{line_of(plain, link.start())}"
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                yield f"{at}: no file {name}"
            elif re.fullmatch(r"L\d+", anchor):
                if int(anchor[1:]) > len(target.read_text(encoding="utf-8").split("\n")):
                    yield f"{at}: {name} has no line {anchor[1:]}"
            elif anchor and anchor not in anchors(target):
                yield f"{at}: no heading #{anchor} in {target.name}"


def check_defaults(keys):
    sections = {key.split(".")[0] for key in keys if "." in key}
    for page in pages():
        text = page.read_text(encoding="utf-8")
        for claim in re.finditer(r"`([a-z]\w*\.[\w.]+) = ([^`]+)`", text):
            if claim[1].split(".")[0] not in sections:
                continue
            at = f"{page.relative_to(ROOT)}:{line_of(text, claim.start())}"
            if claim[1] not in keys:
                yield f"{at}: {claim[1]} is no key"
            elif claim[2] not in keys[claim[1]]:
                own = " or ".join(keys[claim[1]])
                yield f"{at}: the default of {claim[1]} is {own}, not {claim[2]}"


def check_files():
    names = {"run.json", "waves.fst", "waves.vcd"}
    for source in [*ROOT.glob("lab/*.cpp"), *ROOT.glob("machines/**/*.cpp")]:
        if "tests" not in source.parts:
            names |= set(WRITTEN.findall(source.read_text(encoding="utf-8")))
    for script in ROOT.glob("machines/*/pictures/*.gp"):
        names |= set(DRAWN.findall(script.read_text(encoding="utf-8")))
    listed = FILES.read_text(encoding="utf-8")
    for name in sorted(names):
        if f"`{name}`" not in listed:
            yield f"docs/files.md: {name}, which a run can write, is missing"


def check_commands(program, keys):
    own = {name: gen_manual.said(program, name, "--help")
           for name, _ in gen_manual.program_verbs(program)}
    general = gen_manual.said(program, "--help")
    scripts = {name for name, _ in gen_manual.script_verbs()} | {"test"}
    axis_free = {re.sub(r"\.[xy]\.", ".", key) for key in keys} | set(keys)
    scenarios = machines.scenarios()
    for page in pages():
        text = page.read_text(encoding="utf-8").partition(BUILDS)[0]
        for fence in FENCE.finditer(text):
            for line in fence[3].replace("\\\n", " ").split("\n"):
                if not line.startswith("./trammel "):
                    continue
                words = shlex.split(line, comments=True)[1:]
                ends = [n for n, word in enumerate(words) if word in ("|", ">", ">>", "&&")]
                words = words[:ends[0]] if ends else words
                at = f"{page.relative_to(ROOT)}: '{line}'"
                verb = words[0]
                if verb in scripts or verb.startswith("-"):
                    continue
                if verb not in own:
                    yield f"{at}: no verb {verb}"
                    continue
                for word, after in zip(words[1:], [*words[2:], ""]):
                    if word.startswith("-") and not re.search(
                            rf"(^|[\s,]){re.escape(word)}\b", own[verb] + general):
                        yield f"{at}: {verb} has no option {word}"
                    key = after.partition("=")[0]
                    if word in ("-s", "--set") and key not in axis_free \
                            and "# exit code 2" not in line:
                        yield f"{at}: no key {key}"
                if verb == "run" and len(words) > 1 and re.fullmatch(r"\w[\w-]*", words[1]) \
                        and words[1] not in scenarios:
                    yield f"{at}: no scenario {words[1]}"


def script_of(block):
    """A block for bash: every line must succeed, except those that say how they fail."""
    lines = ["set -eu"]
    for line in block.split("\n"):
        code = re.search(r"\s+# exit code (\d+)", line)
        if code:
            lines.append(f"got=0; {line[:code.start()]} || got=$?; "
                         f"[ $got = {code[1]} ] || {{ echo 'ended with '$got >&2; exit 1; }}")
        else:
            lines.append(line)
    return "\n".join(lines)


def run_blocks(page, text, first_line, folder, environment, limit):
    """Executes the blocks of a page's text, which begins at that line, up to one that fails."""
    printed = set()
    for fence in FENCE.finditer(text):
        at = f"{page.relative_to(ROOT)}:{line_of(text, fence.start()) + first_line - 1}"
        if fence[2] == "text":
            for line in set(fence[3].rstrip().split("\n")) - printed - {""}:
                yield f"{at}: was not printed: {line}"
        if fence[1] or fence[2] not in ("sh", "diff"):
            continue
        command = ["git", "apply", "--recount", "-"] if fence[2] == "diff" else ["bash"]
        content = fence[3] if fence[2] == "diff" else script_of(fence[3])
        done = subprocess.run(command, input=content, capture_output=True, text=True, check=False,
                              cwd=folder, env=environment, timeout=limit)
        printed |= set(done.stdout.split("\n"))
        if done.returncode != 0:
            yield f"{at}: does not work\n{fence[3]}{done.stdout}{done.stderr}"
            return
        print(f"{at}: ok", flush=True)


def run_lessons(program):
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        for path in tracked(ROOT):
            (scratch / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / path, scratch / path)
        shutil.copy(ROOT / "trammel", scratch / "launcher")
        (scratch / "trammel").write_text(LAUNCHER)
        tools = f" {' '.join(name for name, _ in gen_manual.script_verbs())} "
        environment = {**os.environ, "PYTHON": sys.executable, "PROGRAM": str(program),
                       "TOOLS": tools, "TRAMMEL_NO_APT": "1"}
        if (ROOT / ".venv").exists():
            (scratch / ".venv").symlink_to((ROOT / ".venv").resolve())
        for page in LESSONS:
            text = page.read_text(encoding="utf-8").partition(BUILDS)[0]
            problems = list(run_blocks(page, text, 1, scratch, environment, LIMIT_S))
            yield from problems
            if problems:
                return
        listed = FILES.read_text(encoding="utf-8")
        for file in sorted(scratch.glob("out/*/*")):
            if file.is_file() and f"`{file.name}`" not in listed:
                yield f"docs/files.md: {file.name}, which a run wrote, is missing"


def main():
    parser = python_tools.Parser(prog="scripts/tool check-docs", description=__doc__)
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel")
    parser.add_argument("--run", action="store_true", help="execute the lessons")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if not program.exists():
        print(f"check-docs: {program}: not built", file=sys.stderr)
        return 3
    if arguments.run:
        problems = list(run_lessons(program))
    else:
        keys = {}  # defaults of every machine that has the key
        for machine in machines.described(program):
            for key in gen_manual.keys_of(program, machine["name"]):
                keys.setdefault(key["key"], []).append(key["default"])
        problems = [*check_links(), *check_files(), *check_defaults(keys),
                    *check_commands(program, keys)]
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0
