# SPDX-License-Identifier: Apache-2.0
"""What reads the sources in rtl/: lint, and Yosys."""
