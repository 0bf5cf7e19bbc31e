# SPDX-License-Identifier: Apache-2.0
"""Coverage of the C++ code: gcovr over the counts that the sanitized build left."""
