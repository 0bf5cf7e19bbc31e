# SPDX-License-Identifier: Apache-2.0
"""python -m trammel sweep PLAN.toml or tune STUDY.toml, where the launcher is not installed."""

import importlib
import sys


def main() -> int:
    verb = sys.argv[1] if len(sys.argv) > 1 else ""
    if verb not in ("sweep", "tune"):
        print("usage: python -m trammel sweep PLAN.toml, or tune STUDY.toml; each has --help",
              file=sys.stderr)
        return 2
    sys.argv = [sys.argv[0], *sys.argv[2:]]
    return importlib.import_module(f"trammel.{verb}.main").main()


if __name__ == "__main__":
    sys.exit(main())
