// Draws what stands as data in a page of grit report: curves, players of frames, tables of numbers.
"use strict";
const colours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"], dataColour = "#222222";
const shown = new Intl.NumberFormat("en", { maximumSignificantDigits: 5, useGrouping: false });
const text = value => Math.abs(value) < 1e-12 ? "0" : Math.abs(value) < 1e-4 ? Number(value.toPrecision(5)).toExponential() : shown.format(value);
const element = (name, parent, properties) => parent.appendChild(Object.assign(document.createElement(name), properties));
const dataOf = place => JSON.parse(place.querySelector("script").textContent);

// Of viridis, which the page has in it: share 0 to 1 of the way.
function colourAt(share) {
  const place = Math.min(1, Math.max(0, share)) * (viridis.length - 1), below = Math.min(viridis.length - 2, Math.floor(place));
  const parts = colour => [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
  const [a, b] = [parts(viridis[below]), parts(viridis[below + 1])];
  return `rgb(${a.map((part, i) => Math.round(part + (place - below) * (b[i] - part))).join(",")})`;
}

// Multiples of 1, 2 or 5 times a power of ten, about so many.
function evenTicks(low, high, count) {
  if (!(high > low)) return [low];
  const rough = (high - low) / count, unit = 10 ** Math.floor(Math.log10(rough));
  const step = unit * [1, 2, 5, 10].find(factor => factor * unit >= rough * 0.9999);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i) ticks.push(i * step);
  return ticks;
}

// 1, 2, 5 of every decade; decades where those are many, even steps where they are few.
function logTicks(low, high) {
  if (!(low > 0 && high > low)) return [];
  const of = digits => {
    const ticks = [];
    for (let decade = Math.floor(Math.log10(low)); decade <= Math.log10(high); ++decade)
      for (const digit of digits) ticks.push(Number(`${digit}e${decade}`));
    return ticks.filter(tick => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
  };
  const some = of([1, 2, 5]);
  if (some.length > 12) return of([1]);
  return some.length > 2 ? some : evenTicks(low, high, 8);
}

// A rectangle dragged over a chart becomes its window, a double click takes it back; a click on a name of the key turns its
// series off and on (Chart.js).
function makeZoom(chart, canvas) {
  let from = null;
  const place = event => ({ x: event.offsetX, y: event.offsetY });
  canvas.addEventListener("mousedown", event => { from = place(event); });
  canvas.addEventListener("mouseup", event => {
    const to = place(event), start = from;
    from = null;
    if (!start || Math.abs(to.x - start.x) < 8 || Math.abs(to.y - start.y) < 8) return;
    for (const axis of ["x", "y"]) {
      const ends = [start[axis], to[axis]].map(pixel => chart.scales[axis].getValueForPixel(pixel)).sort((a, b) => a - b);
      Object.assign(chart.options.scales[axis], { min: ends[0], max: ends[1] });
    }
    chart.update("none");
  });
  canvas.addEventListener("dblclick", () => {
    for (const axis of ["x", "y"]) { delete chart.options.scales[axis].min; delete chart.options.scales[axis].max; }
    chart.update("none");
  });
}

// Chart.js writes 4.500000E-5.
function tickText(value, index, ticks) {
  const small = ticks.every(tick => Math.abs(tick.value) < 1e-4);
  return small ? text(value) : Chart.Ticks.formatters.numeric.call(this, value, index, ticks);
}

// The key of all panels of a result that have none of their own; a click on a name turns its series off and on in all of them.
function drawKey(place, panels, charts, colourOf) {
  const entries = new Map();
  for (const panel of panels)
    if (!panel.key) for (const series of panel.series) if (series.label !== panel.y && !entries.has(series.label)) entries.set(series.label, [panel, series]);
  if (entries.size < 2) return;
  const key = place.insertBefore(Object.assign(document.createElement("div"), { className: "key" }), place.querySelector(".chart"));
  for (const [label, [panel, series]] of entries) {
    const entry = element("button", key, {}), colour = colourOf(panel, series);
    const sign = element("span", entry, { className: series.points ? "points" : "line" });
    sign.style.borderColor = colour;
    entry.append(label);
    entry.onclick = () => {
      const off = entry.classList.toggle("off");
      for (const chart of charts) {
        chart.data.datasets.forEach((each, i) => { if (each.label === label) chart.setDatasetVisibility(i, !off); });
        chart.update("none");
      }
    };
  }
}

function drawCurves(place) {
  const panels = dataOf(place), charts = [];
  // Runs that are compared are all shown, many of them in the order of their colours.
  const colourOf = (panel, series) => {
    const runs = panel.series.filter(each => each.colour >= 0).length;
    return series.colour < 0 ? dataColour
      : panel.all && runs > colours.length ? colourAt(0.95 * series.colour / (runs - 1)) : colours[series.colour % colours.length];
  };
  for (const panel of panels) {
    const canvas = element("canvas", element("div", place, { className: "chart" }), {});
    const many = panel.series.length > 6;
    const datasets = panel.series.map(series => ({
      label: series.label,
      data: series.x.map((x, i) => ({ x, y: series.y[i] })).filter(point => !panel.log || point.x > 0),
      borderColor: colourOf(panel, series), backgroundColor: series.points ? "transparent" : colourOf(panel, series),
      showLine: !series.points, borderWidth: series.points ? 1.2 : 2, pointRadius: series.points ? 3 : 0,
      hidden: !panel.all && many && series.colour > 2,
    }));
    const logarithmic = {
      type: "logarithmic", bounds: "data", ticks: { callback: value => text(value) },
      afterDataLimits: scale => {  // a little room beside the data, none in a window
        if (scale.options.min !== undefined) return;
        const room = (scale.max / scale.min) ** 0.02;
        Object.assign(scale, { min: scale.min / room, max: scale.max * room });
      },
      afterBuildTicks: scale => { scale.ticks = logTicks(scale.min, scale.max).map(value => ({ value })); },
    };
    const axis = (text, more) => ({ title: { display: Boolean(text), text }, ...more });
    const chart = new Chart(canvas, {
      type: "scatter", data: { datasets },
      options: {
        animation: false, maintainAspectRatio: false, interaction: { mode: "nearest", intersect: false },
        scales: { x: axis(panel.x, panel.log ? logarithmic : { type: "linear", suggestedMin: panel.from ?? undefined }), y: axis(panel.y, { beginAtZero: panel.zero, ticks: { callback: tickText } }) },
        plugins: {
          legend: { display: panel.key, labels: { boxWidth: 18, boxHeight: 9 } },
          tooltip: { callbacks: { label: at => `${at.dataset.label}: ${text(at.parsed.x)}, ${text(at.parsed.y)}` } },
        },
      },
    });
    canvas.title = "drag: zoom, double click: all";
    makeZoom(chart, canvas);
    charts.push(chart);
  }
  drawKey(place, panels, charts, colourOf);
}

const unpacked = text => {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Uint16Array(bytes.buffer);
};
const valueOf = (word, [low, high]) => word === 65535 ? NaN : low + word / 65534 * (high - low);

function drawPlayer(place) {
  const run = dataOf(place), names = Object.keys(run.variables);
  const bar = element("div", place, { className: "bar" });
  const button = element("button", bar, { textContent: "play" });
  const slider = element("input", bar, { type: "range", min: 0, max: run.frames.length - 1, value: run.frames.length - 1 });
  const choice = element("select", bar, {});
  for (const name of names) element("option", choice, { textContent: name });
  choice.value = names.find(name => /^p( |$)/.test(name)) ?? names[0];
  const canvas = element("canvas", place, {}), told = element("output", place, {}), pointed = element("output", place, { className: "pointed" });
  const width = run.x[1] - run.x[0] + run.edge[1], height = run.y[1] - run.y[0] + run.edge[1];
  // The bodies, axes left of and below them, the colours to the right.
  const left = 64, right = 132, top = 34, bottom = 46;
  const scale = Math.min((1000 - left - right) / width, 620 / height);
  const plot = canvas.plot = { left, top, width: Math.ceil(width * scale), height: Math.max(120, Math.ceil(height * scale)) };
  canvas.width = left + plot.width + right;
  canvas.height = top + plot.height + bottom;
  canvas.style.width = canvas.width + "px";
  canvas.style.maxWidth = "100%";
  const acrossAt = x => left + (x - run.x[0] + run.edge[1] / 2) * scale;
  const upAt = y => top + plot.height - (y - run.y[0] + run.edge[1] / 2) * scale;
  // Colours lie over what all but the outermost hundredth of the values of all frames have, if these differ.
  const colourRanges = {};
  function colourRange() {
    const name = choice.value;
    if (!colourRanges[name]) {
      const words = run.frames.flatMap(frame => frame["v " + name] ? [...unpacked(frame["v " + name])] : []).filter(word => word !== 65535).sort((a, b) => a - b);
      const part = share => valueOf(words[Math.floor(share * (words.length - 1))], run.variables[name]);
      const [low, high] = [part(0.01), part(0.99)];
      const all = run.variables[name], near = 0.02 * (high - low);
      colourRanges[name] = high > low ? [low - all[0] < near ? all[0] : low, all[1] - high < near ? all[1] : high] : all;
    }
    return colourRanges[name];
  }
  function drawAxes(context) {
    Object.assign(context, { strokeStyle: "#444", fillStyle: "#222", lineWidth: 1, font: "12px sans-serif", textAlign: "center", textBaseline: "top" });
    context.strokeRect(left - 0.5, top - 0.5, plot.width + 1, plot.height + 1);
    const line = (x, y, dx, dy) => { context.beginPath(); context.moveTo(x, y); context.lineTo(x + dx, y + dy); context.stroke(); };
    const ends = (from, pixels) => [from - run.edge[1] / 2, from - run.edge[1] / 2 + pixels / scale];
    for (const x of evenTicks(...ends(run.x[0], plot.width), Math.max(2, plot.width / 90))) {
      line(acrossAt(x), top + plot.height, 0, 5);
      context.fillText(text(x), acrossAt(x), top + plot.height + 8);
    }
    context.fillText(`${run.across} [m]`, left + plot.width / 2, top + plot.height + 26);
    Object.assign(context, { textAlign: "right", textBaseline: "middle" });
    for (const y of evenTicks(...ends(run.y[0], plot.height), Math.max(2, plot.height / 70))) {
      line(left, upAt(y), -5, 0);
      context.fillText(text(y), left - 8, upAt(y));
    }
    context.textAlign = "left";
    context.fillText("z [m]", 4, top - 18);
  }
  // What lies beyond the colours is told at their ends, by an arrow and how far it goes.
  function drawColours(context, [low, high], all) {
    const x = left + plot.width + 20, wide = 16;
    for (let i = 0; i < plot.height; ++i) {
      context.fillStyle = colourAt(1 - i / plot.height);
      context.fillRect(x, top + i, wide, 1.5);
    }
    Object.assign(context, { strokeStyle: "#444", fillStyle: "#222", lineWidth: 1, font: "12px sans-serif", textAlign: "left", textBaseline: "middle" });
    context.strokeRect(x - 0.5, top - 0.5, wide + 1, plot.height + 1);
    const shownTicks = evenTicks(low, high, Math.max(2, plot.height / 60));
    for (const value of shownTicks) {
      const y = top + plot.height * (1 - (high > low ? (value - low) / (high - low) : 0.5));
      context.fillRect(x + wide, y - 0.5, 5, 1);
      context.fillText(text(value), x + wide + 8, y);
    }
    context.fillText(choice.value, x - 12, 8);
    const arrow = (y, up) => {
      context.beginPath();
      context.moveTo(x, y); context.lineTo(x + wide, y); context.lineTo(x + wide / 2, y + (up ? -10 : 10));
      context.fill();
    };
    const beyond = [all[0] < low ? text(all[0]) : null, all[1] > high ? text(all[1]) : null];
    if (beyond[1]) { arrow(top - 2, true); context.fillText(`to ${beyond[1]}`, x + wide + 6, top - 9); }
    if (beyond[0]) { arrow(top + plot.height + 2, false); context.fillText(`to ${beyond[0]}`, x + wide + 6, top + plot.height + 10); }
    return { ticks: shownTicks, beyond };
  }
  let cells = [], pointer = null;  // on the canvas; null: elsewhere
  // The cell that was drawn last lies above others.
  function tellPointed() {
    const below = pointer && cells.findLast(cell => Math.abs(cell.x - pointer.x) <= cell.wide / 2 && Math.abs(cell.y - pointer.y) <= cell.tall / 2);
    const value = below && (Number.isNaN(below.value) ? "unknown" : text(below.value));
    pointed.textContent = below ? `${choice.value} ${value} at ${run.across} = ${text(below.across)} m, z = ${text(below.up)} m` : "";
  }
  function draw() {
    const frame = run.frames[slider.value], range = run.variables[choice.value], ends = colourRange(), context = canvas.getContext("2d");
    const [x, y, w, h, values] = ["x", "y", "w", "h", "v " + choice.value].map(key => frame[key] ? unpacked(frame[key]) : null);
    context.clearRect(0, 0, canvas.width, canvas.height);
    cells = [];
    for (let i = 0; i < x.length; ++i) {
      const value = values ? valueOf(values[i], range) : NaN;
      const [wide, tall] = [w, h].map(sizes => Math.max(1, valueOf(sizes[i], run.edge) * scale));
      const across = valueOf(x[i], run.x), up = valueOf(y[i], run.y);
      const at = { x: acrossAt(across), y: upAt(up), across, up, wide, tall, value };
      context.fillStyle = Number.isNaN(value) ? "#999" : colourAt((value - ends[0]) / (ends[1] - ends[0] || 1));
      context.fillRect(at.x - wide / 2, at.y - tall / 2, wide + 0.5, tall + 0.5);
      cells.push(at);
    }
    drawAxes(context);
    canvas.colours = drawColours(context, ends, range);
    const [below, above] = canvas.colours.beyond;
    told.textContent = `t = ${text(run.times[slider.value])} s, frame ${Number(slider.value) + 1} of ${run.frames.length}` +
      (run.of > run.frames.length ? ` (${run.of} in the folder)` : "") +
      (run.slice === null ? "" : `, slice at y = ${text(run.slice)} m: x to the right, z up`) +
      `; ${choice.value}: colours from ${text(ends[0])} to ${text(ends[1])}` +
      (below || above ? `, values beyond them ${[below && `down to ${below}`, above && `up to ${above}`].filter(Boolean).join(" and ")}` : "");
    tellPointed();
  }
  let timer = null;
  button.onclick = () => {
    if (timer) { clearInterval(timer); timer = null; button.textContent = "play"; return; }
    button.textContent = "stop";
    timer = setInterval(() => { slider.value = (Number(slider.value) + 1) % run.frames.length; draw(); }, 150);
  };
  slider.oninput = choice.onchange = draw;
  canvas.onmousemove = event => {
    const zoom = canvas.width / canvas.clientWidth;
    pointer = { x: event.offsetX * zoom, y: event.offsetY * zoom };
    tellPointed();
  };
  canvas.onmouseleave = () => { pointer = null; tellPointed(); };
  draw();
}

// Benchmarks in a table of their own; of other files each number with its way there.
function drawNumbers(place) {
  const all = dataOf(place);
  const rows = [];
  if (Array.isArray(all?.benchmarks)) {
    rows.push(["benchmark", "time", "unit", "counters"]);
    for (const each of all.benchmarks) {
      const counters = Object.entries(each).filter(([key, value]) => typeof value === "number" &&
        !["real_time", "cpu_time", "iterations", "family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads"].includes(key));
      rows.push([each.name, shown.format(each.cpu_time ?? each.real_time), each.time_unit ?? "", counters.map(([key, value]) => `${key} ${shown.format(value)}`).join(", ")]);
    }
  } else {
    rows.push(["what", "value"]);
    let more = 0;
    const walk = (value, way) => {
      if (value && typeof value === "object") for (const key of Object.keys(value)) walk(value[key], way ? `${way}.${key}` : key);
      else if (rows.length > 300) ++more;
      else rows.push([way, typeof value === "number" ? shown.format(value) : String(value)]);
    };
    walk(all, "");
    if (more) rows.push([`${more} more`, "in the file"]);
  }
  const table = element("table", element("div", place, { className: "table" }), {});
  rows.forEach((row, i) => {
    const line = element("tr", table, {});
    for (const cell of row) element(i ? "td" : "th", line, { textContent: cell });
  });
}

if (typeof Chart !== "undefined") document.querySelectorAll(".curves").forEach(drawCurves);
document.querySelectorAll(".player").forEach(drawPlayer);
document.querySelectorAll(".numbers").forEach(drawNumbers);
