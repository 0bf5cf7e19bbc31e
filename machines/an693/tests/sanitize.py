# SPDX-License-Identifier: Apache-2.0
"""Whole runs of this machine for scripts/tool sanitize, good and bad input; its prompt."""

import subprocess
from pathlib import Path

TUNING = ("run", "an693-tuning", "-s", "trajectory.steps=1", "-s", "trajectory.wait_s=0.005",
          "-s", "run.reached_counts=50")  # it is still on its way
FOLDER = "OUT/an693"
RUNS = [
    (0, *TUNING, "-o", FOLDER),
    (0, *TUNING, "--json", "--platform", "direct", "-o", FOLDER),
    (0, *TUNING, "--no-leap", "-s", "program=hold", "-o", FOLDER),
    *((5, "run", f"an693-{program}", "-s", "run.max_s=0.02", "-o", FOLDER)
      for program in ("absolute", "relative", "breakpoints")),
    (0, *TUNING, "--audit", "-o", FOLDER), (0, *TUNING, "--assert", "-o", FOLDER),
    (0, *TUNING, "--wave", "vcd", "--wave-trigger", "hi", "--wave-window", "0:100us", "-o", FOLDER),
    (0, *TUNING, "--engine", "twin", "-o", FOLDER),
    *((code, *TUNING, "-s", "chip.clock_MHz=6", "-s", f"chip.{key}", "-o", FOLDER)
      for code, key in ((0, "variant=lm629"), (0, "dac_bits=8"), (5, "wrap=true"))),
    (0, "lm628", "OUT/all.lm628", "-s", "chip.variant=lm629", "-s", "chip.clock_MHz=6"),
    (0, "lm628", "hold", "-s", "chip.dac_bits=8"),
    (5, "run", "an693-hold", "-s", "run.diverged_counts=1", "-o", FOLDER),
    (0, "lm628", "hold", "--wave", "fst", "--wave-window", "1.5ms:1.6ms", "-o", "OUT/lm628"),
    (0, "lm628", "tuning", "-o", "OUT/lm628"), (0, "lm628", "load"), (0, "lm628", "hold", "--json"),
    (0, "lm628", "--audit"),
    (0, "lm628", "OUT/all.lm628"), (0, "report", FOLDER, "OUT/lm628", "-o", "OUT/two.html"),
]
REFUSED = [
    (2, "value 7 is neither 6 nor 8", *TUNING, "-s", "chip.clock_MHz=7"),
    (2, "value 10 is neither 8 nor 12", *TUNING, "-s", "chip.dac_bits=10"),
    (2, "is none of: drive", *TUNING, "--wave", "fst", "--wave-trigger", "e ~ 3"),
    (2, "did you mean status.index?", *TUNING, "--wave", "fst", "--wave-trigger",
     "rise status.idex"),
    (2, "needs a folder", "lm628", "hold", "--wave", "fst"),
    (2, "is not known before", "lm628", "hold", "--wave", "fst", "--wave-trigger", "hi", "-o",
     "OUT/lm628"),
    (2, "did you mean LTRJ?", "lm628", "OUT/bad.lm628"),
    (2, "has no end", "lm628", "OUT/open.lm628"),
    (2, "no such script", "lm628", "nothing"),
    (2, "unknown key", "lm628", "hold", "-s", "gains.kp=1"),
    (5, "not within 0.01 s", "lm628", "OUT/late.lm628"),
    (2, "here the script gives the commands", "lm628", "hold", "-s", "filter.kp=1"),
]
REFUSED_BY_ALL = [
    (2, "not a key of the machine an693", *TUNING, "-s", "gains.kp=1"),
]
# Every word of the shell.
WORDS = """RESET\nPORT8\nPORT12\nDFH\nSIP\nLPEI 1\nLPES 2\nSBPA -5\nSBPR 5\nMSKI 0\nRSTI 0
LFIL 0Fh 1 2 3 4\nUDF\nLTRJ 3Fh 1 2 3\nSTT\nRDSTAT\nRDSIGS\nRDIP\nRDDP\nRDRP\nRDDV\nRDRV\nRDSUM
byte c 0Ah\nwait 1 ms\nread d\nrst\nwait complete\nstatus\npins\nhelp\nhelp LFIL\nhelp RSTI
repeat 2\ntorque 0.01\nwait 1 ms\nrepeat 2\ntorque -0.01\nend\nend\nhelp repeat\nhelp torque
help wait\nhelp status\nhelp byte\nhelp PORT12\nquit\n"""


def write_input(out):
    """Before the runs."""
    (out / "all.lm628").write_text(WORDS, encoding="utf-8")


def write_bad_input(out):
    """After the runs, before what is refused."""
    (out / "bad.lm628").write_text("LTRK 0\n", encoding="utf-8")
    (out / "open.lm628").write_text("repeat 2\nSTT\n", encoding="utf-8")
    (out / "late.lm628").write_text("RSTI 0\nwait hi 10 ms\n", encoding="utf-8")


def passes(program, environment, out):
    """What takes more than one command: a session at the prompt."""
    talk = subprocess.run([Path(__file__).with_name("prompt_check.py"), program], env=environment,
                          cwd=out, check=False)
    return talk.returncode == 0
