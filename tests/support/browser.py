# SPDX-License-Identifier: Apache-2.0
"""Headless Chromium for tests of report pages; nothing is downloaded or asked of a network."""

import json
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from trammel_tools import python_tools

SKIPPED = 77  # CTest counts it as skipped


def need(verb):
    """Ends when selenium, Chromium or its driver is missing."""
    python_tools.need("selenium", verb)
    for program in ("chromium", "chromedriver"):
        if shutil.which(program) is None:
            print(f"{verb}: {program} is missing (trammel doctor)", file=sys.stderr)
            sys.exit(SKIPPED)


def start(width=1360, height=900):
    from selenium import webdriver
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("headless=new", "no-sandbox", "disable-gpu", "hide-scrollbars",
                     "disable-dev-shm-usage", "no-first-run", "disable-background-networking",
                     f"window-size={width},{height}"):
        options.add_argument(f"--{argument}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    service = webdriver.ChromeService(executable_path=shutil.which("chromedriver"))
    driver = webdriver.Chrome(options=options, service=service)
    driver.set_script_timeout(30)
    return driver


def resize(driver, width, height=900):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1,
                            "mobile": width < 500})


def prefer(driver, scheme):
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": scheme}]})


def open_page(driver, page):
    """Loads the page and waits until its plots are painted; milliseconds that took."""
    from selenium.webdriver.support.ui import WebDriverWait
    driver.get(Path(page).resolve().as_uri())
    WebDriverWait(driver, 30, 0.02).until(
        lambda d: d.execute_script("return document.documentElement.dataset.ready") == "yes")
    return driver.execute_script("return performance.getEntriesByName('painted')[0].startTime")


def complaints(driver):
    """Lines of the console that are more than information."""
    return [line["message"] for line in driver.get_log("browser")
            if line["level"] in ("SEVERE", "WARNING")]


def requests(driver):
    """Addresses asked for since the last call."""
    found = []
    for line in driver.get_log("performance"):
        message = json.loads(line["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            found.append(message["params"]["request"]["url"])
    return found
