# SPDX-License-Identifier: Apache-2.0
"""Random input to the program, and disks and signals against it."""
