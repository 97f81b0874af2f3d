# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Headless Chromium, for the tests of pages."""

import tempfile
import unittest

from selenium import webdriver
from selenium.webdriver.common.utils import is_connectable
from selenium.webdriver.support.ui import WebDriverWait

# By a pipe, not by a port: a minimal system knows no host `localhost`.
SWITCHES = """--headless --no-sandbox --disable-gpu --use-gl=angle --use-angle=swiftshader
  --enable-unsafe-swiftshader --disable-quic --no-first-run --disable-background-networking
  --disable-component-update --disable-sync --remote-debugging-pipe --window-size=1500,1000"""


# Software rendering on a busy machine may take seconds a frame; nothing is judged by this.
PATIENCE = 300  # seconds


class Service(webdriver.chrome.service.Service):
    """The browser's driver by its number: a minimal system knows no host `localhost`."""

    @property
    def service_url(self):
        return f"http://127.0.0.1:{self.port}"

    def is_connectable(self):
        return is_connectable(self.port, "127.0.0.1")


def start_browser(profile):
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for switch in SWITCHES.split() + [f"--user-data-dir={profile}"]:
        options.add_argument(switch)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = Service("/usr/bin/chromedriver")
    return webdriver.Chrome(service=service, options=options)


class BrowserTest(unittest.TestCase):
    """Has a browser of its own, with an empty profile, for all its tests."""

    @classmethod
    def setUpClass(cls):
        cls.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(cls.profile.cleanup)
        cls.browser = start_browser(cls.profile.name)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.set_script_timeout(PATIENCE)

    def tearDown(self):
        errors = [line for line in self.browser.get_log("browser") if line["level"] == "SEVERE"]
        self.assertEqual(errors, [])

    def run_script(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def wait_for(self, condition):
        """What a page does a little later."""
        return WebDriverWait(self.browser, PATIENCE).until(lambda _: condition())
