# SPDX-License-Identifier: Apache-2.0
"""Mutants of a block: made, run against its test, proven, and the tables of the result."""
