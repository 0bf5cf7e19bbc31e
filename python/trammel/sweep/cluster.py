# SPDX-License-Identifier: Apache-2.0
"""Where the runs of a sweep are made: workers of Dask, here or on a cluster."""

from __future__ import annotations

import asyncio
import contextlib
import logging
import os
import signal
import subprocess
import time
from collections.abc import Iterator
from concurrent import futures
from multiprocessing import resource_tracker

from trammel.sweep import work
from trammel.sweep.plan import PlanError

# A question that each batch system answers at once when it is there, and its class of Dask.
BATCH = {"slurm": (("sinfo",), "SLURMCluster"), "lsf": (("lsid",), "LSFCluster"),
         "pbs": (("qstat", "-B"), "PBSCluster"), "sge": (("qhost",), "SGECluster"),
         "htcondor": (("condor_status", "-total"), "HTCondorCluster")}
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


def _ask(kind: str, limit_s: float) -> None:
    """A PlanError with the batch system's own words where it is not there."""
    command = BATCH[kind][0]
    where = f"--cluster {kind}: {command[0]}"
    try:
        asked = subprocess.run(command, capture_output=True, text=True, check=False,
                               timeout=limit_s)
    except OSError as error:
        raise PlanError(f"{where}: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        raise PlanError(f"{where}: no answer within {limit_s:g} s") from None
    if asked.returncode != 0:
        said = (asked.stderr.strip() or asked.stdout.strip() or f"exit code {asked.returncode}")
        raise PlanError(f"{where}: {said.splitlines()[0].removeprefix(command[0] + ': ')}")


def _jobqueue(kind: str, jobs: int, limit_s: float, said: list[str]):
    """A cluster whose workers are jobs of a batch system; its options: dask's configuration. What
    the batch system says of jobs that it does not take is added to `said`."""
    import dask_jobqueue

    _ask(kind, limit_s)
    base = getattr(dask_jobqueue, BATCH[kind][1])

    class Job(base.job_cls):
        async def _submit_job(self, script):
            try:
                return await super()._submit_job(script)
            except (RuntimeError, OSError) as error:
                text = str(error).rpartition("stderr:")[2].strip() or str(error)
                said.append(text.splitlines()[0])
                raise

    made = type(base.__name__, (base,), {"job_cls": Job})(
        cores=1, processes=1, memory="1GiB", scheduler_options={"dashboard_address": ":0"})
    made.scale(jobs=jobs)
    return made


def _wait(found, limit_s: float, said: list[str]) -> None:
    """For the first worker."""
    until = time.monotonic() + limit_s
    while True:
        left = until - time.monotonic()
        try:
            found.wait_for_workers(1, timeout=max(0.1, min(1, left)))
            return
        except TimeoutError:
            if said:
                raise PlanError(said[0]) from None
            if left <= 0:
                raise TimeoutError("none has come; jobs that were sent may wait for their turn"
                                   ) from None


@contextlib.contextmanager
def _deaf():
    """What is started meanwhile hears no Ctrl-C, which a terminal sends to all: this process ends
    the others. One that comes meanwhile is heard at the end."""
    resource_tracker.ensure_running()  # else the first process makes its thread hear again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _local(jobs: int):
    import distributed

    with _deaf():  # its thread, which starts workers, among them those in the place of dead ones
        return distributed.LocalCluster(n_workers=jobs, threads_per_worker=1, memory_limit=0,
                                        dashboard_address="127.0.0.1:0",
                                        silence_logs=logging.CRITICAL)


def _greet(address: str, limit_s: float) -> None:
    """Raises where no scheduler answers; a client would wait for ever for one that is silent."""
    from distributed.comm import connect

    async def greet() -> None:
        try:
            comm = await asyncio.wait_for(connect(address, timeout=limit_s), limit_s)
        except TimeoutError:
            raise TimeoutError("no answer") from None
        comm.abort()

    with futures.ThreadPoolExecutor(1) as pool:  # a notebook's thread has a loop of its own
        pool.submit(asyncio.run, greet()).result()


@contextlib.contextmanager
def client(kind: str, jobs: int, address: str, limit_s: float):
    """A client with at least one worker; a PlanError says what the scheduler said else."""
    import dask
    import distributed

    dask.config.set(QUIET)
    known = [n for n in logging.root.manager.loggerDict if n.startswith("distributed")]
    for name in [*known, "tornado.application", "asyncio"]:
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what matters is raised
    where = address or f"--cluster {kind}"
    cluster, said = None, []
    try:
        if not address:
            cluster = _local(jobs) if kind == "local" else _jobqueue(kind, jobs, limit_s, said)
        try:
            if address:
                _greet(address, limit_s)
            found = distributed.Client(address or cluster, timeout=limit_s)
            _wait(found, limit_s, said)
        except PlanError as error:
            raise PlanError(f"{where}: {error}") from None
        except Exception as error:
            said = str(error).strip().splitlines()
            raise PlanError(f"{where}: no worker within {limit_s:g} s: "
                            f"{said[0] if said else type(error).__name__}") from None
        with found:
            yield found
    finally:
        if cluster is not None:
            with contextlib.suppress(Exception):  # jobs that never began cannot be closed
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
        except work.WorkerError as error:
            raise PlanError(f"{error}; what is done is kept") from None
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
