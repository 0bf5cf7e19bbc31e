# SPDX-License-Identifier: Apache-2.0
"""What makes a folder of machines/ or examples/ a machine, and where its name may stand.

A name may stand in the machine's own folders, in rtl/ and models/, in generated files and in all
that is not program text (pages, README, CHANGELOG). All other code finds machines by their folders.
In rtl/ a file of a machine is in chips/ or boards/, in models/ in exact/chips/, and only its own
code has its register map. In scripts/ no chip or board of a machine is named either. A machine of
examples/ has all its files in its folder, its chip in rtl/ there and the view of its waves in
view.toml.
"""

import difflib
import re
from pathlib import Path

PROGRAM_TEXT = {".cpp", ".hpp", ".h", ".c", ".S", ".js", ".css", ".html", ".py", ".cmake", ".in",
                ".toml", ".sh", ".vlt"}
PROGRAM_FILES = {"CMakeLists.txt", "CMakePresets.json"}
FREE = {"rtl", "models", "third_party"}
# Companions of machines/<m>/, from the folder that holds machines/.
COMPANIONS = ("machines/{0}/machine.cpp", "machines/{0}/README.md", "sw_nios/apps/{0}/{0}.hpp",
              "sw_nios/apps/{0}/{0}.cpp", "waves/{0}.toml")
INSIDE = ("README.md", "view.toml")  # companions of a machine of examples/, in its folder
CHIPS = Path("rtl/chips")
MODELS_OF_CHIPS = Path("models/exact/chips")
SCRIPTS = "scripts"
KINDS = {".rdl": "register map"}  # else a package or a block
REGISTERS = re.compile(r'#include "rtl/chips/generated/(\w+)_regs\.hpp"')
HAVE_REGISTERS = (("tests",), ("rtl", "chips", "generated"), MODELS_OF_CHIPS.parts)


def machines_of(files):
    return sorted({p.parts[1] for p in files if p.parts[0] == "machines" and len(p.parts) > 2})


def examples_of(files):
    """{machine: folder} of those in examples/, which have a machine.cpp."""
    return {p.parent.name: p.parent for p in sorted(files)
            if p.parts[0] == "examples" and p.name == "machine.cpp"}


def read(root, path):
    return (root / path).read_text(encoding="utf-8")


def is_program(root, path):
    if path.suffix in PROGRAM_TEXT or path.name in PROGRAM_FILES:
        return True
    return not path.suffix and (root / path).read_bytes()[:2] == b"#!"


def is_free(path, machine):
    """Whether a file may name the machine."""
    return (path.parts[0] in FREE or "generated" in path.parts or path.name == "trammel.core"
            or path.parts[:2] == ("machines", machine) or path.parts == ("waves", f"{machine}.toml")
            or path.parts[:3] == ("sw_nios", "apps", machine))


def check_names(root, files, machines):
    """Names of machines in what all of them share."""
    if not machines:
        return
    either = "|".join(map(re.escape, machines))
    word = re.compile(rf"(?<!\w)({either})(?!\w)")
    part = re.compile(rf"(?<![^\W_])({either})(?![^\W_])")  # of a name, between underscores
    for path in sorted(files):
        if all(is_free(path, machine) for machine in machines) or not is_program(root, path):
            continue
        named = part if path.parts[0] == SCRIPTS else word
        for number, line in enumerate(read(root, path).split("\n"), 1):
            for name in dict.fromkeys(named.findall(line)):
                if not is_free(path, name):
                    yield f"{path}:{number}: names the machine {name}"


def owner_of(stem, machines):
    """The machine that a file's name names."""
    return next((machine for machine in machines if f"_{machine}_" in f"_{stem}_"), None)


def check_rooms(root, files, machines):
    """Packages, blocks, register maps and models of a machine in what all of them share."""
    for path in sorted(files):
        if path.parts[0] == "rtl" and path.suffix in (".sv", ".rdl") and len(path.parts) == 3:
            machine = owner_of(path.stem, machines)
            if machine and path.parts[1] not in ("chips", "boards"):
                kind = KINDS.get(path.suffix,
                                 "package" if path.stem.endswith("_pkg") else "block")
                yield (f"{path}: a {kind} of the machine {machine} in a general folder; its place "
                       f"is {CHIPS}/")
        if path.parts[0] == "models" and path.suffix in (".cpp", ".hpp") \
                and path.parent != MODELS_OF_CHIPS:
            machine = owner_of(path.stem, machines)
            if machine:
                yield (f"{path}: a model of the machine {machine} in a general folder; its place "
                       f"is machines/{machine}/ or {MODELS_OF_CHIPS}/")
        if path.suffix in (".hpp", ".cpp") and not any(path.parts[:len(room)] == room
                                                       for room in HAVE_REGISTERS):
            for number, line in enumerate(read(root, path).split("\n"), 1):
                found = REGISTERS.match(line)
                machine = found and owner_of(found[1], machines)
                if machine and not (machine in path.parts[:3] and is_free(path, machine)):
                    yield f"{path}:{number}: uses the register map of the machine {machine}"


def chips_of(root, files, folder):
    """Chips that the chip.cmake of a machine's folder names."""
    path = folder / "chip.cmake"
    text = read(root, path) if path in files else ""
    return re.findall(r"^\s*trammel_chip\(\s*(\w+)", text, re.M)


def has_part(root, files, machine):
    """Whether the machine is made with the chip of a part."""
    used = {Path("parts", part, "chip.cmake") for p in files
            if p.parts[:2] == ("machines", machine) and p.suffix in (".cpp", ".hpp")
            for part in re.findall(r'#include "parts/(\w+)/', read(root, p))}
    return bool(used & files)


def lacks(root, files, folder, what):
    """Whether machine.cpp says that the chip has no `leap` contract or no `twin`."""
    path = folder / "machine.cpp"
    return path in files and re.search(rf"\bcan\.{what} = false;", read(root, path)) is not None


def can_leap(text):
    return re.search(r"\bleap_i\b", text) and re.search(r"\bquiescent_o\b", text)


def chips_in(folder):
    """Where the chip of a machine is."""
    return CHIPS if folder.parts[0] == "machines" else folder / "rtl"


def plain_chips(root, files):
    """Chips without the leap contract, whose machines say so."""
    folders = [Path("machines", machine) for machine in machines_of(files)]
    chips = {chips_in(folder) / f"{chip}.sv" for folder in [*folders, *examples_of(files).values()]
             if lacks(root, files, folder, "leap") for chip in chips_of(root, files, folder)}
    return {path for path in chips & files if not can_leap(read(root, path))}


def check_chips(root, files, folder):
    for chip in chips_of(root, files, folder):
        path = chips_in(folder) / f"{chip}.sv"
        if path not in files:
            yield f"{folder}/chip.cmake: there is no {path}"
            continue
        if not lacks(root, files, folder, "leap") and not can_leap(read(root, path)):
            yield (f"{path}: has no ports leap_i and quiescent_o, and {folder}/machine.cpp does "
                   "not say `can.leap = false;`")
        twin = Path("models", "exact", "chips", f"{chip}.hpp")
        if not lacks(root, files, folder, "twin") and twin not in files:
            yield (f"{path}: companion {twin} is missing, and {folder}/machine.cpp does not say "
                   "`can.twin = false;`")


def check_session(root, files, folder):
    """A session reads its firmware by the mailbox alone, so that a core can execute it."""
    paths = [p for p in sorted(files) if p.is_relative_to(folder)
             and p.relative_to(folder).parts[0] != "tests" and p.stem == "session"]
    texts = {path: read(root, path) for path in paths}
    apps = {name for text in texts.values()
            for name in re.findall(r"^\s*(?:std::unique_ptr<)?(?:\w+::)*\w+App>? (\w+);", text,
                                   re.M)}
    for path, text in texts.items():
        for number, line in enumerate(text.split("\n"), 1):
            for app, member in re.findall(r"\b(\w+)(?:\.|->)(\w+)\(", line):
                if app in apps and member not in ("start", "isr", "mailbox"):
                    yield (f"{path}:{number}: a session calls start(), isr() and mailbox() of its "
                           f"firmware, no {member}()")


def check_machine(root, files, machine):
    """Companions of one folder of machines/."""
    folder = Path("machines", machine)
    for companion in COMPANIONS:
        if Path(companion.format(machine)) not in files:
            yield f"{folder}/: companion {companion.format(machine)} is missing"
    if folder / "chip.cmake" not in files and not has_part(root, files, machine):
        yield f"{folder}/: neither {folder}/chip.cmake nor the chip of a part of parts/"
    yield from check_folder(root, files, folder)


def check_example(root, files, folder):
    """Companions of a machine in examples/."""
    for companion in INSIDE:
        if folder / companion not in files:
            yield f"{folder}/: companion {folder / companion} is missing"
    if not chips_of(root, files, folder):
        yield f"{folder}/: {folder}/chip.cmake names no chip"
    yield from check_folder(root, files, folder)


def check_folder(root, files, folder):
    """What each machine has in its folder."""
    inside = [p.relative_to(folder) for p in files if p.is_relative_to(folder)]
    if not any(p.parts[0] == "scenarios" and p.suffix == ".toml" for p in inside):
        yield f"{folder}/: no scenario in {folder}/scenarios/"
    if not any(p.parts[0] == "tests" for p in inside):
        yield f"{folder}/: no test in {folder}/tests/"
    yield from check_chips(root, files, folder)
    yield from check_session(root, files, folder)


def check_strays(files, machines):
    """Firmware and views of no machine."""
    apps = {(Path(*p.parts[:3]), p.parts[2]) for p in files
            if p.parts[:2] == ("sw_nios", "apps") and len(p.parts) > 3}
    views = {(p, p.stem) for p in files if p.parts[0] == "waves" and p.suffix == ".toml"}
    for path, name in sorted(apps | views):
        if name not in machines:
            near = difflib.get_close_matches(name, machines, 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            yield f"{path}: there is no machines/{name}/{hint}"


def check(root, files):
    machines = machines_of(files)
    for machine in machines:
        yield from check_machine(root, files, machine)
    for folder in examples_of(files).values():
        if folder.name in machines:
            yield f"{folder}/: machines/{folder.name}/ is a machine of that name too"
        yield from check_example(root, files, folder)
    yield from check_strays(files, machines)
    yield from check_names(root, files, machines)
    yield from check_rooms(root, files, machines)
