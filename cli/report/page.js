// Draws what stands as data in a page of grit report: curves, players of frames, tables of numbers.
"use strict";
const colours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"];
const shown = new Intl.NumberFormat("en", { maximumSignificantDigits: 5, useGrouping: false });
const text = value => shown.format(Math.abs(value) < 1e-12 ? 0 : value);
const element = (name, parent, properties) => parent.appendChild(Object.assign(document.createElement(name), properties));
const dataOf = place => JSON.parse(place.querySelector("script").textContent);

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

function drawCurves(place) {
  for (const panel of dataOf(place)) {
    const canvas = element("canvas", element("div", place, { className: "chart" }), {});
    const few = panel.series.length > 6;
    const datasets = panel.series.map(series => ({
      label: series.label,
      data: series.x.map((x, i) => ({ x, y: series.y[i] })).filter(point => !panel.log || point.x > 0),
      borderColor: colours[(series.colour + colours.length) % colours.length],
      backgroundColor: colours[(series.colour + colours.length) % colours.length],
      showLine: !series.points, borderWidth: 2, pointRadius: series.points ? 3 : 0, hidden: few && series.colour > 2,
    }));
    const axis = (text, more) => ({ title: { display: Boolean(text), text }, ...more });
    const chart = new Chart(canvas, {
      type: "scatter", data: { datasets },
      options: {
        animation: false, maintainAspectRatio: false, interaction: { mode: "nearest", intersect: false },
        scales: { x: axis(panel.x, { type: panel.log ? "logarithmic" : "linear" }), y: axis(panel.y, { beginAtZero: panel.zero }) },
        plugins: {
          legend: { display: panel.series.length > 1 },
          tooltip: { callbacks: { label: at => `${at.dataset.label}: ${text(at.parsed.x)}, ${text(at.parsed.y)}` } },
        },
      },
    });
    canvas.title = "drag: zoom, double click: all";
    makeZoom(chart, canvas);
  }
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
  const canvas = element("canvas", place, {}), told = element("output", place, {});
  const width = run.x[1] - run.x[0] + run.edge[1], height = run.y[1] - run.y[0] + run.edge[1];
    const scale = Math.min(1000 / width, 620 / height);
  canvas.width = Math.ceil(width * scale);
  canvas.height = Math.ceil(height * scale);
  canvas.style.width = canvas.width + "px";
  canvas.style.maxWidth = "100%";
  // Colours lie over what all but the outermost hundredth of the values of all frames have.
  const colourRanges = {};
  function colourRange() {
    const name = choice.value;
    if (!colourRanges[name]) {
      const words = run.frames.flatMap(frame => frame["v " + name] ? [...unpacked(frame["v " + name])] : []).filter(word => word !== 65535).sort((a, b) => a - b);
      const part = share => valueOf(words[Math.floor(share * (words.length - 1))], run.variables[name]);
      colourRanges[name] = [part(0.01), part(0.99)];
    }
    return colourRanges[name];
  }
  let cells = [];
  function draw() {
    const frame = run.frames[slider.value], range = run.variables[choice.value], colours = colourRange(), context = canvas.getContext("2d");
    const [x, y, w, h, values] = ["x", "y", "w", "h", "v " + choice.value].map(key => frame[key] ? unpacked(frame[key]) : null);
    context.clearRect(0, 0, canvas.width, canvas.height);
    cells = [];
    for (let i = 0; i < x.length; ++i) {
      const value = values ? valueOf(values[i], range) : NaN;
      const [across, up] = [w, h].map(sizes => Math.max(1, valueOf(sizes[i], run.edge) * scale));
      const at = { x: (valueOf(x[i], run.x) - run.x[0] + run.edge[1] / 2) * scale,
                   y: canvas.height - (valueOf(y[i], run.y) - run.y[0] + run.edge[1] / 2) * scale, value };
      const share = Math.min(1, Math.max(0, (value - colours[0]) / (colours[1] - colours[0] || 1)));
      context.fillStyle = Number.isNaN(value) ? "#999" : `hsl(${240 - 240 * share}, 75%, ${45 + 10 * share}%)`;
      context.fillRect(at.x - across / 2, at.y - up / 2, across + 0.5, up + 0.5);
      cells.push(at);
    }
    told.textContent = `t = ${text(run.times[slider.value])} s, frame ${Number(slider.value) + 1} of ${run.frames.length}` +
      (run.of > run.frames.length ? ` (${run.of} in the folder)` : "") +
      (run.slice === null ? "" : `, slice at y = ${text(run.slice)} m: x to the right, z up`) +
      `; ${choice.value} from ${text(colours[0])} (blue) to ${text(colours[1])} (red), all: ${text(range[0])} to ${text(range[1])}`;
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
    const distance = cell => (cell.x - event.offsetX * zoom) ** 2 + (cell.y - event.offsetY * zoom) ** 2;
    let nearest = cells[0];
    for (const cell of cells) if (distance(cell) < distance(nearest)) nearest = cell;
    canvas.title = `${choice.value} ${Number.isNaN(nearest.value) ? "unknown" : text(nearest.value)}`;
  };
  draw();
}

// Benchmarks in a table of their own; of other files each number with its way there.
function drawNumbers(place) {
  const all = dataOf(place);
  const rows = [];
  if (Array.isArray(all.benchmarks)) {
    rows.push(["benchmark", "time", "unit", "counters"]);
    for (const each of all.benchmarks) {
      const counters = Object.entries(each).filter(([key, value]) => typeof value === "number" &&
        !["real_time", "cpu_time", "iterations", "family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads"].includes(key));
      rows.push([each.name, shown.format(each.cpu_time ?? each.real_time), each.time_unit ?? "", counters.map(([key, value]) => `${key} ${shown.format(value)}`).join(", ")]);
    }
  } else {
    rows.push(["what", "value"]);
    const walk = (value, way) => {
      if (rows.length > 300) return;
      if (value && typeof value === "object") for (const key of Object.keys(value)) walk(value[key], way ? `${way}.${key}` : key);
      else rows.push([way, typeof value === "number" ? shown.format(value) : String(value)]);
    };
    walk(all, "");
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
