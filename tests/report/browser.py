"""Headless Chromium on a page of this machine, through its driver."""
import contextlib
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

SLOW = 60   # [s] for a page that draws a dozen charts beside other tests


@contextlib.contextmanager
def chromium(width=1280, height=900, dark=False):
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--hide-scrollbars",
                     f"--window-size={width},{height}", *(["--force-dark-mode"] if dark else [])):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    try:
        yield driver
    finally:
        driver.quit()


def open_page(driver, file):
    driver.get("file://" + file)
    deadline = time.time() + SLOW
    while time.time() < deadline:
        if driver.execute_script("return document.documentElement.dataset.ready") == "true":
            return
        time.sleep(0.1)
    raise AssertionError("the page did not become ready: " + str(driver.get_log("browser")))
