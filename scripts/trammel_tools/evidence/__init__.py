# SPDX-License-Identifier: Apache-2.0
"""Results of checks that are kept with the hash of all that they depend on."""
