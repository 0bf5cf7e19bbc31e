#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How long headless Chromium takes from opening a report to painted plots.

usage: report_open.py PAGE...     prints the first load of a fresh browser and the median of 7
"""

import statistics
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))
import browser


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0 if len(sys.argv) > 1 else 2
    browser.need("report_open")
    for page in sys.argv[1:]:
        driver = browser.start()
        times = [browser.open_page(driver, page) for _ in range(7)]
        driver.quit()
        size = Path(page).stat().st_size
        print(f"{page}: {size} bytes; first load {times[0]:.0f} ms, "
              f"median {statistics.median(times):.0f} ms")
    return 0


if __name__ == "__main__":
    sys.exit(main())
