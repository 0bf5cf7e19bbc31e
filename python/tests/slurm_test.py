# SPDX-License-Identifier: Apache-2.0
"""A sweep through Slurm on this computer, with a worker killed on the way: slurm_test.py PROGRAM.

Starts munged, slurmctld and slurmd of its own, with all their files in a scratch folder and sockets
on this computer alone, and ends them again. Skipped where they are missing or it is not root.
"""

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import sweeps

from trammel import sweep

NEEDED = ("munged", "mungekey", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo")
RUNS = 120
LIMIT_S = 180
CONF = """ClusterName=trammel
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def wait_for(what, test, limit_s=30):
    until = time.monotonic() + limit_s
    while time.monotonic() < until:
        if test():
            return
        time.sleep(0.1)
    raise SystemExit(f"slurm: {what} within {limit_s} s: no")


def said(*command, environment):
    return subprocess.run(command, capture_output=True, text=True, check=False,
                          env=environment).stdout


@contextlib.contextmanager
def cluster(folder):
    """The environment in which Slurm's programs find it."""
    host = socket.gethostname().split(".")[0]
    for name in ("state", "spool"):
        (folder / name).mkdir()
    (folder / "slurm.conf").write_text(CONF.format(
        host=host, folder=folder, controller=free_port(), daemon=free_port()))
    environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf"),
                   "DASK_JOBQUEUE__SLURM__INTERFACE": "lo",
                   "DASK_JOBQUEUE__SLURM__LOG_DIRECTORY": str(folder)}
    subprocess.run(["mungekey", "--create", f"--keyfile={folder}/munge.key"], check=True)
    started = []
    try:
        for command in (["munged", "--foreground", "--force", f"--key-file={folder}/munge.key",
                         f"--socket={folder}/munge.socket", f"--pid-file={folder}/munged.pid",
                         f"--log-file={folder}/munged.log", f"--seed-file={folder}/munge.seed"],
                        ["slurmctld", "-D"], ["slurmd", "-D", "-N", host]):
            log = (folder / f"{command[0]}.out").open("w")
            started.append(subprocess.Popen(command, stdout=log, stderr=log, env=environment))
            if command[0] == "munged":
                wait_for("munged", (folder / "munge.socket").exists)
        wait_for("an idle node", lambda: "idle" in said("sinfo", "-h", "-o", "%t",
                                                        environment=environment))
        yield environment
    except SystemExit:
        for log in sorted(folder.glob("*.out")) + sorted(folder.glob("*.log")):
            print(f"{log.name}:\n{log.read_text()[-1500:]}", file=sys.stderr)
        raise
    finally:
        said("scancel", "--user", "root", environment=environment)
        for process in reversed(started):
            process.send_signal(signal.SIGTERM)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(timeout=10)
            process.kill()


def main():
    missing = [name for name in NEEDED if not shutil.which(name)]
    if missing or os.geteuid() != 0:
        print(f"slurm: {missing[0] if missing else 'root'} is missing", file=sys.stderr)
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        plan, out = folder / "plan.toml", folder / "out"
        plan.write_text(sweeps.plan(RUNS, 0.4))
        with cluster(folder) as environment:
            child = sweeps.begin("sweep", plan, "-o", out, "--cluster", "slurm", "--jobs", "2",
                                 "--limit", "120", env=environment, cwd=folder)
            wait_for("first rows", lambda: child.poll() is not None or
                     len(list((out / "runs").glob("*.parquet"))) > 1, LIMIT_S)
            jobs = said("squeue", "-h", "-t", "R", "-o", "%i", environment=environment).split()
            if len(jobs) > 1:
                said("scancel", "--signal=KILL", "--full", jobs[0], environment=environment)
                wait_for("the end of a job", lambda: jobs[0] not in said(
                    "squeue", "-h", "-t", "R", "-o", "%i", environment=environment).split())
                before = len(list((out / "runs").glob("*.parquet")))
            text, errors = child.communicate(timeout=LIMIT_S)
            print(f"slurm: {len(jobs)} jobs, one killed; {text}", errors)
            after = len(list((out / "runs").glob("*.parquet")))
            if child.returncode != 0 or len(jobs) < 2 or after <= before:
                return 1  # or it was over before the worker was killed
            refused = subprocess.run(
                [sys.executable, "-m", "trammel", "sweep", plan, "-o", folder / "none",
                 "--cluster", "slurm", "--limit", "30"], capture_output=True, text=True,
                check=False, env={**environment, "SLURM_CONF": str(folder / "none.conf")})
            if refused.returncode != 2 or refused.stderr.count("\n") != 1:
                print(f"slurm: a Slurm that is not there: {refused}", file=sys.stderr)
                return 1
        table = sweep.read(out)
        right = (table["run"].to_pylist() == list(range(RUNS))
                 and set(table["end"].to_pylist()) == {"timeout"})
        print("slurm: every run once" if right else "slurm: runs are missing")
        return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
