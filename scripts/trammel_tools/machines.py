# SPDX-License-Identifier: Apache-2.0
"""The machines, found by their folders, and what their files tell the tools.

A table of a tool may be in several files: the shared one, NAME in the folder of a machine, and
parts/<p>/NAME.
"""

import importlib.util
import json
import subprocess
import tomllib

from trammel_tools.paths import ROOT, machine_folders


class MachineError(Exception):
    """A file of a machine that cannot be used, or the program does not say what it has."""


def folders():
    """Folder of each machine, by its name."""
    try:
        return machine_folders(ROOT)
    except ValueError as error:
        raise MachineError(str(error)) from error


def scenarios():
    """{scenario: machine}."""
    return {path.stem: name for name, folder in folders().items()
            for path in sorted(folder.glob("scenarios/*.toml"))}


def listed(program, *topic, environment=None):
    """What `trammel list TOPIC` says, in the program's order."""
    done = subprocess.run([program, "list", *topic, "--json"], capture_output=True, text=True,
                          check=False, env=environment)
    if done.returncode != 0:
        raise MachineError(f"{program} list {' '.join(topic)}: exit {done.returncode}: "
                           f"{done.stderr.strip()}")
    return json.loads(done.stdout)


def described(program):
    """What `trammel list machines` says, in the program's order."""
    return listed(program, "machines")


def fault_kinds(program, machine, environment=None):
    """The faults that a machine can have, as its key inject.fault offers them."""
    keys = listed(program, "keys", machine, environment=environment)
    ranges = (one["range"] for one in keys if one["key"] == "inject.fault")
    return next(ranges, "").removeprefix("one of ").split(", ")[1:]


def read(path):
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        raise MachineError(f"{path.relative_to(ROOT)}: {error}") from error


def merge(into, more, path):
    """Adds a table to another; a value that both have is an error, lists are joined."""
    for key, value in more.items():
        if isinstance(value, dict):
            merge(into.setdefault(key, {}), value, path)
        elif isinstance(value, list):
            into[key] = into.get(key, []) + value
        elif key in into:
            raise MachineError(f"{path.relative_to(ROOT)}: {key} is in another file too")
        else:
            into[key] = value


def tables(name, shared=None):
    """The shared file and those of this name in folders of machines and parts as one table."""
    whole = {}
    for path in [*([shared] if shared else []),
                 *sorted([*(one / name for one in folders().values() if (one / name).exists()),
                          *ROOT.glob(f"parts/*/{name}")])]:
        merge(whole, read(path), path)
    return whole


def runs(name):
    """tests/runs.toml of a machine: what tests that all machines share run of this one."""
    folder = folders().get(name)
    path = folder and folder / "tests" / "runs.toml"
    return read(path) if path and path.exists() else {}


def modules(name):
    """{machine: module} of the files tests/NAME.py in folders of machines."""
    found = {}
    for machine, folder in folders().items():
        path = folder / "tests" / f"{name}.py"
        if path.exists():
            spec = importlib.util.spec_from_file_location(f"{machine}_{name}", path)
            found[machine] = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(found[machine])
    return found
