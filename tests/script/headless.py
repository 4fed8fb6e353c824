# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium for tests of pages; without Chromium or Selenium they say so and test nothing more."""

import shutil
import sys

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    webdriver = None


def browser(work, what, **logs):
    """A browser whose profile is in the folder work; logs: of which kinds, by Chromium's names. Without one the program ends,
    what was not tested said."""
    driver = shutil.which("chromedriver")
    if not webdriver or not driver:
        print(f"{what} not tested: no Chromium or Selenium, script/test --all installs chromium-driver and python3-selenium")
        sys.exit(77)
    options = webdriver.ChromeOptions()
    for each in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1300,1000", f"--user-data-dir={work}/profile"):
        options.add_argument(each)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", **logs})
    return webdriver.Chrome(service=Service(driver), options=options)


def complaints(browser):
    """What its console has of errors and warnings."""
    return [each for each in browser.get_log("browser") if each["level"] in ("SEVERE", "WARNING")]
