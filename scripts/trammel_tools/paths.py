# SPDX-License-Identifier: Apache-2.0
"""Where the repository is."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl"
TOOL = ROOT / "scripts" / "tool"
CATCH_MAIN = ROOT / "build" / "tests" / "libtrammel_catch_main.a"  # with Catch2's main

MACHINES = ("machines/*/machine.cpp", "examples/**/machine.cpp")


def machine_folders(root):
    """Folder of each machine, by its name. Raises where two have one name."""
    found = {}
    for path in sorted(one for pattern in MACHINES for one in root.glob(pattern)):
        folder = path.parent
        if other := found.get(folder.name):
            raise ValueError(f"{folder.relative_to(root)}/machine.cpp: {other.relative_to(root)}/ "
                             "is a machine of that name too; rename one of the folders")
        found[folder.name] = folder
    return found


def rtl_layers():
    """{layer: folder} of all blocks: the folders of rtl/, and rtl/ in the folder of a machine,
    whose layer has the machine's name."""
    shared = {path.name: path for path in sorted(RTL.iterdir()) if path.is_dir()}
    return shared | {name: folder / "rtl" for name, folder in machine_folders(ROOT).items()
                     if (folder / "rtl").is_dir()}


def rtl_files(pattern):
    """Files of all layers but boards, in their order: rtl_files("*_props.sv")."""
    return [path for layer, folder in rtl_layers().items() if layer != "boards"
            for path in sorted(folder.glob(pattern))]


def block_of(path):
    """layer/stem of a file of a layer."""
    own = path.parent.name == "rtl"  # in the folder of a machine
    return f"{(path.parent.parent if own else path.parent).name}/{path.stem}"


def block_file(block, ending):
    """The file of a block, layer/stem: block_file("drive/pwm", "_props.sv")."""
    layer, _, stem = block.partition("/")
    return rtl_layers().get(layer, RTL / layer) / f"{stem}{ending}"


def rtl_search():
    """Options by which Verilator finds the modules of all layers."""
    return [f"-I{folder}" for layer, folder in rtl_layers().items() if layer != "boards"]


def twin_sources(top):
    """C++ sources that a unit test of this module needs: the twins of most are headers alone."""
    return sorted(ROOT.glob(f"models/exact/chips/{top}*.cpp"))
