# SPDX-License-Identifier: Apache-2.0
"""Where the runs of a sweep are made: workers of Dask, here or on a cluster."""

from __future__ import annotations

import contextlib
import logging
import os
from collections.abc import Iterator

from trammel.sweep import work
from trammel.sweep.plan import PlanError

BATCH = ("slurm", "lsf", "pbs", "sge", "htcondor")
CHUNK_S = 2.0  # what a task should take
MOST_CHUNK = 2000
AHEAD = 3  # tasks a worker has before it
# What Dask does all the time, whatever it computes: it costs some per cent of a processor.
QUIET = {"distributed.worker.profile.enabled": False,
         "distributed.worker.memory.target": False, "distributed.worker.memory.spill": False,
         "distributed.worker.memory.pause": False, "distributed.worker.memory.terminate": False,
         "distributed.scheduler.active-memory-manager.start": False,
         "distributed.admin.tick.interval": "1s",
         "distributed.admin.system-monitor.interval": "10s"}


def _jobqueue(kind: str, jobs: int):
    """A cluster whose workers are jobs of a batch system; its options: dask's configuration."""
    try:
        import dask_jobqueue
    except ImportError:
        raise PlanError(f"--cluster {kind}: the package dask-jobqueue is missing") from None
    classes = {"slurm": "SLURMCluster", "lsf": "LSFCluster", "pbs": "PBSCluster",
               "sge": "SGECluster", "htcondor": "HTCondorCluster"}
    cluster = getattr(dask_jobqueue, classes[kind])(
        cores=1, processes=1, memory="1GiB", scheduler_options={"dashboard_address": ":0"})
    cluster.scale(jobs=jobs)
    return cluster


def _local(jobs: int):
    import distributed

    return distributed.LocalCluster(n_workers=jobs, threads_per_worker=1, memory_limit=0,
                                    dashboard_address="127.0.0.1:0",
                                    silence_logs=logging.CRITICAL)


@contextlib.contextmanager
def client(kind: str, jobs: int, address: str, limit_s: float):
    """A client with at least one worker; a PlanError says what the scheduler said else."""
    import dask
    import distributed

    dask.config.set(QUIET)
    logging.getLogger("distributed").setLevel(logging.ERROR)
    where = address or f"--cluster {kind}"
    cluster = None
    try:
        if not address:
            cluster = _local(jobs) if kind == "local" else _jobqueue(kind, jobs)
        try:
            found = distributed.Client(address or cluster, timeout=limit_s)
            found.wait_for_workers(1, timeout=limit_s)
        except PlanError:
            raise
        except Exception as error:
            said = str(error).strip().splitlines()
            raise PlanError(f"{where}: no worker within {limit_s:g} s: "
                            f"{said[0] if said else type(error).__name__}") from None
        with found:
            yield found
    finally:
        if cluster is not None:
            cluster.close(timeout=5)


def rows(found, parts: list, runs: Iterator, workers: int, empty: bool = False):
    """Rows of the runs, in the order in which they end. Tasks are as long as CHUNK_S, and some are
    on their way to each worker, so that none waits."""
    import distributed

    size, sent = 1, {}
    ended = distributed.as_completed(with_results=False)
    runs = iter(runs)

    def send() -> bool:
        taken = [one for _, one in zip(range(size), runs)]
        if taken:
            future = found.submit(work.chunk, parts, taken, empty, pure=False, retries=2)
            sent[future] = taken
            ended.add(future)
        return bool(taken)

    while len(sent) < AHEAD * workers and send():
        pass
    while sent:
        future = next(ended)
        taken = sent.pop(future)
        try:
            made, took = future.result()
        except Exception as error:  # of the worker or its way here, not of a run
            text = str(error).splitlines()[0] if str(error) else type(error).__name__
            yield [{"run": number, "part": part, "scenario": parts[part][0], **values,
                    "end": "lost", "message": text} for number, part, values in taken]
        else:
            each = max(took / len(taken), 1e-7)
            size = max(1, min(MOST_CHUNK, 4 * size, round(CHUNK_S / each)))
            yield made
        future.release()
        if len(found.scheduler_info(n_workers=-1)["workers"]) > workers:  # more have come
            workers += 1
        while len(sent) < AHEAD * workers and send():
            pass


def processors() -> int:
    return len(os.sched_getaffinity(0))
