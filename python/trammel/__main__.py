# SPDX-License-Identifier: Apache-2.0
"""python -m trammel sweep PLAN.toml, where the package is installed without the launcher."""

import sys


def main() -> int:
    verb = sys.argv[1] if len(sys.argv) > 1 else ""
    if verb != "sweep":
        print("usage: python -m trammel sweep PLAN.toml; see sweep --help", file=sys.stderr)
        return 2
    sys.argv = [sys.argv[0], *sys.argv[2:]]
    from trammel.sweep.main import main as sweep

    return sweep()


if __name__ == "__main__":
    sys.exit(main())
