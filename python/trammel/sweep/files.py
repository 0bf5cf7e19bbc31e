# SPDX-License-Identifier: Apache-2.0
"""Files of plans and of their folders. Others may have put links, pipes or devices in their places:
those are refused, and nothing is read or written through them."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import stat
from pathlib import Path

from trammel import _core

MOST_RECORD = 64 << 20  # bytes


class PlanError(_core.ConfigError):
    """What is wrong with a plan, in one line."""


def opened(file: Path, flags: int) -> int:
    """The descriptor of a regular file; nothing is waited for. A link is one only without
    O_NOFOLLOW."""
    try:
        found = os.open(file, flags | os.O_NONBLOCK | os.O_CLOEXEC, 0o666)
    except OSError as error:
        if error.errno in (errno.ELOOP, errno.EISDIR, errno.ENXIO):
            raise PlanError(f"{file}: not a regular file") from None
        raise
    if not stat.S_ISREG(os.fstat(found).st_mode):
        os.close(found)
        raise PlanError(f"{file}: not a regular file")
    return found


def read(file: Path, most: int, flags: int = os.O_NOFOLLOW) -> bytes:
    """What a file holds: of one that is longer, a byte more than `most`."""
    with open(opened(file, os.O_RDONLY | flags), "rb") as stream:
        return stream.read(most + 1)


def read_json(file: Path) -> dict | None:
    """The object in a file of a folder; None where there is no such file."""
    try:
        text = read(file, MOST_RECORD)
    except FileNotFoundError:
        return None
    found = None
    if len(text) <= MOST_RECORD:
        with contextlib.suppress(ValueError, RecursionError):
            found = json.loads(text.decode())
    if not isinstance(found, dict):
        raise PlanError(f"{file}: is corrupt")
    return found


def _mode(path: Path) -> int | None:
    try:
        return path.lstat().st_mode
    except FileNotFoundError:
        return None


def check_replaceable(file: Path) -> None:
    """A PlanError where replace() would refuse."""
    mode = _mode(file)
    if mode is not None and not stat.S_ISREG(mode):
        raise PlanError(f"{file}: cannot be written: not a regular file")


def replace(file: Path, data: bytes) -> None:
    """The file is there whole, or as it was before."""
    check_replaceable(file)
    try:
        _core.replace_file(os.fsencode(file), bytes(data))
    except OSError as error:
        error.filename = str(file)
        raise


def check_folder(folder: Path) -> None:
    """A PlanError where there is something else, a link too."""
    mode = _mode(folder)
    if mode is not None and not stat.S_ISDIR(mode):
        raise PlanError(f"{folder}: is not a folder")


def inside(folder: Path, pattern: str) -> list[Path]:
    """Regular files of a folder that fit a pattern, by name."""
    check_folder(folder)
    found = sorted(folder.glob(pattern))
    for file in found:
        if not stat.S_ISREG(_mode(file) or stat.S_IFREG):
            raise PlanError(f"{file}: not a regular file")
    return found
