"""Opens the made-up report in headless Chromium and uses it. Usage: check_report.py REPORT"""

import hashlib
import json
import pathlib
import re
import sys
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

sys.path.append(str(pathlib.Path(__file__).parents[1]))
from browser import BrowserTest

PAPER = pathlib.Path(__file__).parents[2] / "benchmark/report/paper_table_1.json"
STATUS = {"failed": "failed", "time_limit": "time limit", "invalid": "invalid result",
          "unreadable": "unreadable"}


class ReportTest(BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        text = cls.report.read_text(encoding="utf-8")
        cls.rows = json.loads(re.search(r'id="results">(.*?)</script>', text, re.S)[1])["rows"]

    def setUp(self):
        self.browser.get(self.report.resolve().as_uri())

    def find(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def choose_noise(self, noise):
        labels = {option.get_attribute("value"): option for option in self.find("#noise option")}
        labels[f"{noise:g}"].click()

    def cell(self, input_name, method):
        """The gallery's cell, in sight and drawn."""
        def canvas():
            return self.run_script(
                "return [...document.querySelectorAll('.cell canvas')].find((canvas) =>"
                " canvas.row.input === arguments[0] && canvas.row.method === arguments[1])",
                input_name, method)

        self.wait_for(canvas)  # on a busy machine the gallery may not be there yet
        found = canvas()
        self.run_script("arguments[0].scrollIntoView({block: 'center'})", found)
        self.wait_for(lambda: "drawn" in found.get_attribute("class"))
        return found

    def picture(self, input_name, method):
        url = self.run_script("return arguments[0].toDataURL()", self.cell(input_name, method))
        return hashlib.sha256(url.encode()).hexdigest()

    def view(self):
        """What the view shows."""
        return hashlib.sha256(self.find("#view canvas")[0].screenshot_as_png).hexdigest()

    def texts(self, selector):
        return self.run_script(
            "return [...document.querySelectorAll(arguments[0])].map((e) => e.textContent)",
            selector)

    def shown_rows(self):
        """The texts of the rows of the large table that no filter hides."""
        return self.run_script(
            "return [...document.querySelectorAll('#row_table tbody tr:not(.filtered)')]"
            ".map((line) => [...line.cells].map((cell) => cell.textContent))")

    def column(self, label):
        return self.texts("#row_table thead tr:first-child th").index(label)

    def shown_column(self, label):
        column = self.column(label)
        return [line[column] for line in self.shown_rows()]

    def click_head(self, label):
        head = self.find("#row_table thead tr:first-child th")[self.column(label)]
        self.run_script("arguments[0].scrollIntoView({block: 'center'})", head)
        head.click()

    def test_needs_nothing_else(self):
        requests = self.run_script(
            "return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in requests if not name.startswith("data:")], [])

    def test_a_cell_for_every_row(self):
        for noise in sorted({row["noise"] for row in self.rows}):
            self.choose_noise(noise)
            rows = [row for row in self.rows if row["noise"] == noise and row["seed"] == 0]
            self.assertEqual(len(self.find(".cell")), len(rows))
            for status, label in STATUS.items():
                cells = self.find(f".cell.{status}")
                self.assertEqual(len(cells), sum(row["status"] == status for row in rows))
                for cell in cells:
                    self.assertIn(label, cell.text)

    def test_texts_stay_texts(self):
        for row in self.rows:
            if row["status"] == "failed" and row["noise"] == 0:
                titles = [e.get_attribute("title") for e in self.find(".cell.failed .warning")]
                self.assertIn(row["message"], titles)
        heads = self.texts("#pictures thead th")
        self.assertEqual(heads[1:], list(dict.fromkeys(row["input"] for row in self.rows)))

    def test_pictures_show_the_junctions(self):
        count_red = """
          const { data } = arguments[0].getContext('2d').getImageData(0, 0, 320, 320);
          let count = 0;
          for (let i = 0; i < data.length; i += 4)
            count += data[i] > 180 && data[i + 1] < 80 && data[i + 2] < 80;
          return count;"""
        self.assertEqual(self.run_script(count_red, self.cell("ring", "l1_medial")), 0)
        one = self.run_script(count_red, self.cell("y_junction", "l1_medial"))
        self.assertGreater(one, 20)
        self.assertLess(one, 400)

    def test_a_drag_turns_the_model(self):
        before = self.picture("y_junction", "mcf"), self.picture("ring", "mcf")
        self.cell("y_junction", "mcf").click()
        view = self.find("#view canvas")[0]
        self.assertTrue(self.find("#viewer")[0].is_displayed())
        first = self.view()
        self.assertEqual(first, self.view())
        ActionChains(self.browser).move_to_element(view).click_and_hold() \
            .move_by_offset(150, 40).release().perform()
        self.wait_for(lambda: first != self.view())
        turned = self.view()
        ActionChains(self.browser).move_to_element(view).move_by_offset(-150, 90).perform()
        self.assertEqual(turned, self.view())  # only as long as the button is down
        ActionChains(self.browser).send_keys(Keys.ESCAPE).perform()
        self.assertFalse(self.find("#viewer")[0].is_displayed())
        self.assertNotEqual(before[0], self.picture("y_junction", "mcf"))
        self.assertEqual(before[1], self.picture("ring", "mcf"))

    def test_the_view_steps_through_the_methods(self):
        self.cell("two_parts", "poisson_mcf").click()
        method, status = self.find("#view_method")[0], self.find("#view_status")[0]
        self.assertEqual(method.text, "Poisson, MCF")
        self.assertIn("failed: </script>", status.text)
        ActionChains(self.browser).send_keys(Keys.ARROW_LEFT).perform()
        self.assertEqual(method.text, "Alpha wrap, MCF")
        self.assertEqual(status.text, "")
        self.find("#next")[0].click()
        self.assertEqual(method.text, "Poisson, MCF")
        self.find("#close")[0].click()
        self.assertFalse(self.find("#viewer")[0].is_displayed())

    def test_the_large_table_sorts(self):
        self.assertEqual(len(self.shown_rows()), len(self.rows))
        for label in "seconds", "moved":
            for reverse in False, True:
                before = self.shown_column(label)
                numbers = sorted((float(text) for text in before if text), reverse=reverse)
                empty = [""] * (len(before) - len(numbers))
                self.click_head(label)
                self.wait_for(lambda: before != self.shown_column(label))
                after = self.shown_column(label)
                self.assertEqual([float(text) for text in after[:len(numbers)]], numbers)
                self.assertEqual(after[len(numbers):], empty)
        methods = sorted(self.shown_column("method"), key=str.lower)
        self.click_head("method")
        self.wait_for(lambda: methods == self.shown_column("method"))

    def test_the_large_table_filters(self):
        filters = self.find("#row_table .tablesorter-filter")
        Select(filters[self.column("method")]).select_by_visible_text("Wave Fronts")
        self.wait_for(lambda: len(self.shown_rows()) < len(self.rows))
        wanted = sum(
            row["method"] == "wave_fronts" and row["input_kind"] == "mesh" for row in self.rows)
        self.assertEqual(self.shown_column("method"), ["Wave Fronts"] * wanted)
        Select(filters[self.column("method")]).select_by_index(0)
        filters[self.column("seconds")].send_keys(">100")
        wanted = sum(row["seconds"] > 100 for row in self.rows)
        self.wait_for(lambda: len(self.shown_rows()) == wanted)

    def test_table_1_is_the_papers(self):
        paper = json.loads(PAPER.read_text(encoding="utf-8"))
        labels = self.texts("#second_table tbody tr:not(.stage) th")
        lines = self.find("#second_table tbody tr:not(.stage)")
        for label, theirs in ("ROSA", "ROSA"), ("As published", "Our Method"):
            cells = lines[labels.index(label)].find_elements(By.CSS_SELECTOR, "td.paper")
            seconds = next(m["seconds"] for m in paper["methods"] if m["name"] == theirs)
            self.assertEqual([float(cell.text) for cell in cells], seconds)
        ours = lines[labels.index("ROSA")].find_elements(By.CSS_SELECTOR, "td:not(.paper)")
        self.assertIn("time limit", [cell.text for cell in ours])
        self.assertIn("another machine", self.find("#seconds")[0].text)

    def test_table_1_sorts_with_its_stages(self):
        def lines():
            return self.texts("#second_table tbody th")
        def numbers():
            texts = self.run_script(
                "return [...document.querySelectorAll('#second_table tbody tr:not(.stage)')]"
                ".map((line) => line.cells[1].textContent)")
            return [float(text) for text in texts if text]
        before = lines()
        self.assertNotEqual(numbers(), sorted(numbers()))
        head = self.find("#second_table thead tr:last-child th")[1]
        self.run_script("arguments[0].scrollIntoView({block: 'center'})", head)
        head.click()
        self.wait_for(lambda: numbers() == sorted(numbers()))
        self.assertEqual(len(numbers()), 9)
        self.assertEqual(sorted(before), sorted(lines()))
        self.assertEqual(lines()[lines().index("LapCon08VC") + 1], "contraction (paper)")

    def test_plots(self):
        shapes = len({row["input"] for row in self.rows if row["status"] == "ok"})
        self.assertEqual(len(self.find("#junction_plots canvas")), shapes)
        self.assertEqual(len(self.find("#stability_plots canvas")), shapes)
        self.assertEqual(len(self.find("#second_plot canvas")), 1)
        visible = "return charts.every((chart) => chart.isDatasetVisible(0))"
        self.assertTrue(self.run_script(visible))
        entry = self.find("#legend button")[0]
        self.run_script("arguments[0].scrollIntoView({block: 'center'})", entry)
        entry.click()
        self.assertFalse(self.run_script(visible))
        self.assertEqual(entry.get_attribute("aria-pressed"), "false")
        self.choose_noise(0.01)
        self.assertFalse(self.run_script(visible))  # also in what was drawn anew

    def test_a_junction_plot_shows_the_mean_of_the_counts(self):
        shown = self.run_script(
            "const data = Chart.getChart(document.querySelector('#junction_plots canvas')).data;"
            "return data.datasets.find((set) => set.label === 'L1-WLOP').data"
            ".map(({ x, y }) => [x, countAxis.fromAxis(y)])")
        rows = [row for row in self.rows
                if row["method"] == "l1_wlop" and row["input"] == self.rows[0]["input"]]
        wanted = [[row["noise"], row["metrics"]["junctions"] + 2]  # seed 1 has four more
                  for row in rows if row["seed"] == 0]
        self.assertEqual(len(rows), 2 * len(wanted))
        self.assertEqual(shown, wanted)

    def test_every_figure_says_over_how_many_seeds_it_is(self):
        self.assertEqual(set(self.texts("span.seeds")), {"mean of 2 seeds"})
        self.assertEqual(len(self.find("h3 span.seeds")), len(self.find("#plots h3")))
        self.assertEqual(len(self.find("#seconds span.seeds")), 1)
        self.assertEqual(self.texts("#first_seed"), ["seed 0"])

    def test_wrong_components_are_marked(self):
        metrics = [row["metrics"] for row in self.rows
                   if row["noise"] == 0 and row["seed"] == 0 and row["metrics"]]
        wrong = [m for m in metrics if m["true_components"] not in (None, m["components"])]
        self.assertGreater(len(wrong), 0)
        marked = [text for text in self.texts(".caption .wrong") if text.startswith("components")]
        self.assertEqual(len(marked), len(wrong))


if __name__ == "__main__":
    ReportTest.report = pathlib.Path(sys.argv.pop())
    unittest.main()
