# SPDX-License-Identifier: Apache-2.0
"""The best values of keys, searched by Optuna with the runs of a sweep.

    from trammel import tune
    trials, best = tune.run("study.toml", "out/study")
    best[0].params, best[0].values
"""

from trammel.tune.study import Study, StudyError

__all__ = ["Study", "StudyError", "run"]


def run(study, folder, **options):
    """Makes the trials of a study that are not in the folder yet; options as of main.perform().
    Returns all trials and the best of them, as Optuna has them."""
    from trammel.tune import main

    return main.perform(Study(study), folder, **options)
