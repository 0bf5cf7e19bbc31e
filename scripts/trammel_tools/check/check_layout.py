# SPDX-License-Identifier: Apache-2.0
"""Check the layout of the repository: companions, pages, layers, form of the files.

usage: scripts/tool check-layout [root]     prints file:line: what is wrong; exit 1 if anything is

Every block has its companions (properties if it has registers, broken designs if it is a chip that
leaps) and its page (opening table, every port); every machine has its own (firmware, view of the
waves, scenarios, tests); no program text outside a machine's folders names it, no package, register
map or script of a general folder belongs to it; layers use only those below, and so do the links of
the build, where it is configured; neither goes in a circle, nor do the includes between a machine's
folders; files are ASCII, of 100 columns and 400 lines, with a licence line and a newline at the
end.

The rules are about kinds of files, not names: packages share one page, twin and test in their
layer; chips have no twin of their own (their blocks have) and are tested as machines; a chip whose
machine says that it has no leap contract needs no properties; generated and third-party files are
exempt.
"""

import fnmatch
import re
import subprocess
import sys
from pathlib import Path

from trammel_tools.check import layout_links, layout_machines, layout_uses
from trammel_tools.paths import ROOT, block_of

MIDDLE = {"sense", "drive", "control", "motion", "bus"}
# Layer of rtl/ -> layers whose modules and packages it may use besides its own.
RTL_USES = {"pkg": set(), "math": {"pkg"}, **{m: {"pkg", "math"} for m in MIDDLE},
            "chips": {"pkg", "math", "chips"} | MIDDLE,
            "boards": {"pkg", "math", "chips"} | MIDDLE}
CODE = {".sv", ".hpp", ".cpp", ".h", ".c", ".py", ".cmake", ".rdl", ".vlt", ".js", ".css",
        ".html", ""}
CPP = (".hpp", ".cpp", ".h", ".c")
TEXT = CODE | {".md", ".toml", ".txt", ".json", ".in"}
NO_LICENCE = {".md", ".toml", ".txt", ".json"}
# Opening table of a block's page; more rows may follow.
PAGE_ROWS = ["Shape", "Latency", "Source", "Twin", "Properties"]
MAX_LINES = 400
GENERATED = "<!-- Generated from "  # a table of docs/
MAX_COLUMNS = 100


def tracked(root):
    """Files git knows or would add; without git, all files outside build folders."""
    listing = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard"],
                             capture_output=True, text=True, check=False)
    if listing.returncode == 0:
        return sorted(Path(p) for p in set(listing.stdout.split("\n")) if (root / p).is_file())
    skip = {".git", "build", "out", ".venv"}
    return sorted(p.relative_to(root) for p in root.rglob("*")
                  if p.is_file() and not skip & set(p.relative_to(root).parts))


def is_exempt(path):
    """Of what no one writes here: kept results are generated too."""
    return (bool({"generated", "third_party"} & set(path.parts)) or path.parts[0] == "evidence"
            or path.name == "LICENSE")


def check_form(root, path):
    try:
        text = (root / path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return
    lines = text.split("\n")
    if text and not text.endswith("\n"):
        yield f"{path}:{len(lines)}: no newline at the end"
    if len(lines) - 1 > MAX_LINES and not text.startswith(GENERATED):  # it grows by machine
        yield f"{path}: {len(lines) - 1} lines, more than {MAX_LINES}: two files"
    for number, line in enumerate(lines, 1):
        if not line.isascii():
            yield f"{path}:{number}: not ASCII"
        if "\t" in line and path.name != "Makefile":
            yield f"{path}:{number}: tab"
        # The changed text of a negative control is one line, see trammel prove.
        wide = len(line) > MAX_COLUMNS and not line.lstrip().startswith("// breaks ")
        if wide and path.suffix not in (".txt", ".json", ".md"):
            yield f"{path}:{number}: {len(line)} columns, more than {MAX_COLUMNS}"
    needs = path.suffix in CODE - NO_LICENCE - {".cmake"}
    if needs and (path.suffix or text.startswith("#!")) and not any(
            "SPDX-License-Identifier: Apache-2.0" in line for line in lines[:3]):
        yield f"{path}:1: no line SPDX-License-Identifier: Apache-2.0"


def layer_of(path):
    """The layer of an RTL file: a folder of rtl/, or chips for one in a machine of examples/;
    "" of other files."""
    if path.suffix == ".sv" and path.parts[0] == "rtl" and len(path.parts) == 3:
        return path.parts[1]
    own = path.suffix == ".sv" and path.parts[0] == "examples" and path.parent.name == "rtl"
    return "chips" if own else ""


def check_companions(root, files, plain, path):
    layer, stem = layer_of(path), path.stem
    if stem.endswith("_props"):
        if path.with_name(stem.removesuffix("_props") + ".sv") not in files:
            yield f"{path}: properties of no block"
        return
    if stem.endswith("_pkg") or layer == "boards":
        return
    wanted = [path.with_suffix(".md")]
    if layer != "chips":
        wanted.append(Path("tests", layer, f"{stem}_test.cpp"))
        if layer != "bus":
            wanted.append(Path("models", "exact", layer, f"{stem}.hpp"))
    text = (root / path).read_text(encoding="utf-8")
    if "always_ff" in text and path not in plain:
        wanted.append(path.with_name(f"{stem}_props.sv"))
    if layer == "chips" and "leap_i" in ports(text) and not is_inside(root, files, stem):
        wanted.append(path.with_name(f"{stem}_leap.toml"))
    for companion in wanted:
        if companion not in files:
            yield f"{path}: companion {companion} is missing"


def is_inside(root, files, stem):
    """Whether a chip that leaps contains this module."""
    texts = [(root / p).read_text("utf-8") for p in files
             if p.parts[:2] == ("rtl", "chips") and p.suffix == ".sv"]
    return any("leap_i" in ports(text) and
               re.search(rf"^\s*{stem}\s+(#|u_\w+\s*\()", text, re.M) for text in texts)


def check_page(root, path, files):
    """The page of a block: title, opening table, every port, its properties."""
    page = path.with_suffix(".md")
    if page not in files or path.stem.endswith(("_pkg", "_props")) or path.parts[1] == "boards":
        return
    text = (root / page).read_text(encoding="utf-8")
    title = f"# {block_of(path)}"
    if not text.startswith(f"{title}\n"):
        yield f"{page}:1: first line is not '{title}'"
    rows = re.findall(r"^\| (\w+) \|", text.partition("\n| |")[2].partition("\n\n")[0], re.M)
    if rows[:len(PAGE_ROWS)] != PAGE_ROWS:
        yield f"{page}: does not open with a table of {', '.join(PAGE_ROWS)}"
    props = f"{path.stem}_props.sv"
    if path.with_name(props) in files and props not in text:
        yield f"{page}: does not name {props}"
    named = {re.sub(r"\[.*", "", word) for code in re.findall(r"`([^`\n]+)`", text)
             for word in re.split(r"[\s,]+", code)}
    for port in ports((root / path).read_text(encoding="utf-8")):
        if not any(fnmatch.fnmatchcase(port, name) for name in named):
            yield f"{page}: port {port} of the module is missing"


def ports(text):
    """Ports of a module's header, one a line, without clock and reset."""
    found = re.findall(r"^\s*(?:input|output|inout)\s[^/\n]*?(\w+)\s*(?:,|//|\)|$)", text, re.M)
    return [port for port in found if port not in ("clk_i", "rst_i", "clk", "rst")]


def check_rtl_uses(root, path, owner):
    layer = layer_of(path)
    allowed = RTL_USES.get(layer, set()) | {layer}
    text = (root / path).read_text(encoding="utf-8")
    for number, line in enumerate(text.split("\n"), 1):
        code = line.split("//")[0]
        names = re.findall(r"\b(\w+)::", code)
        # An instance: the module's name, then parameters or u_name.
        names += re.findall(r"^\s*(\w+)\s+(?:#\s*\(|u_\w+\s*\()", code)
        names += re.findall(r"^\s*bind\s+(\w+)", code)
        for name in names:
            if name in owner and owner[name] not in allowed:
                yield f"{path}:{number}: {layer} may not use {name} of {owner[name]}"
    if not path.stem.endswith("_pkg"):
        named = re.findall(r"^\s*(?:module|interface)\s+(\w+)", text, re.M)
        if path.stem not in named:
            yield f"{path}: no module {path.stem}"


def findings(root):
    files = set(tracked(root))
    plain = layout_machines.plain_chips(root, files)
    owner = {p.stem: p.parts[1] for p in files if p.parts[0] == "rtl" and p.suffix == ".sv"}
    for path in sorted(files):
        if is_exempt(path):
            continue
        if path.suffix in TEXT:
            yield from check_form(root, path)
        if layer_of(path):
            yield from check_companions(root, files, plain, path)
            yield from check_page(root, path, files)
            yield from check_rtl_uses(root, path, owner)
        if path.suffix in CPP:
            yield from layout_uses.check(root, path)
    code = sorted(p for p in files if p.suffix in CPP)
    yield from layout_uses.check_circles(root, code)
    yield from layout_uses.check_folders(root, code)
    yield from layout_machines.check(root, files)
    yield from layout_links.check(root)


def main():
    if any(a in ("-h", "--help") for a in sys.argv[1:]):
        print(__doc__)
        return 0
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    problems = list(findings(root))
    for problem in problems:
        print(problem)
    print(f"layout: {len(problems)} problem(s)", file=sys.stderr)
    return 1 if problems else 0
