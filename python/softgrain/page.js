// SPDX-License-Identifier: LGPL-2.1-or-later
// Draws the charts of a page from the data that it holds.
"use strict";
window.addEventListener("error", event => {
  const place = document.getElementById("problem");
  place.textContent = "Something of this page cannot be shown: " + event.message;
  place.hidden = false;
});

const page = JSON.parse(document.getElementById("data").textContent);
const ink = "#1d2733", grid = "#e6eaef";
const axis = {
  gridcolor: grid, zeroline: false, linecolor: "#8492a0", ticks: "outside", tickcolor: "#8492a0", ticklen: 4,
  automargin: true, exponentformat: "power", minorloglabels: "none", title: { standoff: 8 }, showline: true, mirror: true
};
const font = { family: "system-ui, 'Segoe UI', 'Liberation Sans', 'DejaVu Sans', sans-serif", size: 13, color: ink };
const config = { responsive: true, displayModeBar: false }; // its buttons would cover the names of the curves

function described(column) { return page.columns[column] || { label: column, unit: "", divisor: 1 }; }
function titled(column) {
  const one = described(column);
  return one.unit ? `${one.label} [${one.unit}]` : one.label;
}

// Columns that share an axis share the prefix of their unit: that of the largest.
function prefix_of(columns) {
  return columns.map(described).reduce((a, b) => b.divisor > a.divisor ? b : a, described(columns[0]));
}
function scaled(values, divisor) {
  return divisor === 1 ? values : values.map(value => value === null ? null : value / divisor);
}
function title_of(columns) {
  if (columns.length === 1) return titled(columns[0]);
  const unit = prefix_of(columns).unit;
  return unit ? `[${unit}]` : "";
}

function curves(chart) {
  const shown = [];
  for (const one of chart.series) {
    const y = one.y || chart.chosen_y;
    const name = one.tables.find(table => page.tables[table][chart.chosen_x] && page.tables[table][y]);
    if (name && page.tables[name][y].some(value => value !== null)) shown.push({ ...one, y, table: page.tables[name] });
  }
  const used = [...new Set(shown.map(one => one.y))];
  const divisor = used.length ? prefix_of(used).divisor : 1;
  const traces = shown.map(one => ({
    type: "scatter", mode: chart.markers || one.table[one.y].length <= 60 ? "lines+markers" : "lines", name: one.name,
    x: scaled(one.table[chart.chosen_x], described(chart.chosen_x).divisor), y: scaled(one.table[one.y], divisor),
    line: { color: one.colour, dash: one.dash || "solid", width: 2 }, marker: { size: 5 }, ...(one.stack ? { stackgroup: "stack" } : { connectgaps: true }),
    hovertemplate: `%{y:.5g}<extra>${one.name}</extra>`
  }));
  const layout = {
    xaxis: { ...axis, title: { ...axis.title, text: titled(chart.chosen_x) }, type: chart.logx ? "log" : "linear", hoverformat: ".5g" },
    yaxis: { ...axis, title: { ...axis.title, text: used.length ? title_of(used) : "" }, type: chart.logy ? "log" : "linear" },
    hovermode: chart.logx ? "closest" : "x unified"
  };
  const values = traces.flatMap(trace => trace.y).filter(value => value !== null);
  const low = values.reduce((a, b) => Math.min(a, b), Infinity), high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  if (!chart.logy && low >= 0 && low < 0.5 * high) layout.yaxis.rangemode = "tozero";
  return [traces, layout];
}

function draw(number) {
  const chart = page.charts[number];
  const [traces, own] = chart.traces ? [chart.traces, chart.layout] : curves(chart);
  const several = traces.filter(trace => trace.showlegend !== false && trace.name).length > 1;
  const layout = {
    font, margin: { l: 62, r: 14, t: 8, b: 46 }, paper_bgcolor: "#fff", plot_bgcolor: "#fff", showlegend: several,
    legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0, font: { size: 12 } }, hoverlabel: { font: { size: 12 } }, ...own
  };
  for (const name of ["xaxis", "yaxis"]) layout[name] = { ...axis, ...layout[name] };
  Plotly.react(`chart-${number}`, traces, layout, config);
}

// A label without its elements; nothing of it is loaded or run.
function text_of(label) { return new DOMParser().parseFromString(label, "text/html").body.textContent; }

function choice(place, text, columns, chosen, change) {
  const label = document.createElement("label"), select = document.createElement("select");
  label.textContent = text;
  for (const column of columns) {
    const option = new Option(text_of(titled(column)), column);
    option.selected = column === chosen;
    select.append(option);
  }
  select.addEventListener("change", () => change(select.value));
  label.append(select);
  place.append(label);
  return select;
}

function logarithmic(place, chart, number, name) {
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = Boolean(chart["log" + name]);
  box.addEventListener("change", () => { chart["log" + name] = box.checked; draw(number); });
  label.append(box, `log ${name}`);
  place.append(label);
}

function saving(place, chart, number) {
  const button = document.createElement("button");
  button.textContent = "save";
  button.title = "this chart as an SVG file";
  button.addEventListener("click", () => Plotly.downloadImage(`chart-${number}`, {
    format: "svg", width: 700, height: 450, filename: chart.heading.replace(/\W+/g, "-").toLowerCase() || "chart" }));
  place.append(button);
}

const followers = [];
page.charts.forEach((chart, number) => {
  const place = document.getElementById(`tools-${number}`);
  if (!chart.traces) {
    chart.chosen_x = chart.x[0];
    chart.chosen_y = chart.y[0];
    if (chart.follow) followers.push(number);
    else if (chart.x.length > 1) choice(place, "x", chart.x, chart.chosen_x, value => { chart.chosen_x = value; draw(number); });
    if (chart.y.length > 1) choice(place, "y", chart.y, chart.chosen_y, value => { chart.chosen_y = value; draw(number); });
    if (!chart.follow) logarithmic(place, chart, number, "x");
    logarithmic(place, chart, number, "y");
  }
  saving(place, chart, number);
  draw(number);
});
if (followers.length) {
  const columns = page.charts[followers[0]].x;
  const place = document.createElement("div");
  place.className = "tools";
  if (columns.length > 1) {
    choice(place, "against", columns, columns[0], value => {
      for (const number of followers) { page.charts[number].chosen_x = value; draw(number); }
    });
  }
  place.append("Drag to zoom, double-click to go back, click a name to hide its curve.");
  document.getElementById(`chart-${followers[0]}`).closest(".charts").before(place);
}

// Tables: rows that have what is typed, or that differ from run to run.
for (const table of document.querySelectorAll(".table")) {
  const field = table.querySelector("input[type=search]");
  if (!field) continue;
  const rows = [...table.querySelectorAll("tbody tr")];
  let only = null;
  const show = () => {
    const words = field.value.toLowerCase();
    let group = null, shown = false;
    const close = () => { if (group) group.classList.toggle("hidden", !shown); };
    for (const row of rows) {
      if (row.classList.contains("group")) { close(); group = row; shown = false; continue; }
      // The group belongs to the name: "contact friction" finds Friction below Contact.
      const text = ((group ? group.textContent + " " : "") + row.textContent).toLowerCase();
      const found = words.split(/\s+/).every(word => text.includes(word)) && !(only && only.checked && !row.classList.contains("differs"));
      row.classList.toggle("hidden", !found);
      shown = shown || found;
    }
    close();
  };
  if (table.classList.contains("compared")) {
    const label = document.createElement("label");
    only = document.createElement("input");
    only.type = "checkbox";
    only.checked = rows.some(row => row.classList.contains("differs"));
    only.addEventListener("change", show);
    label.append(only, " only what differs");
    field.after(label);
  }
  field.addEventListener("input", show);
  show();
}

// A picture grows when it is clicked.
const large = document.createElement("dialog");
large.append(document.createElement("img"));
document.body.append(large);
large.addEventListener("click", () => large.close());
for (const picture of document.querySelectorAll(".figures img"))
  picture.addEventListener("click", () => { large.firstChild.src = picture.src; large.showModal(); });
document.documentElement.dataset.drawn = page.charts.length;
