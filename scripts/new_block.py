#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the five files of a new block: scripts/tool new-block, under the name of the tutorial."""

import sys

from trammel_tools import tools

sys.exit(tools.settled(lambda: tools.run("new-block", sys.argv[1:])))
