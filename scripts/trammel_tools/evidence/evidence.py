# SPDX-License-Identifier: Apache-2.0
"""Run a check, unless its kept result still holds.

usage: scripts/tool evidence NAME -- COMMAND ...   what a test of the full tier calls
       scripts/tool evidence --needed              the programs of tests that have to run
       scripts/tool evidence --list                every kept result, and whether it holds
       scripts/tool evidence --campaigns           how old the result of each whole campaign is
       scripts/tool evidence --inputs NAME         the files that a check depends on

A result is kept in evidence/NAME.txt with the hash of all that it depends on: sources, properties,
tests, tools with their versions, the checking script. While that hash is the same, the check does
not run again. A result that is damaged, or whose inputs or tools have changed, is made again, and
one line says so. TRAMMEL_FRESH=1 makes all of them again, as `trammel test --fresh` does. In CI
(CI=true) a tenth is drawn by the commit's hash and made again: a difference is an error.

The result of a whole campaign (`trammel test --campaign`) names the commit at which it was made, or
last found to hold. One that is more than 200 commits old is an error. A campaign that has no result
yet counts from the commit that began the tier. A shallow clone cannot count and says so.

Exit codes: 0 the result holds or the check passed; 1 a result that was made again differs, the disk
is full, one of the list does not hold, or one of a campaign is too old; 2 usage; else that of the
command.
"""

import dataclasses
import datetime
import functools
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

from trammel_tools import python_tools
from trammel_tools.evidence import kinds, record, sources
from trammel_tools.paths import ROOT

AGE = 200  # [commits] that a whole campaign may be old
BEGUN = "2ac2c3757cbc0414f1907ad05fd0edda4e7de126"  # on which the tier of campaigns was built
DRAWN = 10  # one of so many
ROOM = 64 << 20  # [bytes] that are free where no disk is full
LAST = 40  # lines that are kept of a text that is not compared
OWN = {"TRAMMEL_FRESH", "TRAMMEL_NO_APT", "TRAMMEL_VERBS"}  # of the launcher: no test reads these
TIMES = re.compile(r" in \d+(?:\.\d+)? s\b| +\d+\.\d s(?=  )")  # how long a step took


@functools.cache
def git(*words):
    """What Git prints; nothing where it fails."""
    asked = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    return asked.stdout.strip() if asked.returncode == 0 else ""


def commit():
    return git("rev-parse", "HEAD")


def drawn(name):
    """Whether CI makes this result again."""
    if os.environ.get("CI") != "true":
        return False
    return int(record.digest(commit() + name)[:8], 16) % DRAWN == 0


@functools.cache
def inputs(name):
    """(hash of the files, tools) of a check."""
    kind, found = kinds.of(name)
    return record.digest_of(kind.files(found)), kinds.made_with(kind)


@functools.cache
def stale(name):
    """Why the kept result of a check does not hold, or nothing."""
    try:
        kept = record.read(name)
    except record.Damaged as error:
        return f"evidence/{name}.txt is damaged: {error}"
    if kept is None:
        return f"there is no evidence/{name}.txt"
    try:
        files, tools = inputs(name)
    except KeyError:
        return f"there is no such check: remove evidence/{name}.txt"
    if kept.check != name:
        return f"evidence/{name}.txt is the result of {kept.check}"
    if kept.tools != tools:
        there, here = (one.split("; ") for one in (kept.tools, tools))
        gone, new = ([one for one in these if one not in those] or ["fewer tools"]
                     for these, those in ((there, here), (here, there)))
        return f"it was made with {', '.join(gone)}; here is {', '.join(new)}"
    return "" if kept.inputs == files else f"its inputs have changed since {kept.made}"


def forget():
    """The next call looks at the repository again."""
    sources.forget()
    for one in (git, inputs, stale):
        one.cache_clear()


def full():
    """Which disk is full, or nothing: programs that could not write do not always say so."""
    build = ROOT / "build"
    for place in (build if build.exists() else ROOT, Path(tempfile.gettempdir())):
        free = shutil.disk_usage(place).free
        if free < ROOM:
            return (f"the disk of {place} is full: {free >> 20} MiB are free; make "
                    f"{ROOM >> 20} MiB free and test again")
    return ""


def variables():
    """Variables that give tests another seed or size, or scenarios other values."""
    return " ".join(sorted(one for one in os.environ if one.startswith("TRAMMEL_") and
                           one not in OWN))


def why(name):
    """Why a check has to run: its own result, or one of those that it feeds."""
    if os.environ.get("TRAMMEL_FRESH"):
        return "all are made again"
    if variables():
        return f"{variables()} may change it"
    if drawn(name):
        return f"drawn by commit {commit()[:12]}"
    if reason := stale(name):
        return reason
    for fed in kinds.of(name)[0].feeds:
        if why(fed):
            return f"{fed} needs it"
    return ""


def differences(old, new):
    """Lines that only one of two results has; in what order they were found does not matter."""
    before, after = Counter(old.split("\n")), Counter(new.split("\n"))
    return [f"-{line}" for line in before - after] + [f"+{line}" for line in after - before]


def called(command):
    """(exit code, what it printed) of a command, whose lines appear as they come."""
    lines = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as running:
        for line in running.stdout:
            lines.append(line)
            print(line, end="", flush=True)
    return running.returncode, "".join(lines)


def run(name, command):
    reason = why(name)
    if not reason:
        kept = renewed(name)
        print(f"{kept.result}kept: made on {kept.made}; {kept.inputs}")
        return 0
    print(f"evidence: {name} is made: {reason}", file=sys.stderr)
    made_from = inputs(name)
    try:
        code, printed = called(command)
    except OSError as error:
        return python_tools.refuse("evidence", f"{command[0]}: {error.strerror}")
    if disk := full():
        print(f"evidence: the result of {name} does not count: {disk}", file=sys.stderr)
        return code or 1
    result = TIMES.sub("", printed.replace(f"{ROOT}/", "")) or "passed\n"
    if not result.endswith("\n"):
        result += "\n"
    kind, _ = kinds.of(name)
    if not (kind.same or kind.counts):  # a verdict alone counts: the end says enough
        result = "".join(result.splitlines(keepends=True)[-LAST:])
    if code != 0:
        return code
    if variables():
        print(f"evidence: {name} is not kept: {variables()} may change it", file=sys.stderr)
        return 0
    forget()
    if inputs(name) != made_from:
        print(f"evidence: {name} is not kept: its inputs changed while it ran", file=sys.stderr)
        return 0
    before = None if stale(name) else record.read(name)
    changed = differences(before.result, result) if before and kind.same else []
    if changed:
        print(f"evidence: {name}: made again from equal inputs, the result differs; where the new "
              f"one (+) is right, remove evidence/{name}.txt and test again:", file=sys.stderr)
        print("\n".join(changed), file=sys.stderr)
        return 1
    if not before:
        files, tools = made_from
        words = " ".join(command).replace(f"{ROOT}/", "")
        write(record.Record(name, f"{datetime.date.today()}", words, tools, files, result,
                            commit() if kind.campaign else ""))
    return 0


def write(new):
    try:
        record.write(new)
    except OSError as error:
        print(f"evidence: {new.check} is not kept: {error}", file=sys.stderr)


def renewed(name):
    """The kept result that holds; of a campaign that is no longer young it names this commit."""
    kept = record.read(name)
    if kinds.of(name)[0].campaign and (age(name) or 0) > AGE // 2:
        kept = dataclasses.replace(kept, commit=commit())
        write(kept)
    return kept


def since(begin):
    """Commits of this one's history that another has not; None where Git does not know that one."""
    count = git("rev-list", "--count", f"{begin}..HEAD") if begin else ""
    return int(count) if count else None


def complete():
    """Whether there is a repository with all of its commits."""
    return git("rev-parse", "--is-shallow-repository") == "false"


def age(name):
    """Commits since a whole campaign last held; None where they cannot be counted. One that has no
    result is as old as the tier. A commit that a rebase replaced is as old as the record's file."""
    try:
        kept = record.read(name)
    except record.Damaged:
        kept = None
    if kept is None:
        return since(BEGUN)
    found = since(kept.commit)
    if found is None and complete():
        found = since(git("log", "-1", "--format=%H", "--", f"evidence/{name}.txt"))
    return found


def checks():
    """Names of all tests that have evidence, as CTest knows them."""
    listed = subprocess.run(["ctest", "-N", "-C", "campaign"], cwd=ROOT / "build", check=False,
                            capture_output=True, text=True).stdout
    for name in re.findall(r"Test +#\d+: (\S+)", listed):
        if any(re.fullmatch(kind.names, name) for kind in kinds.KINDS):
            yield name


def needed():
    """Programs of CMake's targets that tests without a kept result run."""
    for name in checks():
        found = re.fullmatch(r"coverage\.(\w+)\.(\w+)", name)
        if found and why(name):
            print(f"{found[2]}_coverage")
    return 0


def listed():
    bad = 0
    for path in sorted(record.KEPT.glob("*.txt")):
        reason = stale(path.stem)
        bad += bool(reason)
        print(f"{path.stem:<36}{reason or 'holds'}")
    return 1 if bad else 0


def campaigns():
    """Prints how old the result of each whole campaign is; 1 where one is too old."""
    ages = {name: age(name) for name in checks() if kinds.of(name)[0].campaign}
    old = {name for name, count in ages.items() if count is not None and count > AGE}
    unknown = [name for name, count in ages.items() if count is None]
    for name, count in ages.items():
        result = "made" if record.path_of(name).exists() else "no result yet"
        print(f"{name:<40}{result:<15}{'?' if count is None else count} of {AGE} commits")
    for name in sorted(old):
        print(f"evidence: {name} is {ages[name]} commits old, at most {AGE} are allowed: "
              f"`trammel test --campaign -R '^{name}$'` makes it, then commit evidence/{name}.txt",
              file=sys.stderr)
    if not ages:
        print("evidence: CTest names no campaign: `trammel test -N` configures build/",
              file=sys.stderr)
    elif unknown:
        how = "this repository lacks their commits: make them again" if complete() else \
            "this is no whole clone; `git fetch --unshallow` gets the commits"
        print(f"evidence: the age of {len(unknown)} campaigns is not known: {how}",
              file=sys.stderr)
    return 1 if old or not ages or (unknown and complete()) else 0


def main():
    parser = python_tools.Parser(prog="scripts/tool evidence", description=__doc__)
    asked = parser.add_mutually_exclusive_group()
    asked.add_argument("--needed", action="store_true", help="programs of tests that have to run")
    asked.add_argument("--list", action="store_true", help="every kept result")
    asked.add_argument("--campaigns", action="store_true", help="how old whole campaigns are")
    asked.add_argument("--inputs", metavar="NAME", help="the files that a check depends on")
    parser.add_argument("name", nargs="?", metavar="NAME")
    parser.add_argument("command", nargs="*", metavar="COMMAND")
    wanted = parser.parse_args()
    if wanted.name and (wanted.needed or wanted.list or wanted.campaigns or wanted.inputs):
        parser.error(f"{wanted.name}: --needed, --list and --campaigns take no name, --inputs one")
    if wanted.needed:
        return needed()
    if wanted.list:
        return listed()
    if wanted.campaigns:
        return campaigns()
    name = wanted.inputs or wanted.name
    if not name:
        parser.error("the name of a check is missing")
    try:
        kind, found = kinds.of(name)
        inputs(name)
    except KeyError:
        return python_tools.refuse("evidence", f"{name}: no such check")
    if wanted.inputs:
        print("\n".join(sorted(kind.files(found))))
        return 0
    if not wanted.command:
        parser.error("a check needs its command, behind --")
    return run(name, wanted.command)
