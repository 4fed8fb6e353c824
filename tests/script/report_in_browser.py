# SPDX-License-Identifier: BSD-3-Clause
"""report_in_browser.py GRIT SOURCE WORK: results of an element test, of material points, a table and a benchmark in one
page, in headless Chromium: no error in its console, every plot has its data, hovering tells values, names of the key turn
series off and on, dragging zooms, frames play beside their colours and axes, runs of a study are in one chart, what cannot be
read harms nothing else."""

import json
import pathlib
import re
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


cases = ("lausitz_dense", "lausitz_undrained_cycles_1e3", "lausitz_stiffness_degradation")
run("element", *(source / f"verification/cases/{case}.toml" for case in cases), "--no-plot", "--out", results)
run("mpm", source / "tests/script/falling.toml", "--no-plot", "--out", results)
run("mpm", source / "tests/script/falling_in_space.toml", "--no-plot", "--out", results)
(results / "table.csv").write_text("time [s],first [kPa],second [kPa]\n" + "".join(f"{i},{i * i},{20 - i}\n" for i in range(12)))
for field in ("p", "velocity"):
    shutil.copy(source / "docs/images/penalty_factor.svg", results / f"falling_{field}.svg")
(results / "broken.json").write_text('{"a": 1,\n "b": NaN}')
(results / "some.json").write_text('{"x": 1, "y": {"z": [-2.5e-3, "\\u00e9", null, true]}}')
(results / "speed.json").write_text(json.dumps({"benchmarks": [{"name": "update/7", "cpu_time": 12.5, "time_unit": "ns"}]}))
falling = (source / "tests/script/falling.toml").read_text()
(work / "plane.toml").write_text(falling.replace("axisymmetric", "plane_strain").replace('right =', 'left = "roller"\nright ='))
run("mpm", work / "plane.toml", "--no-plot", "--out", results)
study = results / "study"
run("element", source / "verification/cases/lausitz_dense.toml", "--no-plot", "--out", study, "--vary", "start.void_ratio=0.65,0.7,0.8")
run("element", source / "verification/cases/lausitz_dense.toml", "--no-plot", "--out", results / "many", "--vary",
    "start.void_ratio=0.55,0.58,0.61,0.64,0.67,0.7,0.73,0.76")
run("element", source / "verification/cases/lausitz_dense.toml", source / "verification/cases/lausitz_loose.toml", "--no-plot", "--out", results / "pair")
# Settings in a header, of a run that no comparison names.
alone = results / "alone.csv"
first, _, rest = (study / "lausitz_dense_0.7.csv").read_text().partition("\n")
alone.write_text(f"{first}\n# with start.void_ratio=0.7, numerics.tolerance=1e-6\n" +
                 "".join(line for line in rest.splitlines(True) if not line.startswith("# with ")))
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
    assert len(counts) == 24, counts
    for given, drawn in counts:
        assert len(given) == len(drawn) > 0 and all(len(each) > 0 for each in drawn), (given, drawn)
        assert min(n for each in drawn for n in each) > 1, drawn
    drawn = {name: len(script("return [...document.querySelectorAll(`section[id='${arguments[0]}'] canvas`)]", name))
             for name in ("lausitz_dense", "study/comparison", "study/lausitz_dense_0.7")}
    assert set(drawn.values()) == {4}, drawn  # a triaxial test: q, volume, path, void ratio

    # Runs of a study in one chart, called by what was varied, as their headings are; references as points with their curve.
    def series(name, panel=0):
        return script("""const place = document.querySelectorAll(`section[id='${arguments[0]}'] canvas`)[arguments[1]];
            return Chart.getChart(place).data.datasets.map(s => [s.label, s.showLine, s.hidden, s.borderColor])""", name, panel)

    def heading(name):
        return script("return document.querySelector(`section[id='${arguments[0]}'] h3`).textContent", name)

    for panel in range(4):
        runs = series("study/comparison", panel)
        assert [each[:3] for each in runs] == [[f"void_ratio = {e}", True, False] for e in (0.65, 0.7, 0.8)], runs
        assert len({each[3] for each in runs}) == 3, runs
    # A test with cycles has the panels of its picture, and those over the cycles below them; degradation where the file says so.
    def axes(name):
        return script("""return [...document.querySelectorAll(`section[id='${arguments[0]}'] canvas`)].map(place => {
            const scales = Chart.getChart(place).options.scales; return scales.y.title.text.split(' ')[0] + ' over ' + scales.x.title.text.split(' ')[0]})""", name)

    assert axes("lausitz_undrained_cycles_1e3") == [
        "q over axial", "q over effective", "excess over axial", "mobilised over axial", "excess over cycle", "shear over cycle", "secant over cycle",
        "damping over cycle"], axes("lausitz_undrained_cycles_1e3")
    assert axes("lausitz_stiffness_degradation") == [
        "G/G₀ over shear", "damping over shear", "shear over shear", "void over effective"], axes("lausitz_stiffness_degradation")

    # What cannot be read says so, and harms nothing else; the page begins with links to all, verdicts first, what is damaged last.
    assert script("return document.querySelector('section#broken .bad').textContent").endswith('broken.json:2: "NaN}" is no JSON')
    assert script("return [...document.querySelectorAll('section#some td')].map(cell => cell.textContent)") == [
        "x", "1", "y.z.0", "-0.0025", "y.z.1", "é", "y.z.2", "null", "y.z.3", "true"]
    links = script("return [...document.querySelectorAll('nav a')].map(link => decodeURIComponent(link.hash.slice(1)))")
    sections = script("return [...document.querySelectorAll('section')].map(section => section.id)")
    assert links + ["versions"] == sections and links[:2] == ["pair/references", "references"] and links[-1] == "broken", (links, sections)

    # Series that all panels have are in one key above them, which is a switch; charts are as high as those of a single run.
    key = browser.find_elements(By.CSS_SELECTOR, "section[id='many/comparison'] .key button")
    assert [each.text for each in key] == [f"void_ratio = {e}" for e in (0.55, 0.58, 0.61, 0.64, 0.67, 0.7, 0.73, 0.76)], key
    many = """return [...document.querySelectorAll("section[id='many/comparison'] canvas")].map(place => Chart.getChart(place)).map(chart => """
    assert script(many + "[chart.legend.options.display, chart.chartArea.height > 240])") == [[False, True]] * 4
    assert len({each[3] for each in series("many/comparison")}) == 8, series("many/comparison")
    script("arguments[0].scrollIntoView({block: 'center'})", key[1])
    for wanted in ("10111111", "11111111"):
        key[1].click()
        assert script(many + "chart.data.datasets.map((_, i) => chart.isDatasetVisible(i) ? 1 : 0).join(''))") == [wanted] * 4
    # Lines that one panel alone has are in its own key, be it one.
    own = script("""return [...document.querySelectorAll("section#falling canvas")].map(place => Chart.getChart(place)).filter(chart => chart)
        .filter(chart => chart.legend.options.display).map(chart => chart.legend.legendItems.map(item => item.text))""")
    assert own[0] == ["base"] and len(own) == 2, own
    depths = script("""return Chart.getChart(document.querySelector("section#falling_in_space canvas")).scales.y.ticks.map(tick => tick.label)""")
    assert depths[0] == "0" and all(re.fullmatch(r"[\d.]+e-[56]", each) for each in depths[1:]), depths
    # Forces begin with the first step, their axis with the others.
    begins = script("""return [...document.querySelectorAll("section#falling canvas")].map(place => Chart.getChart(place)).filter(chart => chart)
        .map(chart => [chart.scales.x.min, chart.data.datasets[0].data[0].x > 0])""")
    assert begins == [[0, False], [0, False], [0, True], [0, False], [0, False], [0, True]], begins

    # Pictures of fields are in their run, folded, where the player does not have them.
    assert "falling_p" not in sections and "falling_velocity" not in sections, sections
    assert script("return [...document.querySelectorAll('section#falling details img')].map(image => image.alt)") == ["falling_velocity"]

    dense = "Dense Lausitz sand, e 0.55, 100 kPa"
    order = script("return [...document.querySelectorAll('section[id^=\"study/laus\"]')].map(section => section.id)")
    assert order == [f"study/lausitz_dense_{e}" for e in (0.65, 0.7, 0.8)], order
    assert heading("study/comparison") == dense + ": all runs", heading("study/comparison")
    assert heading("study/lausitz_dense_0.7") == dense + ": void_ratio = 0.7", heading("study/lausitz_dense_0.7")
    assert heading("pair/lausitz_dense") == dense + " (pair/lausitz_dense)", heading("pair/lausitz_dense")
    assert [each[:2] for each in series("lausitz_dense")] == [["computed", True], ["reference", False]], series("lausitz_dense")
    both = [each[:2] for each in series("pair/comparison")]
    loose = "Loose Lausitz sand, e 0.80, 100 kPa"
    assert both == [[dense, True], [loose, True], ["reference: " + dense, False], ["reference: " + loose, False]], both

    # Versions, commands and settings where headers tell them.
    assert heading("alone") == dense + " with start.void_ratio=0.7, numerics.tolerance=1e-6", heading("alone")
    made = {row[0]: row[1:] for row in script("""return [...document.querySelectorAll('#versions tr')].map(row =>
        [...row.children].map(cell => cell.textContent))""")}
    assert made["alone.csv"][0] == "grit element, case lausitz_dense_0.7" and made["alone.csv"][2] == "start.void_ratio=0.7, numerics.tolerance=1e-6", made
    assert made["falling.csv"][0] == "grit mpm, case falling" and made["falling.csv"][1].startswith("Grit "), made
    assert "with start.void_ratio=0.7" in script("return document.querySelector('#alone details pre').textContent")

    # A logarithmic axis has numbers to read it by, in a window too.
    ticks = script("""const chart = Chart.getChart(document.querySelectorAll("section[id='study/comparison'] canvas")[3]), x = chart.scales.x;
        return [x.type, x.ticks.map(tick => tick.label), logTicks(1, 1000), logTicks(100, 160), logTicks(1e-6, 1e6).length, text(1e-6)]""")
    assert ticks[0] == "logarithmic" and ticks[1] == ["100", "120", "140", "160", "180"], ticks
    assert ticks[2] == [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] and ticks[3][0] == 100 and 3 < len(ticks[3]) < 8 and ticks[4:] == [13, "1e-6"], ticks

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
    pointed = player.find_element(By.CSS_SELECTOR, "output.pointed")
    assert pointed.text == ""
    ActionChains(browser).move_to_element(canvas).perform()
    assert re.fullmatch(r"p \[kPa\] -?[\d.e-]+ at r = 0\.\d+ m, z = 0\.\d+ m", at_first := pointed.text), at_first
    # It stays true when frames go on, and tells nothing beside the bodies.
    script("const s = arguments[0].querySelector('input'); s.value = 3; s.oninput()", player)
    assert pointed.text.startswith("p [kPa] ") and pointed.text != at_first, (at_first, pointed.text)
    script("const s = arguments[0].querySelector('input'); s.value = 0; s.oninput()", player)
    assert pointed.text == at_first, (at_first, pointed.text)
    ActionChains(browser).move_to_element_with_offset(canvas, 8 - canvas.size["width"] // 2, 0).perform()
    assert pointed.text == "", pointed.text
    script("const s = arguments[0].querySelector('select'); s.value = [...s.options].find(o => o.value.startsWith('J')).value; s.onchange()", player)
    assert told.text.split("; ")[1].startswith("J"), told.text

    # Beside it stand its colours, which are viridis, with numbers, and what lies beyond them; below and left the metres.
    script("const s = arguments[0].querySelector('select'); s.value = [...s.options].find(o => o.value.startsWith('p ')).value; s.onchange()", player)
    bar = script("""const c = arguments[0], p = c.plot, data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
        const pixel = (x, y) => [...data.slice(4 * (y * c.width + x), 4 * (y * c.width + x) + 4)], colour = (x, y) => pixel(x, y).slice(0, 3);
        const inked = (x, y, w, h) => { for (let i = 0; i < w * h; ++i) if (pixel(x + i % w, y + Math.floor(i / w))[3]) return true; return false; };
        return {top: colour(p.left + p.width + 28, p.top + 2), bottom: colour(p.left + p.width + 28, p.top + p.height - 3),
                ticks: c.colours.ticks, beyond: c.colours.beyond, all: JSON.parse(c.parentElement.querySelector('script').textContent).variables,
                numbers: inked(p.left + p.width + 44, p.top + 10, 60, p.height - 20), name: inked(p.left + p.width + 8, 0, 60, 16),
                up: inked(p.left + p.width + 24, p.top - 8, 8, 4), x: inked(p.left, p.top + p.height + 8, p.width, 14),
                y: inked(20, p.top, 36, p.height), palette: [0, 0.5, 1].map(colourAt)};""", canvas)
    assert max(abs(a - b) for a, b in zip(bar["top"] + bar["bottom"], [0xfd, 0xe7, 0x25, 0x44, 0x01, 0x54])) < 12, bar
    assert bar["palette"] == ["rgb(68,1,84)", "rgb(33,145,140)", "rgb(253,231,37)"], bar
    low, high = bar["all"]["p [kPa]"]
    assert len(bar["ticks"]) > 2 and low <= bar["ticks"][0] < bar["ticks"][-1] <= high, bar
    assert all(bar[what] for what in ("numbers", "name", "x", "y")), bar
    assert (bar["beyond"][1] is not None) == bar["up"] and ("values beyond them" in told.text) == any(bar["beyond"]), (bar, told.text)
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
    plot = script("return arguments[0].plot", slice_canvas)
    assert abs(plot["width"] / plot["height"] - 0.5 / 0.3) < 0.03, plot
    across = [script(f"return JSON.parse(document.querySelector('#{name} .player script').textContent).across")
              for name in ("falling", "plane", "falling_in_space")]
    assert across == ["r", "x", "x"], across
    if len(sys.argv) > 4:
        space.screenshot(sys.argv[4])

    assert script("return document.querySelector('section#references tr.within td').textContent") == "lausitz_dense"
    assert script("return document.querySelector('section#speed td').textContent") == "update/7"
    assert not (log := headless.complaints(browser)), log
    print(f"{sum(len(drawn) for _, drawn in counts)} plots, {told.text}")
finally:
    browser.quit()
