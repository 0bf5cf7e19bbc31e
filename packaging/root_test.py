#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The steps of the Containerfile in a bare Debian: root_test.py BUILD [--whole].

mmdebstrap makes a root folder of the Debian mirror that apt uses here; the steps of the last stage
run in it as they stand in the Containerfile, and then its program makes the circle in under 10 s of
processor time, with the events of the program of BUILD. The Debian package is made from BUILD;
with --whole the stage before makes it in a root of its own, from the files of Git, which takes as
long as a build from scratch. Needs root; skipped where it, mmdebstrap or the mirror is missing.
"""

import json
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MOST_S = 10
ENVIRONMENT = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
               "DEBIAN_FRONTEND": "noninteractive", "HOME": "/root", "LC_ALL": "C.UTF-8"}
NO_MIRROR = re.compile(r"could not resolve|failed to fetch|unable to fetch|could not connect|"
                       r"temporary failure|connection (failed|timed out)", re.I)


class NoMirror(Exception):
    """The mirror cannot be reached."""


def run(*command, **more):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False,
                          **more)


def stages():
    """The Containerfile: a list of (instruction, words) for each of its stages."""
    text = (ROOT / "packaging" / "Containerfile").read_text(encoding="utf-8")
    text = re.sub(r"\\\n\s*", "", re.sub(r"^#.*\n", "", text, flags=re.M))
    found = []
    for line in filter(None, text.splitlines()):
        name, words = line.split(None, 1)
        if name == "FROM":
            found.append([])
        found[-1].append((name, words))
    return found


def sources(suite):
    """Lines for apt: of the host's mirror of Debian."""
    asked = run("apt-get", "indextargets", "--format",
                "$(ORIGIN)|$(RELEASE)|$(REPO_URI)|$(COMPONENT)", "Created-By: Packages").stdout
    lines = [line.split("|") for line in dict.fromkeys(asked.splitlines())]
    return "".join(f"deb {address} {release} {component}\n"
                   for origin, release, address, component in lines
                   if origin == "Debian" and release.split("-")[0] == suite)


def bare(folder, image):
    """A root like that of an image such as debian:12; NoMirror where there is none."""
    suite = {"debian:12": "bookworm"}[image.split()[0]]
    made = run("mmdebstrap", "--variant=minbase", "--mode=root", "--quiet",
               "--aptopt=Acquire::Check-Valid-Until false", "--aptopt=Acquire::Check-Date false",
               suite, folder, "-", input=sources(suite))
    if made.returncode != 0:
        if NO_MIRROR.search(made.stderr):
            raise NoMirror(made.stderr.splitlines()[-1])
        raise SystemExit(f"root: mmdebstrap: {made.stderr[-2000:]}")
    shutil.copy("/etc/resolv.conf", folder / "etc" / "resolv.conf")


def inside(root, place, command):
    """A command in the root, with its own /proc and the host's network."""
    script = f"mount -t proc proc {shlex.quote(str(root))}/proc && exec chroot " \
             f"{shlex.quote(str(root))} sh -c {shlex.quote(f'cd {place} && {command}')}"
    return run("unshare", "--mount", "--pid", "--fork", "sh", "-c", script, env=ENVIRONMENT)


def perform(steps, root, copy):
    """Makes the root of a stage; its ENTRYPOINT. copy(words, root) does what COPY asks."""
    place, entry = "/", ""
    for name, words in steps:
        if name == "FROM":
            bare(root, words)
        elif name == "COPY":
            copy(words.split(), root)
        elif name == "WORKDIR":
            place = words
        elif name == "RUN":
            done = inside(root, place, words)
            if done.returncode != 0:
                text = done.stdout + done.stderr
                if NO_MIRROR.search(text):
                    raise NoMirror(text.strip().splitlines()[-1])
                raise SystemExit(f"root: RUN {words}:\n{text[-3000:]}")
        elif name == "ENTRYPOINT":
            entry = shlex.join(json.loads(words))
        elif name != "CMD":
            raise SystemExit(f"root: {name}: unknown here")
    return entry


def sources_of_git(words, root):
    """COPY . /src: the files that Git knows, as they are here."""
    for name in run("git", "-C", ROOT, "ls-files", "-z").stdout.split("\0")[:-1]:
        target = root / words[-1].lstrip("/") / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, target)


def package(build, whole, folder):
    """The folder with the Debian package."""
    if not whole:
        made = run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder)
        if made.returncode != 0:
            raise SystemExit(f"root: cpack: {made.stderr[-2000:]}")
        return folder
    perform(stages()[0], folder / "first", sources_of_git)
    return folder / "first" / "packages"


def test(build, whole, scratch):
    packages = package(build, whole, scratch)

    def from_first(words, root):
        for file in packages.glob(Path(words[1]).name):
            shutil.copy(file, root / words[2].lstrip("/"))

    root = scratch / "last"
    entry = perform(stages()[-1], root, from_first)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = inside(root, "/", f"{entry} run circle -o /out/circle")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if done.returncode != 0:
        raise SystemExit(f"root: {entry} run circle: {done.stdout}{done.stderr}")
    there = json.loads((root / "out" / "circle" / "metrics.json").read_text())["run"]
    run(build / "testbench" / "trammel", "run", "circle", "--no-report", "-o",
        scratch / "here").check_returncode()
    here = json.loads((scratch / "here" / "metrics.json").read_text())["run"]
    print(f"root: the circle in a bare Debian in {took:.1f} s, with its page")
    return 0 if there["event_hash"] == here["event_hash"] and took < MOST_S else 1


def main():
    build, whole = Path(sys.argv[1]).resolve(), "--whole" in sys.argv
    missing = [name for name in ("mmdebstrap", "unshare", "dpkg-shlibdeps")
               if not shutil.which(name)]
    if run("id", "-u").stdout.strip() != "0":
        missing.append("root")
    if missing:
        print(f"root: {missing[0]} is missing", file=sys.stderr)
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        try:
            return test(build, whole, Path(scratch))
        except NoMirror as error:
            print(f"root: {error}", file=sys.stderr)
            return 77


if __name__ == "__main__":
    sys.exit(main())
