# SPDX-License-Identifier: BSD-3-Clause
"""report_in_browser.py GRIT SOURCE WORK: results of an element test, of material points, a table and a benchmark in one
page, in headless Chromium: no error in its console, every plot has its data, hovering tells values, names of the key turn
series off and on, dragging zooms, frames play."""

import json
import pathlib
import shutil
import subprocess
import sys
import time

import headless

grit, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shutil.rmtree(work, ignore_errors=True)
results = work / "results"
results.mkdir(parents=True)


def run(*arguments):
    subprocess.run([grit, *map(str, arguments)], check=True, capture_output=True)


run("element", source / "verification/cases/lausitz_dense.toml", "--no-plot", "--out", results)
run("mpm", source / "tests/script/falling.toml", "--no-plot", "--out", results)
run("mpm", source / "tests/script/falling_in_space.toml", "--no-plot", "--out", results)
(results / "table.csv").write_text("time [s],first [kPa],second [kPa]\n" + "".join(f"{i},{i * i},{20 - i}\n" for i in range(12)))
(results / "speed.json").write_text(json.dumps({"benchmarks": [{"name": "update/7", "cpu_time": 12.5, "time_unit": "ns"}]}))
run("report", results, "--title", "A page")

browser = headless.browser(work, "page")
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

try:
    browser.get((results / "index.html").as_uri())
    script = browser.execute_script

    # Every plot has its data.
    counts = script("""return [...document.querySelectorAll('.curves')].map(place =>
        [JSON.parse(place.querySelector('script').textContent).map(panel => panel.series.map(s => s.x.length)),
         [...place.querySelectorAll('canvas')].map(c => Chart.getChart(c).data.datasets.map(s => s.data.length))])""")
    assert len(counts) == 4, counts
    for given, drawn in counts:
        assert len(given) == len(drawn) > 0 and all(len(each) > 0 for each in drawn), (given, drawn)
        assert min(n for each in drawn for n in each) > 1, drawn
    assert len(counts[2][1]) == 4, counts  # a triaxial test: q, volume, path, void ratio

    table = browser.find_element(By.CSS_SELECTOR, "section#table canvas")
    script("arguments[0].scrollIntoView({block: 'center'})", table)
    chart = "const chart = Chart.getChart(document.querySelector('section#table canvas'));"
    width, height = script("return [arguments[0].clientWidth, arguments[0].clientHeight]", table)

    def at(place):
        return round(place[0] - width / 2), round(place[1] - height / 2)

    def point(x, y):
        return at(script(chart + f"return [chart.scales.x.getPixelForValue({x}), chart.scales.y.getPixelForValue({y})]"))

    def hover(x, y):
        ActionChains(browser).move_to_element_with_offset(table, *point(x, y)).perform()
        time.sleep(0.2)
        return script(chart + "return chart.tooltip.body.map(each => each.lines).flat()")

    # The pointer tells the values below it.
    assert hover(9, 81) == ["first [kPa]: 9, 81"], hover(9, 81)
    assert hover(3, 17) == ["second [kPa]: 3, 17"], hover(3, 17)

    # A name in the key is a switch.
    visible = chart + "return chart.data.datasets.map((_, i) => chart.isDatasetVisible(i))"
    box = script(chart + "const b = chart.legend.legendHitBoxes[0]; return [b.left + b.width / 2, b.top + b.height / 2]")
    for wanted in ([False, True], [True, True]):
        ActionChains(browser).move_to_element_with_offset(table, *at(box)).click().perform()
        time.sleep(0.2)
        assert script(visible) == wanted, (wanted, script(visible))

    # Dragging zooms, a double click takes it back.
    window = chart + "return [chart.scales.x.min, chart.scales.x.max, chart.scales.y.min, chart.scales.y.max]"
    whole = script(window)
    (x0, y0), (x1, y1) = point(2, 20), point(6, 60)
    ActionChains(browser).move_to_element_with_offset(table, x0, y0).click_and_hold().move_by_offset(x1 - x0, y1 - y0).release().perform()
    time.sleep(0.2)
    for is_, wanted, size in zip(script(window), (2, 6, 20, 60), (4, 4, 40, 40)):
        assert abs(is_ - wanted) < 0.05 * size, (script(window), "2 6 20 60")
    ActionChains(browser).move_to_element_with_offset(table, 0, 0).double_click().perform()
    time.sleep(0.2)
    assert script(window) == whole, (script(window), whole)

    # The player shows each frame, another variable in other colours, and values below the pointer.
    player = browser.find_element(By.CSS_SELECTOR, "section#falling .player")
    script("arguments[0].scrollIntoView({block: 'center'})", player)
    canvas = player.find_element(By.TAG_NAME, "canvas")
    colours = "return arguments[0].toDataURL()"
    told = player.find_element(By.TAG_NAME, "output")
    last, pictures = told.text, {script(colours, canvas)}
    assert "t = " in last and " of " in last, last
    script("const s = arguments[0].querySelector('input'); s.value = 0; s.oninput()", player)
    assert "t = 0 s, frame 1 of" in told.text and told.text != last, told.text
    pictures.add(script(colours, canvas))
    ActionChains(browser).move_to_element(canvas).perform()
    assert canvas.get_attribute("title").split()[-1].lstrip("-")[0].isdigit(), canvas.get_attribute("title")
    script("const s = arguments[0].querySelector('select'); s.value = [...s.options].find(o => o.value.startsWith('J')).value; s.onchange()", player)
    assert told.text.split("; ")[1].startswith("J"), told.text
    button = player.find_element(By.TAG_NAME, "button")
    button.click()
    for _ in range(200):  # on a busy machine frames come late
        if "frame 1 of" not in told.text:
            break
        time.sleep(0.1)
    button.click()
    assert "frame 1 of" not in told.text and len(pictures) == 2, told.text

    # Of bodies in space one slice, which it tells: all of its cells, and nothing of those before and behind.
    space = browser.find_element(By.CSS_SELECTOR, "section#falling_in_space .player")
    script("arguments[0].scrollIntoView({block: 'center'})", space)
    assert ", slice at y = 0.2 m: x to the right, z up; " in space.find_element(By.TAG_NAME, "output").text
    places = script("""const frame = JSON.parse(arguments[0].querySelector('script').textContent).frames[0];
        return [frame.x, frame.y].map(text => [...unpacked(text)])""", space)
    assert len(places[0]) == len(set(zip(*places))) == 4 * 4 + 10 * 2, (len(places[0]), "cells")
    slice_canvas = space.find_element(By.TAG_NAME, "canvas")
    assert abs(slice_canvas.size["width"] / slice_canvas.size["height"] - 0.5 / 0.3) < 0.03, slice_canvas.size
    if len(sys.argv) > 4:
        space.screenshot(sys.argv[4])

    assert script("return document.querySelector('section#references tr.within td').textContent") == "lausitz_dense"
    assert script("return document.querySelector('section#speed td').textContent") == "update/7"
    assert not (log := headless.complaints(browser)), log
    print(f"{sum(len(drawn) for _, drawn in counts)} plots, {told.text}")
finally:
    browser.quit()
