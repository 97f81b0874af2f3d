# Copyright (c) 2026 The Point_set_skeletonization_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens pages in headless Chromium and uses them. Usage: check_page.py PAGE LARGE_PAGE POINT_PAGE; the
second is of more points than a page shows, the third of a single one"""

import hashlib
import pathlib
import sys
import time
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from browser import BrowserTest


class PageTest(BrowserTest):
    def setUp(self):
        self.open(self.page)

    def open(self, page):
        self.browser.get(page.resolve().as_uri())
        self.view = self.browser.find_element(By.CSS_SELECTOR, "#view canvas")

    def picture(self):
        """What is drawn, without the panel."""
        url = self.run_script("draw(); return renderer.domElement.toDataURL()")
        return hashlib.sha256(url.encode()).hexdigest()

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def point_at(self, x, y):
        size = self.view.size
        ActionChains(self.browser).move_to_element_with_offset(
            self.view, round(x) - size["width"] // 2, round(y) - size["height"] // 2).perform()

    def test_needs_nothing_else(self):
        requests = self.run_script(
            "return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in requests if not name.startswith("data:")], [])

    def test_a_switch_hides_and_shows(self):
        before = self.picture()
        for name in "show_cloud", "show_skeleton", "show_tips":
            self.element(name).click()
            self.assertNotEqual(before, self.picture())
            self.element(name).click()
            self.assertEqual(before, self.picture())

    def test_colours(self):
        before = self.picture()
        for name in "skeleton_colour", "cloud_colour":
            choice = Select(self.element(name))
            choice.select_by_value("branch")
            self.assertNotEqual(before, self.picture())
            choice.select_by_index(0)
            self.assertEqual(before, self.picture())
        Select(self.element("skeleton_colour")).select_by_value("order")
        self.assertEqual(self.element("scale_name").text, "order")

    def test_a_drag_turns_and_a_button_turns_back(self):
        before = self.picture()
        ActionChains(self.browser).move_to_element(self.view).click_and_hold() \
            .move_by_offset(150, 40).release().perform()
        self.wait_for(lambda: before != self.picture())
        self.element("reset").click()
        self.assertEqual(before, self.picture())

    def test_pointing_at_the_skeleton_tells_of_it(self):
        x, y = self.run_script(
            "const screen = projected(), middle = Math.floor(vertexCount / 2);"
            "return [screen[2 * middle], screen[2 * middle + 1]]")
        self.point_at(x, y)
        picked = self.element("picked")
        self.assertTrue(picked.is_displayed())
        for name in "radius", "branch", "its points":
            self.assertIn(name, picked.text)
        self.point_at(self.view.size["width"] - 5, 5)
        self.assertFalse(picked.is_displayed())

    def test_more_points_than_are_shown(self):
        self.open(self.large)
        self.assertIn("400,000", self.element("facts").text)
        self.assertIn("250,000 shown", self.element("shown_points").text)

    def test_frames(self):
        """How many there are is printed, not demanded: it depends on the machine. A slow one draws
        fewer than 30 and 30, but stops after five and five seconds all the same."""
        self.open(self.large)
        frames, seconds = self.browser.execute_async_script("""
            const [done, TICKS, MILLISECONDS] = [arguments[0], 30, 5000];
            let [ticks, start, first, isWarm] = [0, performance.now(), 0, false];
            function tick(now) {
              if (++ticks > TICKS || now - start > MILLISECONDS) {
                if (isWarm)
                  return done([renderer.info.render.frame - first, (now - start) / 1000]);
                // How many points to draw is known now.
                [ticks, start, first, isWarm] = [0, now, renderer.info.render.frame, true];
              }
              camera.position.applyAxisAngle(camera.up, 0.02);
              controls.update();
              requestAnimationFrame(tick);
            }
            requestAnimationFrame(tick);""")
        self.assertGreater(frames, 0)
        print(f"{frames / seconds:.1f} frames per second while turning, without a graphics card")

    def test_all_is_drawn_once_at_rest(self):
        state = ("return [renderer.info.render.frame, cloud.geometry.drawRange.count,"
                 "  motion.isRunning]")
        self.run_script("camera.position.applyAxisAngle(camera.up, 0.1); controls.update();")
        self.wait_for(lambda: not self.run_script(state)[2])
        at_rest = self.run_script(state)
        self.assertIsNone(at_rest[1])  # infinity
        time.sleep(0.5)
        self.assertEqual(at_rest, self.run_script(state))

    def test_a_single_point(self):
        self.open(self.point)
        self.assertIn("points\n1", self.element("facts").text)
        self.picture()


if __name__ == "__main__":
    PageTest.point = pathlib.Path(sys.argv.pop())
    PageTest.large = pathlib.Path(sys.argv.pop())
    PageTest.page = pathlib.Path(sys.argv.pop())
    unittest.main()
