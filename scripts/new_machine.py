#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the files of a new machine: scripts/tool new-machine, under the name of the tutorial."""

import sys

from trammel_tools import tools

sys.exit(tools.settled(lambda: tools.run("new-machine", sys.argv[1:])))
