# SPDX-License-Identifier: Apache-2.0
"""The verb `trammel tune`."""

from __future__ import annotations

import contextlib
import json
import logging
import os
import re
import sys
from pathlib import Path

from trammel import _core, command_line
from trammel.sweep.files import PlanError
from trammel.sweep.main import Progress
from trammel.tune.study import Distance, Study, StudyError

RECORD = "study.json"
BEST_ONE = re.compile(r"best\.toml")
BEST = re.compile(r"best(-[1-9][0-9]{0,6})?\.toml")


def whole_journal(file: Path) -> str:
    """Its name, when what a kill or a full disk has left of a last line is gone, and what says that
    somebody writes it: the folder's own lock says that nobody does."""
    from trammel.sweep import files

    Path(f"{file}.lock").unlink(missing_ok=True)
    with contextlib.suppress(FileNotFoundError), \
            open(files.opened(file, os.O_RDWR | os.O_NOFOLLOW), "r+b") as stream:
        text = stream.read()
        stream.truncate(text.rfind(b"\n") + 1)
    return str(file)


def open_study(study: Study, folder: Path):
    """The study of Optuna in a folder that is locked; trials that were never finished are left
    aside."""
    import optuna
    from optuna.storages import JournalStorage
    from optuna.storages.journal import JournalFileBackend, JournalFileOpenLock

    from trammel.sweep import store

    optuna.logging.set_verbosity(logging.ERROR)
    store.keep_record(folder / RECORD, study.identity())
    journal = whole_journal(folder / "trials.log")
    sampler = optuna.samplers.TPESampler(seed=study.seed, multivariate=True,
                                         n_startup_trials=max(10, 2 * len(study.search)))
    directions = ["maximize" if g.maximize else "minimize" for g in study.objectives]
    try:
        storage = JournalStorage(JournalFileBackend(journal, lock_obj=JournalFileOpenLock(journal)))
        found = optuna.create_study(storage=storage, sampler=sampler, study_name="study",
                                    load_if_exists=True, directions=directions)
        whole = [one.name.lower() for one in found.directions] == directions
    except OSError:
        raise
    except Exception:  # Optuna takes each line for what it has written
        whole = False
    if not whole:
        raise StudyError(f"{journal}: is corrupt")
    for trial in found.get_trials(deepcopy=False, states=(optuna.trial.TrialState.RUNNING,)):
        found.tell(trial.number, state=optuna.trial.TrialState.FAIL)
    return found


def judge(study: Study, found, trial, rows: list[dict]) -> None:
    """Tells Optuna what came of a trial; one with a run that did not end well has failed."""
    import optuna

    bad = next((row for row in rows if row["end"] != "done"), None)
    if bad is None:
        missing = [x for g in study.objectives + study.constraints for x in g.missing(rows)]
        if missing:
            raise StudyError(f"{study.file}: {missing[0]}: no figure of every case")
        outside = [x for g in study.constraints for x in g.outside(rows)]
        for n, miss in enumerate(outside):
            trial.set_constraint(str(n), miss)
        trial.set_user_attr("outside", outside)
        trial.set_user_attr("constraints", [g.value(rows) for g in study.constraints])
        if any(isinstance(g, Distance) for g in study.objectives):
            trial.set_user_attr("reached", [g.reached(rows) if isinstance(g, Distance) else []
                                            for g in study.objectives])
        found.tell(trial, [g.value(rows) for g in study.objectives])
        return
    trial.set_user_attr("message", f"{bad['scenario']}: {bad['end']}: {bad['message']}")
    # The sampler takes what is pruned for bad, and learns nothing of what has failed; but only
    # where there is one objective.
    alone = len(study.objectives) == 1
    for n in range(sum(len(g.limits) for g in study.constraints)):
        trial.set_constraint(str(n), 1.0)
    found.tell(trial, state=optuna.trial.TrialState.PRUNED if alone
               else optuna.trial.TrialState.FAIL)


def search(study: Study, found, trials: int, *, jobs: int = 0, cluster: str = "local",
           scheduler: str = "", limit_s: float = 60, progress: Progress) -> None:
    """Makes trials until there are so many."""
    import distributed

    from trammel.sweep import cluster as workers
    from trammel.sweep import work

    parts = [(scenario, study.engine, {**study.keys, **case}) for scenario, case in study.cases]
    left = trials - len(found.get_trials(deepcopy=False))
    if left <= 0:
        return
    jobs = jobs or workers.processors()
    progress.begin(left)
    with workers.client(cluster, jobs, scheduler, limit_s) as client:
        sent, ended = {}, distributed.as_completed()

        def send() -> None:
            trial = found.ask()
            values = study.suggest(trial)
            runs = [(n, n, values) for n in range(len(parts))]
            future = client.submit(work.chunk, parts, runs, pure=False, retries=2)
            sent[future] = trial
            ended.add(future)

        try:
            for _ in range(min(jobs, left)):
                send()
            left -= len(sent)
            while sent:
                future = next(ended)
                trial = sent.pop(future)
                try:
                    rows = future.result()[0]
                except work.WorkerError as error:
                    raise StudyError(f"{error}; what is done is kept") from None
                except Exception as error:  # of the worker, not of a run
                    rows = [{"scenario": "", "end": "lost", "message": str(error)}]
                judge(study, found, trial, rows)
                progress.add(1)
                if left > 0:
                    send()
                    left -= 1
        finally:
            progress.close()


def best_of(study: Study, found) -> list:
    """The best trials that keep all constraints; several where there are several objectives."""
    kept = [t for t in found.get_trials(deepcopy=False)
            if t.values and all(x <= 0 for x in t.user_attrs.get("outside", []))]
    signs = [-1 if g.maximize else 1 for g in study.objectives]

    def beats(one, other) -> bool:
        pairs = [(s * a, s * b) for s, a, b in zip(signs, one.values, other.values)]
        return all(a <= b for a, b in pairs) and any(a < b for a, b in pairs)

    front = [t for t in kept if not any(beats(other, t) for other in kept)]
    front.sort(key=lambda t: (signs[0] * t.values[0], t.number))
    return front if len(study.objectives) > 1 else front[:1]


def scenario_text(study: Study, trial) -> str:
    """A scenario file: that of the first case with the keys of the study and of the trial."""
    from trammel.run_settings import _apply

    scenario, _ = study.cases[0]
    asked = _core.Settings(scenario)
    for key, value in {**study.keys, **trial.params}.items():
        _apply(asked, key, value)
    asked.set("name", f"{study.file.stem}-{trial.number}")
    head = [f"# {study.file.name}, trial {trial.number}:"]
    for n, (goal, value) in enumerate(zip(study.objectives, trial.values)):
        head.append(f"#   {goal.name} over {len(study.cases)} cases: {value:.6g}")
        if isinstance(goal, Distance):
            head += [f"#     {found:.5g} for {one.value:.5g}, {one.figure} of {study.of(one)}"
                     for one, found in zip(goal.targets, trial.user_attrs["reached"][n])]
    return "\n".join(head) + "\n" + asked.toml


def own_best(study: Study, folder: Path) -> list[str]:
    """The scenario files of best trials that the study's record lists; a StudyError where somebody
    else's has a name that the study may need."""
    from trammel.sweep import files

    names = BEST if len(study.objectives) > 1 else BEST_ONE
    listed = (files.read_json(folder / RECORD) or {}).get("best", [])
    if not isinstance(listed, list) or not all(isinstance(name, str) and BEST.fullmatch(name)
                                               for name in listed):
        raise StudyError(f"{folder / RECORD}: is corrupt")
    for file in folder.glob("best*.toml"):
        if names.fullmatch(file.name) and file.name not in listed:
            raise StudyError(f"{file}: is not of the study that the folder holds; move it away")
    for name in listed:
        files.check_replaceable(folder / name)
    return listed


def write(study: Study, found, folder: Path) -> list:
    """best.toml or best-N.toml, and the page. The record lists them, before they are there and as
    long as they are."""
    from trammel.sweep import files, page

    front = best_of(study, found)
    before = own_best(study, folder)
    names = [f"best-{n}.toml" if len(front) > 1 else "best.toml" for n in range(1, len(front) + 1)]

    def keep(listed: list[str]) -> None:
        record = {**study.identity(), "best": listed}
        files.replace(folder / RECORD, (json.dumps(record, indent=2) + "\n").encode())

    keep(list(dict.fromkeys(before + names)))
    for name in set(before) - set(names):
        (folder / name).unlink(missing_ok=True)
    for name, trial in zip(names, front):
        files.replace(folder / name, scenario_text(study, trial).encode())
    keep(names)
    page.write_trials(study, found.get_trials(deepcopy=False), {t.number for t in front},
                      folder / "page.html")
    return front


def perform(study: Study, folder: Path, *, trials: int = 0, progress=None, show: bool = False,
            **workers) -> tuple[list, list]:
    """Makes the trials that are not in the folder yet, those of the study if no number is given,
    and what is written of all: (all of them, the best), each as Optuna has it.

    progress   is called with the trials made now and how many it will be; what it raises ends the
               search, as Ctrl-C does. What is done is kept, and is written in any case.
    workers    jobs, cluster, scheduler, limit_s, as of trammel.sweep
    """
    from trammel.sweep import files, store

    folder = Path(folder)
    store.check_record(folder / RECORD, study.identity(), "trials", "study", "study")
    files.check_replaceable(folder / "page.html")
    own_best(study, folder)
    with store.lock(folder, "", "study"):
        found = open_study(study, folder)
        try:
            search(study, found, trials or study.trials,
                   progress=Progress(show, progress, "trials"), **workers)
        except BaseException:
            with contextlib.suppress(OSError, PlanError):  # may be what it ended by: the disk
                write(study, found, folder)
            raise
        return found.get_trials(deepcopy=False), write(study, found, folder)


def _folder(given) -> Path:
    return Path(given.out or Path("out") / Path(given.study).stem)


def _tune(given) -> int:
    folder = _folder(given)
    study = Study(Path(given.study))
    trials, front = perform(study, folder, trials=given.trials, jobs=given.jobs,
                            cluster=given.cluster, scheduler=given.scheduler, limit_s=given.limit,
                            show=True)
    failed = sum(trial.values is None for trial in trials)
    print(f"{study.file.stem}: {len(trials)} trials, {failed} of them failed; "
          f"{len(front)} best\n  results in {folder}")
    for trial in front[:5]:
        values = ", ".join(f"{g.name} {v:.5g}" for g, v in zip(study.objectives, trial.values))
        print(f"  trial {trial.number}: {values}; " +
              " ".join(f"{k}={v:.5g}" if isinstance(v, float) else f"{k}={v}"
                       for k, v in trial.params.items()))
    if not front:
        print("tune: no trial ended well and within all constraints", file=sys.stderr)
    return 0 if front else 1


def main() -> int:
    return command_line.main("tune", command_line.tune, _tune, lambda given: str(_folder(given)))


if __name__ == "__main__":
    sys.exit(main())
