#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check what the documentation says against the program.

usage: check_docs.py [--program FILE]                    links, commands, defaults, files of a run
       check_docs.py [--program FILE] --run CATCH_MAIN   executes quickstart and tutorial

Links lead to files and headings that exist. In every code block, a line that begins with ./trammel
names a verb, options, keys and scenarios that exist. `section.key = value` in the text is the
default. files.md names every file a run can write.

--run copies the repository to a scratch folder and there, in order, executes the blocks marked sh
and applies those marked diff; "# exit code N" at the end of a line is what that line must end with;
a block after "<!-- not run: reason -->" is left out. The lines of a block marked text must have
been printed by the blocks before it. The launcher is replaced by one that installs nothing and
builds a block's unit test directly, with the library CATCH_MAIN of the build.

Exit codes: 0 ok, 1 something is wrong, 3 the program is not built.
"""

import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import gen_manual
from check_layout import tracked

ROOT = Path(__file__).resolve().parent.parent
FILES = ROOT / "docs" / "files.md"
LESSONS = (ROOT / "docs" / "quickstart.md", ROOT / "docs" / "tutorial.md")
LIMIT_S = 300  # of one block
FENCE = re.compile(r"^(<!-- not run: [^\n]*-->\n)?```(\w*)\n(.*?)^```$", re.M | re.S)

LAUNCHER = r"""#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
set -euo pipefail
optional() { "$@" || { code=$?; [ $code = 3 ] || [ $code = 77 ] || exit $code; }; }
tool() { optional "$PYTHON" "scripts/$1.py" "${@:2}"; }
case $1 in
  test)
    IFS=. read -r -a part <<< "$3"
    layer=${part[-2]} block=${part[-1]} obj=build/${part[-1]}
    mkdir -p build
    verilator --cc --exe --build -Wno-fatal --prefix "V$block" --top-module "$block" \
      --Mdir "$obj" -CFLAGS "-O0 -std=c++17 -I$PWD" rtl/pkg/*_pkg.sv rtl/math/math_pkg.sv \
      "rtl/$layer/$block.sv" "$PWD/tests/$layer/${block}_test.cpp" "$CATCH_MAIN" > /dev/null
    "$obj/V$block" || exit 1
    if [ "${part[0]}" != unit ]; then
      tool lint "$layer/$block"
      tool prove "$layer/$block"
    fi
    ;;
  *)
    if [[ $TOOLS == *" $1 "* ]]; then tool "$@"; else exec "$PROGRAM" "$@"; fi
    ;;
esac
"""


def pages():
    return [ROOT / p for p in tracked(ROOT) if p.suffix == ".md"]


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
    source = (ROOT / "testbench" / "output.cpp").read_text(encoding="utf-8")
    names = re.findall(r'"([^"]+)"', re.search(r"kOwnFiles\[\] = \{(.*?)\};", source, re.S)[1])
    listed = FILES.read_text(encoding="utf-8")
    for name in names:
        if f"`{name}`" not in listed:
            yield f"docs/files.md: {name}, which a run can write, is missing"


def check_commands(program, keys):
    own = {name: gen_manual.said(program, name, "--help")
           for name, _ in gen_manual.program_verbs(program)}
    general = gen_manual.said(program, "--help")
    scripts = {name for name, _ in gen_manual.script_verbs()} | {"test"}
    axis_free = {re.sub(r"\.[xy]\.", ".", key) for key in keys} | set(keys)
    scenarios = {path.stem for path in (ROOT / "testbench" / "scenarios").glob("*.toml")}
    for page in pages():
        text = page.read_text(encoding="utf-8")
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
    """A block for bash: every line must succeed but those that say how they fail."""
    lines = ["set -eu"]
    for line in block.split("\n"):
        code = re.search(r"\s+# exit code (\d+)", line)
        if code:
            line = (f"got=0; {line[:code.start()]} || got=$?; "
                    f"[ $got = {code[1]} ] || {{ echo 'ended with '$got >&2; exit 1; }}")
        lines.append(line)
    return "\n".join(lines)


def run_lessons(program, catch_main):
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        for path in tracked(ROOT):
            (scratch / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / path, scratch / path)
        (scratch / "trammel").write_text(LAUNCHER)
        tools = f" {' '.join(name for name, _ in gen_manual.script_verbs())} "
        environment = {**os.environ, "PYTHON": sys.executable, "PROGRAM": str(program),
                       "CATCH_MAIN": str(catch_main), "TOOLS": tools}
        if (ROOT / ".venv").exists():
            (scratch / ".venv").symlink_to((ROOT / ".venv").resolve())
        for page in LESSONS:
            text, printed = page.read_text(encoding="utf-8"), set()
            for fence in FENCE.finditer(text):
                at = f"{page.relative_to(ROOT)}:{line_of(text, fence.start())}"
                if fence[2] == "text":
                    for line in set(fence[3].rstrip().split("\n")) - printed - {""}:
                        yield f"{at}: was not printed: {line}"
                if fence[1] or fence[2] not in ("sh", "diff"):
                    continue
                command = ["git", "apply", "--recount", "-"] if fence[2] == "diff" else ["bash"]
                content = fence[3] if fence[2] == "diff" else script_of(fence[3])
                done = subprocess.run(command, input=content, capture_output=True, text=True,
                                      check=False, cwd=scratch, env=environment,
                                      timeout=LIMIT_S)
                printed |= set(done.stdout.split("\n"))
                if done.returncode != 0:
                    yield f"{at}: does not work\n{fence[3]}{done.stdout}{done.stderr}"
                    return
                print(f"{at}: ok", flush=True)
        listed = FILES.read_text(encoding="utf-8")
        for file in sorted(scratch.glob("out/*/*")):
            if file.is_file() and f"`{file.name}`" not in listed:
                yield f"docs/files.md: {file.name}, which a run wrote, is missing"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, metavar="FILE",
                        default=ROOT / "build" / "testbench" / "trammel")
    parser.add_argument("--run", type=Path, metavar="CATCH_MAIN")
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    if not program.exists():
        print(f"check_docs: {program}: not built", file=sys.stderr)
        return 3
    if arguments.run:
        problems = list(run_lessons(program, arguments.run.resolve()))
    else:
        keys = {}  # defaults of every machine that has the key
        for machine in ("kung", "an693", "mcafee"):
            for key in gen_manual.keys_of(program, machine):
                keys.setdefault(key["key"], []).append(key["default"])
        problems = [*check_links(), *check_files(), *check_defaults(keys),
                    *check_commands(program, keys)]
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
