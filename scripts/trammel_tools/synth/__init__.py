# SPDX-License-Identifier: Apache-2.0
"""Synthesis for FPGAs: flow, netlist, report."""
