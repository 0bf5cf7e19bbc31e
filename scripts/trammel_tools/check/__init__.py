# SPDX-License-Identifier: Apache-2.0
"""Checks of the repository, its documentation, its builds and what the tests cover."""
