# SPDX-License-Identifier: Apache-2.0
"""The tools around the sources: lint, proofs, mutants, synthesis, waves, generators, checks.

A module with a `main` is a tool, which scripts/tool runs; main returns the exit code.
"""
