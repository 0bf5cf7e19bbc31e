# SPDX-License-Identifier: Apache-2.0
"""Each numeric key at the ends of its range and between, for trammel verify --keys.

The keys are those of `trammel list keys`, so a new one is in it; beside them the words of
[keys.words]. Each value is given to a short run of the machine, by machines/<m>/tests/runs.toml,
with the twin engine: the run does what it was asked, by the truth in its trace, or its line says
why not, or the value is refused by a line that names the key. A part of that run, of [keys] cut_s
in the key that [keys] cut names, else in run.max_s, has the same events and files with the RTL. A
key whose values all give the same run is tried in vain, unless [keys.inert] says why.

All of it is tried again with the settings of each [[keys.also]], such as another controller, but
for the keys that begin as its `without` says.
"""

import functools
import json
import math
import random
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from trammel_tools import machines
from trammel_tools.check import engines

PROGRAM = engines.PROGRAM
PATIENCE = 120  # [s] for one run
BETWEEN = 3  # values between the ends
SHORT = 12  # keys of each machine with --short, others each time the table grows


def numeric(machine):
    """{key: (least, most, default, whole)}; a key that each axis has is one for both."""
    done = subprocess.run([PROGRAM, "list", "keys", machine, "--json"], capture_output=True,
                          text=True, check=True)
    found = {}
    for entry in json.loads(done.stdout):
        least, dots, most = entry["range"].partition("..")
        if not dots:
            continue
        key = entry["key"].replace(".x.", ".").replace(".y.", ".")
        whole = "." not in entry["default"] and "e" not in entry["default"]
        found.setdefault(key, (float(least), float(most), float(entry["default"]), whole))
    return found


def values(key, least, most, default, whole, seed):
    """Both ends; one anywhere between, on a logarithmic scale if it is wide; two near default."""
    draw = random.Random(f"{key} {seed}")
    chosen = [least, most]
    for n in range(BETWEEN):
        low, high = least, most
        if n > 0 and default != 0:
            low, high = sorted((default / 4, default * 4))
            low, high = max(low, least), min(high, most)
        if low >= 0 and high > 100 * max(low, 1e-300):
            low = max(low, high * 1e-5, 1e-300)
            value = math.exp(draw.uniform(math.log(low), math.log(high)))
        else:
            value = draw.uniform(low, high)
        chosen.append(value)
    words = [str(round(value)) if whole else f"{value:.5g}" for value in chosen]
    return list(dict.fromkeys(words))


def run(plan, key, value, folder, engine, cut=False):
    """(exit code, what it says, figures, files) of a run."""
    out = folder / f"{key}-{value}-{engine}{'-cut' if cut else ''}"
    more = [one for start, some in plan.get("with", {}).items() if key.startswith(start)
            for one in some]
    settings = [*plan.get("settings", []), *more, f"{key}={value}"]
    if cut:
        settings.append(f"{plan.get('cut', 'run.max_s')}={plan['cut_s']}")
    command = [PROGRAM, "run", plan["scenario"], "--engine", engine, "--platform", "direct",
               "--no-report", "-o", out]
    for one in settings:
        command += ["-s", one]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False,
                              timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None, f"does not end within {PATIENCE} s", {}, {}
    lines = (done.stderr if done.returncode == 2 else done.stdout).strip().splitlines()
    metrics, files = {}, {}
    if (out / "metrics.json").exists():
        metrics = json.loads((out / "metrics.json").read_text(encoding="utf-8"))
        files = {path.name: path.read_bytes() for path in out.iterdir()
                 if path.name in ("trace.csv", "detail.json")}
    for path in out.iterdir() if out.exists() else ():
        path.unlink()
    return done.returncode, lines[0] if lines else "", metrics, files


def off_target(files, columns):
    """Distance of the last true position from what was asked at the end, in the columns' unit."""
    rows = files.get("trace.csv", b"").decode().strip().splitlines()
    if len(rows) < 2:
        return None
    last = dict(zip(rows[0].split(","), rows[-1].split(",")))
    return math.dist(*[[float(last[name]) for name in names] for names in columns])


def judge(plan, folder, one):
    """(outcome, text, print of the run): outcome is done, ended, refused or WRONG."""
    key, value = one
    code, text, metrics, files = run(plan, key, value, folder, "twin")
    figures = json.dumps(metrics.get("figures"))
    event_hash = metrics.get("run", {}).get("event_hash")
    return (*judge_run(plan, folder, one, (code, text, files)),
            hash((code, text, figures, event_hash)))


def judge_run(plan, folder, one, made):
    """(outcome, text) of the run that was made."""
    key, value = one
    code, text, files = made
    if code == 2:
        # Its own name, or that of the key of its section with which it does not go together.
        named = key.rsplit(".", 1)[-1] in text or key.split(".", 1)[0] in text
        return ("refused", text) if named else ("WRONG", f"the key is not named: {text}")
    if code is None or code not in (0, 1, 4, 5):
        return "WRONG", f"exit {code}: {text}"
    pair = [run(plan, key, value, folder, engine, cut=True) for engine in ("twin", "rtl")]
    hashes = [one[2].get("run", {}).get("event_hash") for one in pair]
    if pair[0][0] != pair[1][0] or hashes[0] != hashes[1] or pair[0][3] != pair[1][3]:
        return "WRONG", f"RTL and twin differ: {[(one[0], one[1]) for one in pair]}"
    if code != 0:
        return "ended", text
    columns = plan.get("columns")
    off = off_target(files, columns) if columns else None
    if off is not None and off > plan["reached"]:
        return "WRONG", f"ends {off:.4g} from what was asked: {text}"
    return "done", text


def in_vain(machine, plan, prints):
    """Lines of keys whose values made no difference."""
    inert = plan.get("inert", {})
    for key, reason in inert.items():
        if key in prints:
            print(f"inert    {key}: {reason}")
    return [f"{machine}: {key}: no value of it changes the run" for key, made in prints.items()
            if key not in inert and len(made) > 1 and len(set(made)) == 1]


def table(machine, short, seed):
    """(key, value) pairs to try, and the keys that are only listed with why."""
    plan = machines.runs(machine).get("keys")
    if plan is None:
        return None, [], {}
    listed = plan.get("listed", {})
    keys = {key: limits for key, limits in numeric(machine).items() if key not in listed}
    if short:
        keys = {key: keys[key] for key in random.Random(seed).sample(sorted(keys), SHORT)}
    tried = [(key, value) for key, limits in keys.items()
             for value in values(key, *limits, seed)]
    tried += [(key, word) for key, words in plan.get("words", {}).items() for word in words]
    return plan, tried, {} if short else listed


def again(plan, tried, short, seed):
    """Name, plan and pairs of each [[keys.also]]."""
    for also in plan.get("also", []):
        own = [one for one in tried if not one[0].startswith(tuple(also.get("without", [])))]
        if short:
            keys = sorted({key for key, _ in own})
            kept = random.Random(seed).sample(keys, min(SHORT, len(keys)))
            own = [one for one in own if one[0] in kept]
        yield also["name"], {**plan, "settings": [*plan.get("settings", []),
                                                  *also["settings"]]}, own


def judge_all(name, plan, tried, wrong):
    """Prints a line a value; returns the prints of its runs by key."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        outcomes = pool.map(functools.partial(judge, plan, Path(folder)), tried)
        counts, prints = {}, {}
        for (key, value), (outcome, text, fingerprint) in zip(tried, outcomes):
            counts[outcome] = counts.get(outcome, 0) + 1
            print(f"{outcome:<8} {key}={value}: {text}", flush=True)
            if outcome == "WRONG":
                wrong.append(f"{name}: {key}={value}: {text}")
            prints.setdefault(key, []).append(fingerprint)
    print(f"{name}: {len(tried)} values: "
          f"{', '.join(f'{n} {what}' for what, n in sorted(counts.items()))}", flush=True)
    return prints


def check(short=False, seed=1):
    """Prints a line a value; returns lines of what went wrong."""
    if not PROGRAM.exists():
        raise engines.EngineError("the program is missing: trammel list builds it")
    wrong = []
    for machine in machines.folders():
        plan, tried, listed = table(machine, short, seed)
        if plan is None:
            continue
        wrong += in_vain(machine, plan, judge_all(machine, plan, tried, wrong))
        for key, reason in listed.items():
            print(f"listed   {key}: {reason}")
        for name, other, own in again(plan, tried, short, seed):
            judge_all(f"{machine}, {name}", other, own, wrong)
    return wrong
