# SPDX-License-Identifier: Apache-2.0
"""Many runs: plans, workers, and the data set that they fill.

    from trammel import sweep
    sweep.run("plan.toml", "out/plan")
    frame = sweep.read("out/plan").to_pandas()
"""

from trammel.sweep.plan import Plan, PlanError

__all__ = ["Plan", "PlanError", "read", "run"]


def read(folder):
    """All runs of a sweep's folder as a pyarrow.Table, by number."""
    from trammel.sweep import store

    return store.read(folder)


def run(plan, folder, **options):
    """Makes the runs of a plan that are not in the folder yet; options as of main.perform()."""
    from trammel.sweep import main

    return main.perform(Plan(plan), folder, **options)
