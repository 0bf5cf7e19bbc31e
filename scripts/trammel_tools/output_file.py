# SPDX-License-Identifier: Apache-2.0
"""Files that the user names, written as `trammel report -o` writes its page (docs/files.md).

Only a regular file is replaced, by one that is whole, and none that belongs to a run's record.
"""

import contextlib
import json
import os
import shutil
import stat
import tempfile
from pathlib import Path

IDENTITY = "run.json"
PAGE = "report.html"  # made again at any time
# Of a record without a list, as in host/output_folder.cpp.
RECORD = {"detail.json", "metrics.json", "run.toml", "script.lm628", "trace.csv", "waves.fst",
          "waves.gtkw", "waves.vcd"}


class Refused(Exception):
    """The user's mistake, in one line."""


def unwritable(path, why):
    return Refused(f"{path}: cannot be written: {why}")


def is_there(path):
    """Whether the name is taken, be it by a link that leads nowhere."""
    try:
        os.lstat(path)
    except FileNotFoundError:
        return False
    except OSError as error:
        raise unwritable(path, error.strerror) from None
    return True


def files_of(folder):
    """Names of the files that the run in a folder wrote; None where no list of them is there."""
    identity = folder / IDENTITY
    try:
        if not stat.S_ISREG(identity.stat().st_mode):
            return None
        document = json.loads(identity.read_bytes())
    except FileNotFoundError:
        return None
    except OSError as error:
        raise Refused(f"{identity}: cannot be read: {error.strerror}") from None
    except (ValueError, RecursionError):
        return None
    good = isinstance(document, dict) and "trammel" in document \
        and isinstance(document.get("files"), dict)
    return document["files"] if good else None


def check(path):
    """Raises where no file may be put or replaced."""
    path = Path(path)
    folder = path.absolute().parent
    try:
        if not stat.S_ISDIR(folder.stat().st_mode):
            raise unwritable(path, f"{folder} is not a folder")
    except OSError as error:
        raise unwritable(path, error.strerror) from None
    there = is_there(path)
    if there and not stat.S_ISREG(path.lstat().st_mode):
        raise unwritable(path, "not a regular file")
    listed = files_of(folder)
    if path.name != PAGE and (there and path.name in RECORD if listed is None else
                              path.name == IDENTITY or path.name in listed):
        raise Refused(f"{path}: is a file of a run's record")


@contextlib.contextmanager
def replacing(path):
    """A name in a new folder beside `path`; the file that is put there then takes that place."""
    path = Path(path)
    check(path)
    scratch = None
    try:
        scratch = Path(tempfile.mkdtemp(prefix=".new-", dir=path.absolute().parent))
        yield scratch / path.name
        os.replace(scratch / path.name, path)
    except OSError as error:
        raise unwritable(path, error.strerror) from None
    finally:
        if scratch:
            shutil.rmtree(scratch, ignore_errors=True)


def replace(path, text):
    with replacing(path) as scratch:
        scratch.write_text(text, encoding="utf-8")


def create(root, texts):
    """Writes files {path below root: text} that are not there yet: all of them, or none."""
    for path in texts:
        if is_there(root / path):
            raise Refused(f"{path} exists")
    made = []
    try:
        for path, text in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            with (root / path).open("x", encoding="utf-8") as file:  # follows no link
                made.append(path)
                file.write(text)
    except OSError as error:
        for one in made:
            (root / one).unlink(missing_ok=True)
        raise unwritable(path, error.strerror) from None
