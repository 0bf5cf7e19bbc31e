# SPDX-License-Identifier: Apache-2.0
"""Wave files: read, compared, drawn."""
