# SPDX-License-Identifier: Apache-2.0
"""Generators of sources and pages, and of new blocks and machines."""
