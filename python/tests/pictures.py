# SPDX-License-Identifier: Apache-2.0
"""Make the pictures of docs/one-to-a-million.md again, from what that page shows: its sweep, its
study, and its block of Python that draws; and the circle of README.md.

usage: PYTHONPATH=build/python .venv/bin/python3 python/tests/pictures.py

Sweep and study go to out/; a study of one trial at a time always comes to the same. The block needs
matplotlib, which nothing else here does (pip install matplotlib). Takes some minutes.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "support"))
sys.path.insert(1, str(Path(__file__).resolve().parents[2] / "scripts"))
import browser
import trammel
from trammel_tools import picture

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "one-to-a-million.md"
PICTURES = ROOT / "docs" / "pictures"
SWEEP = ["sweep", "examples/payload.toml"]
STUDY = ["tune", "examples/gains.toml", "--trials", "40", "--jobs", "1"]
# (folder in out/, picture of its page, choices, file)
DRAWN = (("payload", "scatter", {"y": "tracking.model.mean_mm", "x": "plant.payload_kg",
                                 "color": "controller"}, "sweep.svg"),
         ("gains", "parallel", {"color": "max tracking.model.mean_mm"}, "tune.svg"))
WIDTH = 860


def drawn(driver, folder, name, choices):
    """A picture of a page, as its button saves it."""
    browser.resize(driver, WIDTH)
    driver.get((ROOT / "out" / folder / "page.html").as_uri())
    for key, value in choices.items():
        driver.execute_script("byId(arguments[0]).value = arguments[1]; draw()", key, value)
    return driver.execute_script("return svgOf(arguments[0])", name)


def by_block():
    """The block of the page that saves a picture, in the folder of the pictures."""
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "trammel", "savefig.bbox": "tight"})
    blocks = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text("utf-8"), re.M | re.S)
    text = next(block for block in blocks if "savefig" in block)
    os.chdir(PICTURES)
    exec(compile(text, PAGE.name, "exec"), {"trammel": trammel})
    for file in re.findall(r'savefig\("(.*?)"', text):
        write(file, Path(file).read_text("utf-8"))


def write(file, text):
    (PICTURES / file).write_text(picture.slim(text), "utf-8")
    print(PICTURES / file)


def main():
    browser.need("pictures")
    for words in (["run", "circle"], SWEEP, STUDY):
        subprocess.run([sys.executable, "-m", "trammel", *words], check=True, cwd=ROOT)
    driver = browser.start(WIDTH)
    try:
        for folder, name, choices, file in DRAWN:
            write(file, drawn(driver, folder, name, choices))
    finally:
        driver.quit()
    by_block()
    write("circle.svg", (ROOT / "out" / "circle" / "path.svg").read_text("utf-8"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
