# SPDX-License-Identifier: Apache-2.0
"""Which folder of the C++ code may include what: of the repository and of libraries."""

import re

from trammel_tools.check.layout_links import circles
from trammel_tools.check.rooms import ROOMS

FOLDERS = tuple(f"{one}/" for one in (*ROOMS, "rtl", "examples", "python", "tests"))
FIRMWARE = ["sw_nios/hal/", "sw_nios/path/"]
LOOP = ["cosim/", "models/", *FIRMWARE, "rtl/chips/generated/"]
TABLE = "machines/table.hpp"  # of the machines that a program is linked with
MACHINE = ["parts/", "lab/", "paths/", "host/", *LOOP]  # and its own folders; a part too
# Folder of a C++ file -> prefixes of the repository's headers that it may include.
USES = {
    "host": ["host/"],
    "models/fixed": ["models/fixed/"],
    "models/pins": ["models/pins/"],
    "models/exact": ["models/exact/", "models/fixed/", "models/pins/"],
    "models/ideal": ["models/ideal/"],
    "models/plant": ["models/plant/", "models/fixed/", "models/pins/"],
    "sw_nios": [*FIRMWARE, "models/fixed/"],
    "paths": ["paths/", "host/", "models/ideal/"],
    "cosim": LOOP,
    "systemc": ["systemc/", *LOOP],
    "lab": ["lab/", "systemc/", "cosim/", "host/"],
    "parts": MACHINE,
    "testbench": ["testbench/", "lab/", "cosim/", "host/", TABLE],
    "examples": ["lab/", "cosim/", "host/", TABLE],
    "python": ["python/", "lab/", "cosim/", "host/", TABLE],
    "tests": [*FOLDERS, "support/"],
}
# Register maps, which all of them may have; and signals of a chip by their place in its model.
REGISTERS = re.compile(r"rtl/chips/generated/\w+_regs\.hpp")
SIGNALS = re.compile(r"rtl/chips/generated/\w+_signals\.hpp")
# Headers that Verilator has or writes, and ours that include them.
VERILATED = re.compile(r"verilated\w*\.h|V\w+\.h|\w+_(registers|traced)\.hpp|.*/verilated/.*")
# Headers of other libraries that only some folders may see.
LIBRARIES = {"systemc": ("systemc", "tests"),
             "Eigen/": ("models/plant", "models/ideal", "tests")}


def place_of(path):
    """(folder as USES or a reader calls it, prefixes it may include) of a file; or (None, [])."""
    first, second = path.parts[:2]
    if first == "machines" and len(path.parts) > 2:
        own = [f"machines/{second}/", f"sw_nios/apps/{second}/"]
        inner = path.parts[2]
        if inner == "tests":
            return "tests", [*own, *MACHINE, "testbench/", "tests/"]
        return f"{first}/{second}", [*own, *MACHINE, *(["testbench/"] * (inner == "verbs"))]
    if first == "examples" and len(path.parts) > 2:  # a machine, whose firmware is there too
        own = [f"examples/{second}/"]
        if "tests" in path.parts:
            return "tests", [*own, *MACHINE, "testbench/", "tests/"]
        return f"{first}/{second}", [*own, *MACHINE, *(["testbench/"] * ("verbs" in path.parts))]
    if path.parts[:2] == ("sw_nios", "apps"):
        app = "/".join(path.parts[:3])
        return app, [*USES["sw_nios"], f"{app}/"]
    if first == "parts" and path.parts[2:3] == ("driver",):  # for other hosts: it stands alone
        return f"{first}/{second}/driver", []
    two = f"{first}/{second}"
    folder = two if two in USES else first
    return (folder, USES[folder]) if folder in USES else (None, [])


def is_forbidden(path, folder, allowed, name):
    if name.startswith(FOLDERS) and not REGISTERS.fullmatch(name) and (
            not name.startswith(tuple(allowed))):
        return True
    sees_models = folder == "tests" or path.parent.name == "verilated"
    if (VERILATED.fullmatch(name) or SIGNALS.fullmatch(name)) and not sees_models:
        return True
    if SIGNALS.fullmatch(name) and path.parts[0] not in ("machines", "examples", "parts"):
        return True
    return any(name.startswith(library) and not name.startswith(FOLDERS) and folder not in users
               for library, users in LIBRARIES.items())


def includes(root, path):
    """(line, name) of what a file includes."""
    for number, line in enumerate((root / path).read_text(encoding="utf-8").split("\n"), 1):
        if found := re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line):
            yield number, found[1]


def check_circles(root, paths):
    """A header that includes itself, by others."""
    links = {str(path): [name for _, name in includes(root, path)] for path in paths}
    for circle in circles({name: [one for one in more if one in links]
                           for name, more in links.items()}):
        yield f"{circle[0]}: includes itself: {' -> '.join(circle)}"


def place_in_machine(name):
    """The folder of a machine in which a file is, or the file itself beside these; "" of others."""
    parts = name.split("/")
    if parts[0] != "machines" or len(parts) < 3 or parts[2] == "tests":
        return ""
    return "/".join(parts[:3])


def check_folders(root, paths):
    """Folders of a machine that include each other."""
    links = {place_in_machine(str(path)): set() for path in paths}
    for path in paths:
        own = place_in_machine(str(path))
        links[own] |= {place_in_machine(name) for _, name in includes(root, path)} - {own}
    links.pop("", None)
    for circle in circles({own: sorted(more & links.keys()) for own, more in links.items()}):
        yield f"{circle[0]}: folders include each other: {' -> '.join(circle)}"


def check(root, path):
    folder, allowed = place_of(path) if len(path.parts) > 1 else (None, [])
    if folder is None:
        return
    for number, name in includes(root, path):
        if is_forbidden(path, folder, allowed, name):
            yield f"{path}:{number}: {folder} may not include {name}"
        elif folder == "models/exact" and name in ("cmath", "math.h"):
            yield f"{path}:{number}: {folder} holds integers only, no {name}"
