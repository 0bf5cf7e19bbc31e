# SPDX-License-Identifier: Apache-2.0
"""A kept result: a small text file that covers itself with a hash."""

import contextlib
import dataclasses
import hashlib
import os
import tempfile
import tomllib
from pathlib import Path

from trammel_tools.paths import ROOT

KEPT = ROOT / "evidence"
HEAD = "A kept result, written by scripts/tool evidence. Its last line covers every byte of it."
FIELDS = ("check", "made", "commit", "command", "with", "inputs")  # in this order
OPTIONAL = {"commit"}


def path_of(name):
    return KEPT / f"{name}.txt"


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def content(name):
    """Of a file below the repository's root; of FILE#KEY, the values of a key in the tables of a
    TOML file, or all of a file that is no TOML."""
    path, _, key = name.partition("#")
    text = (ROOT / path).read_bytes()
    if key:
        with contextlib.suppress(ValueError, AttributeError):
            tables = tomllib.loads(text.decode())
            return repr([(table, values.get(key)) for table, values in tables.items()]).encode()
    return text


def digest_of(files):
    """One hash of the names and contents of these files."""
    whole = hashlib.sha256()
    for name in sorted(files):
        whole.update(f"{name}\0{hashlib.sha256(content(name)).hexdigest()}\n".encode())
    return f"{len(files)} files, sha256 {whole.hexdigest()}"


class Damaged(Exception):
    """A file that is no whole record; one line that says why."""


@dataclasses.dataclass(frozen=True)
class Record:
    check: str
    made: str     # date
    command: str
    tools: str
    inputs: str
    result: str   # lines that the command printed
    commit: str = ""  # of a whole campaign: at which it was made, or last found to hold

    def text(self):
        values = (self.check, self.made, self.commit, self.command, self.tools, self.inputs)
        head = "".join(f"{name:<9}{value}\n" for name, value in zip(FIELDS, values)
                       if value or name not in OPTIONAL)
        body = f"{HEAD}\n\n{head}\n{self.result}"
        return f"{body}\nsha256   {digest(body)}\n"


def parse(text):
    body, mark, last = text.rpartition("\nsha256   ")
    if not mark or not last.endswith("\n"):
        raise Damaged("its last line, the hash, is missing")
    if last != f"{digest(body)}\n":
        raise Damaged("its hash is not that of its text")
    head, _, result = body.partition("\n\n")[2].partition("\n\n")
    found = {line[:9].strip(): line[9:] for line in head.split("\n")}
    if list(found) != [name for name in FIELDS if name in found or name not in OPTIONAL]:
        raise Damaged(f"its head has not the lines {', '.join(FIELDS)}")
    commit = found.pop("commit", "")
    return Record(*found.values(), result, commit)


def read(name):
    """The record of a check, or None where there is none."""
    try:
        return parse(path_of(name).read_bytes().decode())  # each line end as it is
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        raise Damaged(f"it cannot be read: {error}") from None


def write(record):
    """All of it or nothing."""
    KEPT.mkdir(exist_ok=True)
    handle, scratch = tempfile.mkstemp(prefix=".new-", dir=KEPT)
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(record.text())
        Path(scratch).chmod(0o644)
        os.replace(scratch, path_of(record.check))
    except BaseException:
        Path(scratch).unlink(missing_ok=True)
        raise
