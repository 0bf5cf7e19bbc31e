# SPDX-License-Identifier: Apache-2.0
"""The prover: properties files, their proof, the leap of a chip, the table of promises."""
