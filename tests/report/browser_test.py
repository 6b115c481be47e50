"""The pages in headless Chromium: no error, no request, charts and legends work, and the numbers shown are study.json's."""
import json
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.environ["SIMILITUDE_SOURCE"], "tests/cli"))
from browser import chromium, open_page   # noqa: E402
from command import SMALL, CommandTest   # noqa: E402

CASE = SMALL.replace("vtk: every 5 ms", "vtk: none")
# A failed case and a metric with a gap are part of the picture.
STUDY = """\
similitude_study: 1
title: three choices
base: case.yaml
cases:
  - {name: gidaspow}
  - {name: di_felice, set: {models.drag: di_felice}}
  - {name: half_size, set: {models.scaling: {id: terminal_velocity, geometry: 0.5}}}
  - {name: soft, set: {models.contact.stiffness: 0.01 N/m}}
reference: gidaspow
metrics: [gas_fraction_profile, pressure_drop, bed_height, dominant_frequency, momentum_residual]
from: 3 ms
repeats: 1
"""


def at(page, path):
    for key in path.split("."):
        page = page[int(key)] if isinstance(page, list) else page[key]
    return page


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = CommandTest()
        made.folder = cls.folder = tempfile.TemporaryDirectory(prefix="similitude_pages_")
        made.write(CASE.replace("{end: 10 ms, dt: auto}", "{end: 60 ms, dt: auto}"))
        made.write(STUDY, "study.yaml")
        done = made.command("study", "study.yaml", "-o", "out")
        assert done.returncode == 1, done.stdout + done.stderr   # soft stops
        with open(made.path("out/study.json"), encoding="utf-8") as file:
            cls.study = json.load(file)
        cls.path = staticmethod(made.path)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def each_page(self):
        return [self.path("out/report.html"), self.path("out/gidaspow/report.html"), self.path("out/soft/report.html")]

    def test_pages_draw_without_an_error_and_ask_for_nothing(self):
        for page in self.each_page():
            with chromium() as driver:
                open_page(driver, page)
                self.assertEqual(driver.get_log("browser"), [])
                sent = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
                asked = {event["params"]["request"]["url"] for event in sent if event["method"] == "Network.requestWillBeSent"}
                self.assertEqual({url for url in asked if not url.startswith("data:")}, {"file://" + page})
                self.assertGreater(driver.execute_script("return charts.length"), 1)
                blank = driver.execute_script("""return charts.filter((entry) => {
                    const {width, height} = entry.canvas;
                    return !entry.canvas.getContext("2d").getImageData(0, 0, width, height).data.some((byte) => byte !== 0);
                  }).map((entry) => entry.name)""")
                self.assertEqual(blank, [])

    def test_what_is_asked_of_a_network_is_refused(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            self.assertEqual(driver.execute_async_script(
                "const done = arguments[0]; fetch('https://example.org/').then(() => done('sent'), () => done('refused'))"), "refused")
            self.assertTrue(any("Content Security Policy" in entry["message"] for entry in driver.get_log("browser")))

    def test_numbers_on_the_page_are_those_of_study_json(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            shown = driver.execute_script(
                "return [...document.querySelectorAll('[data-path]')].map((td) => [td.dataset.path, td.dataset.value, td.textContent])")
            self.assertGreater(len(shown), 30)
            for path, value, words in shown:
                self.assertEqual(float(value), at(self.study, path), path)
                self.assertNotEqual(words, "")
            self.assertEqual(driver.execute_script("return document.getElementById('advice').textContent"), self.study["advice"])
            plotted = driver.execute_script(
                "return charts[0].chart.data.datasets.filter((set) => set.named).map((set) => [set.label, set.data[0].x, set.data[0].y])")
            metric = self.study["frontier"]["metric"]
            done = [case for case in self.study["cases"] if case["status"] == "done"]
            self.assertEqual(plotted, [[case["name"], case["wall_s"], 100 * case["error"][metric]["value"]] for case in done])

    def test_a_failed_case_is_named_with_its_reason(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            text = driver.execute_script("return document.getElementById('frontier').textContent")
            self.assertIn("soft is stopped: ", text)

    def test_legends_hide_and_show_a_case(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            click = """const chart = charts[0].chart, item = chart.legend.legendItems[1];
                       chart.options.plugins.legend.onClick.call(chart.legend, {}, item, chart.legend);
                       return chart.isDatasetVisible(1)"""
            self.assertFalse(driver.execute_script(click))
            self.assertTrue(driver.execute_script(click))
            # In bars a stage goes together with what was foretold of it.
            hidden = driver.execute_script("""const chart = charts.find((entry) => entry.name === "wall time by stage").chart, item = chart.legend.legendItems[0];
                chart.options.plugins.legend.onClick.call(chart.legend, {}, item, chart.legend);
                return chart.data.datasets.map((set, k) => [set.label === item.text, chart.isDatasetVisible(k)])""")
            self.assertTrue(all(visible != same for same, visible in hidden), hidden)

    def test_choosers_the_player_and_the_theme_work(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            driver.execute_script("""document.querySelectorAll("select").forEach((select) => { for (const option of select.options) {
                select.value = option.value; select.dispatchEvent(new Event("change")); } })""")
            before = driver.execute_script("return document.querySelector('.beds canvas').toDataURL()")
            driver.execute_script("const slider = document.getElementById('bed-time'); slider.value = 100; slider.dispatchEvent(new Event('input'))")
            self.assertNotEqual(driver.execute_script("return document.querySelector('.beds canvas').toDataURL()"), before)
            theme = driver.execute_script("return document.documentElement.dataset.theme")
            driver.execute_script("document.getElementById('theme').click()")
            self.assertNotEqual(driver.execute_script("return document.documentElement.dataset.theme"), theme)
            self.assertEqual(driver.get_log("browser"), [])

    def test_nothing_is_wider_than_a_telephone(self):
        with chromium(width=500) as driver:
            open_page(driver, self.each_page()[0])
            self.assertLessEqual(driver.execute_script("return document.documentElement.scrollWidth - window.innerWidth"), 0)

    def test_charts_and_controls_have_names(self):
        with chromium() as driver:
            open_page(driver, self.each_page()[0])
            nameless = driver.execute_script("""return [...document.querySelectorAll("canvas, select, input, button")].filter((one) =>
                !(one.getAttribute("aria-label") || one.textContent.trim() && one.tagName === "BUTTON" || one.closest("label"))).map((one) => one.outerHTML)""")
            self.assertEqual(nameless, [])
            self.assertEqual(driver.execute_script("return document.querySelectorAll('h1').length"), 1)


if __name__ == "__main__":
    unittest.main()
