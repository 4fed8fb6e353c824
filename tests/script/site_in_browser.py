# SPDX-License-Identifier: BSD-3-Clause
"""site_in_browser.py GRIT SOURCE WORK: script/site makes a site whose links lead to pages and headings that are there and whose
pages fetch nothing from elsewhere; in headless Chromium, opened from the folder, its search finds a function, an equation, a key
and a symbol in Greek, and a click on a result comes to its heading."""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

import headless

grit, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
if subprocess.run(["/usr/bin/python3", "-c", "import mkdocs"], capture_output=True).returncode:
    print("not tested: no MkDocs, script/test --all installs mkdocs")
    sys.exit(77)
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
site = work / "site"
built = subprocess.run([source / "script/site", "--grit", grit, "--out", site], capture_output=True, text=True)
assert built.returncode == 0, built.stdout + built.stderr


class Page(html.parser.HTMLParser):
    """Headings by their names, links, and what a browser fetches by itself."""

    def __init__(self, file):
        super().__init__()
        self.names, self.links, self.fetched = set(), [], []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.names.add(attributes.get("id"))
        if tag == "a" and "href" in attributes:
            self.links.append(attributes["href"])
        self.fetched += [attributes[name] for name in ("src", "href", "srcset", "poster", "data", "action")
                         if name in attributes and not (tag == "a" and name == "href")]


files = sorted(site.rglob("*.html"))
pages = {file.resolve(): Page(file) for file in files}
wrong, followed = [], 0
for file, page in pages.items():
    for target in page.fetched + page.links:
        if file.name == "404.html" or target == "." or target.startswith("#") and target[1:] in ("", *filter(None, page.names)):
            continue
        place, _, name = urllib.parse.unquote(target).partition("#")
        if re.match(r"[a-z]+:|//", target):
            if target in page.fetched:
                wrong.append(f"{file.name} fetches {target}")
            continue
        followed += 1
        other = (file.parent / place).resolve() if place else file
        if not other.is_file():
            wrong.append(f"{file.relative_to(site)}: {target}: there is no such file")
        elif name and other in pages and name not in pages[other].names:
            wrong.append(f"{file.relative_to(site)}: {target}: no heading is called so")
for file in [*site.rglob("*.css"), *site.glob("js/*.js"), *site.glob("search/*.js")]:
    text = file.read_text()
    for target in re.findall(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)", text) if file.suffix == ".css" else []:
        target = "".join(target)
        if re.match(r"https?:|//", target):
            wrong.append(f"{file.name} fetches {target}")
        elif not target.startswith("data:") and not (file.parent / re.split(r"[?#]", target)[0]).resolve().is_file():
            wrong.append(f"{file.name}: {target}: there is no such file")
assert not wrong, "\n".join(wrong[:40])
assert len(files) > 100 and followed > 5000, (len(files), followed)
words = (site / "reference/sand.html").read_text()
assert "The increment" not in words and 'id="grit_sand_update"' in words, "a page of a header"
assert 'href="sand.html"' in (site / "reference/grit.html").read_text().split('role="main"')[1], "a header of headers links to these"
assert "relaxation_time_s" in (site / "keys/mpm.html").read_text(), "keys that the program prints"
print(f"{len(files)} pages, {followed} links")
words_of_site = set((site / "search/main.js").read_text().replace("\\n", " ").replace('"', " ").split())

browser = headless.browser(work, "search", performance="ALL")
from selenium.webdriver.common.by import By
from selenium.webdriver.support.expected_conditions import staleness_of
from selenium.webdriver.support.ui import WebDriverWait

try:
    def search(words):
        """Typed into the box of the page that is open; titles of what is found."""
        box = browser.find_element(By.CSS_SELECTOR, "#rtd-search-form input")
        box.clear()
        box.send_keys(words)
        box.submit()
        # Else what is read is that of the page before, until the browser leaves it.
        WebDriverWait(browser, 60).until(staleness_of(box))
        WebDriverWait(browser, 60).until(lambda b: b.execute_script("return document.readyState") == "complete")
        return browser.execute_script("return [...document.querySelectorAll('#mkdocs-search-results h3 a')].map(each => each.textContent)")

    browser.get((site / "index.html").as_uri())
    browser.set_window_size(1300, 1000)
    browser.save_screenshot(str(work / "home.png"))
    assert browser.execute_script("return typeof jQuery") == "function", "the theme's own script"
    found = search("grit_contact_correct")
    assert found[0] == "grit_contact_correct", found[:5]
    browser.save_screenshot(str(work / "search.png"))
    browser.find_element(By.LINK_TEXT, "grit_contact_correct").click()
    assert browser.current_url.endswith("reference/contact.html#grit_contact_correct"), browser.current_url
    top = browser.execute_script("return document.getElementById('grit_contact_correct').getBoundingClientRect().top")
    assert -5 < top < 900, f"the heading is at {top}"
    browser.save_screenshot(str(work / "clicked.png"))
    assert any("Material points" in each or "Hypoplasticity" in each for each in search("(H9)")), "an equation"
    assert search("φ_c degree"), "a symbol"
    found = search("steps of incrementalDriver")
    places = [each.get_attribute("href") for each in browser.find_elements(By.CSS_SELECTOR, "#mkdocs-search-results h3 a")]
    assert not any("start/incremental-driver.html" == each.split("/site/")[1] for each in places), "a page of one section twice"
    for each in browser.find_elements(By.CSS_SELECTOR, "#mkdocs-search-results p:not(#search-count)"):
        begin = each.text.split(" ")[:2]
        assert begin[0] != "..." or begin[1] in words_of_site, f"cut: {begin}"
    browser.get((site / "keys/mpm.html").as_uri())
    broken = browser.execute_script("""return [...document.querySelectorAll("td:nth-child(-n+2) code")]
        .filter(each => each.getClientRects().length > 1).map(each => each.textContent)""")
    assert not broken, f"keys on two lines: {broken[:5]}"
    browser.save_screenshot(str(work / "keys.png"))
    browser.back()
    assert "Oedometer, loaded" not in search("oedometer") and len(search("oedometer")) > 5
    assert search("no_such_word_anywhere") == []
    assert "No section" in browser.find_element(By.ID, "search-count").text
    assert not (log := headless.complaints(browser)), log
    asked = {match for each in browser.get_log("performance") if "requestWillBeSent" in each["message"]
             for match in re.findall(r'"url":"(\w+:)', each["message"])}
    assert "file:" in asked and not asked & {"http:", "https:", "ws:", "wss:"}, asked
    print(f"searched in the browser; addresses of {' '.join(sorted(asked))}")
finally:
    browser.quit()
