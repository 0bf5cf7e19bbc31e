# SPDX-License-Identifier: Apache-2.0
"""The best values of keys, searched by Optuna with the runs of a sweep."""

from trammel.tune.study import Study, StudyError

__all__ = ["Study", "StudyError"]
