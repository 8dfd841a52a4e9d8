const d = JSON.parse(document.getElementById("description").textContent);
const bytes = Uint8Array.from(atob(document.getElementById("data").textContent), (c) => c.charCodeAt(0)).buffer;
const vectors = ([place, size, unit]) => Float32Array.from(new Int16Array(bytes, place, size), (v) => v * unit);
const mean = vectors(d.points);
const triangles = new Uint32Array(bytes, ...d.triangles);
const modes = d.modes.map((mode) => vectors(mode.vectors));
const tests = d.tests.map(([name, [place, size]]) => ({ name, values: new Float32Array(bytes, place, size) }));
const scores = modes.map(() => 0);
const points = new Float32Array(mean.length), normals = new Float32Array(mean.length);
const colors = new Uint8Array(mean.length);
const palette = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#f0e442", "#777777"];
byId("more").hidden = modes.length < 4;
const names = [...new Set(d.groups)].sort();
const colorOf = (i) => d.groups.length ? palette[names.indexOf(d.groups[i]) % palette.length] : palette[0];
const limit = 3;

// The surface: mean plus scores times modes.
function moveSurface() {
  points.set(mean);
  modes.forEach((mode, k) => {
    if (scores[k] !== 0) {
      for (let i = 0; i < points.length; ++i) points[i] += scores[k] * mode[i];
    }
  });
  setNormals(points, triangles, normals);
}

// Colors from low to high: distances from dark violet to yellow, and p from gray (p = 1) to dark red.
const distanceRamp = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
const testRamp = [[215, 212, 205], [244, 194, 130], [230, 120, 70], [178, 40, 45], [90, 0, 30]];
function colorSurface() {
  const which = byId("color").value, legend = byId("legend");
  legend.hidden = which === "none";
  if (which === "none") {
    for (let i = 0; i < colors.length; i += 3) colors.set([204, 176, 150], i);
    return;
  }
  let fraction, low, high;
  const ramp = which === "moved" ? distanceRamp : testRamp;
  if (which === "moved") {
    const lengths = new Float32Array(mean.length / 3).map((_, i) => Math.hypot(
      points[3 * i] - mean[3 * i], points[3 * i + 1] - mean[3 * i + 1], points[3 * i + 2] - mean[3 * i + 2]));
    const most = lengths.reduce((a, b) => Math.max(a, b), 0);
    fraction = (i) => most > 0 ? lengths[i] / most : 0;
    low = "0";
    high = (100 * most).toPrecision(2) + " % of the radius";
  } else {
    const { values } = tests[Number(which)], least = Math.log(1 / (d.permutations + 1));
    fraction = (i) => Math.log(values[i]) / least;
    low = "p = 1";
    high = "p = " + (1 / (d.permutations + 1)).toPrecision(2);
  }
  byId("low").textContent = low;
  byId("high").textContent = high;
  for (let i = 0; i < colors.length / 3; ++i) colors.set(rampColor(ramp, fraction(i)), 3 * i);
  byId("ramp").style.background = gradientOf(ramp);
}

const view = new View(d.axes, triangles, "color = value;");
function update() {
  moveSurface();
  colorSurface();
  view.setVertices(points, normals, colors);
  view.draw();
}

// Sliders.
function textOf(score) {
  const size = Math.abs(score).toFixed(1);
  return (size === "0.0" ? "" : score < 0 ? "\u2212" : "+") + size + " \u03c3";
}
const sliders = modes.map((_, k) => {
  const mode = document.createElement("div"), label = document.createElement("label");
  const slider = document.createElement("input"), output = document.createElement("output");
  const share = document.createElement("span");
  mode.className = "mode";
  share.className = "share";
  Object.assign(slider, { type: "range", min: -limit, max: limit, step: 0.1, value: 0, id: `mode${k + 1}` });
  label.htmlFor = slider.id;
  label.append(`Mode ${k + 1} `, share);
  share.textContent = `${(100 * d.modes[k].share).toFixed(1)} % of the variance`;
  mode.append(label, output, slider);
  byId(k < 3 ? "modes" : "more").append(mode);
  slider.addEventListener("input", () => {
    scores[k] = Number(slider.value);
    byId("shown").textContent = "";
    show();
  });
  return { slider, output };
});
function show() {
  sliders.forEach(({ slider, output }, k) => {
    slider.value = scores[k];
    output.textContent = textOf(scores[k]);
  });
  drawPlot();
  update();
}
function setScores(values, text) {
  scores.forEach((_, k) => { scores[k] = values[k] || 0; });
  byId("shown").textContent = text;
  show();
}
byId("reset").addEventListener("click", () => setScores([], ""));

// Scores of the scans.
const svg = (name, attributes) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};
function drawPlot() {
  const plot = byId("plot"), across = Number(byId("across").value), upward = Number(byId("upward").value);
  const most = Math.max(limit, ...d.scans.flatMap((scan) => scan.scores.map(Math.abs)));
  const place = (score) => (100 * score) / most;
  const focused = plot.contains(document.activeElement) ? document.activeElement.dataset.scan : null;
  plot.replaceChildren(svg("path", { class: "axis", d: "M-100 0H100M0 -100V100M-100 -100H100V100H-100Z" }));
  for (const [x, y, text] of [[-98, 106, (-most).toFixed(1)], [86, 106, most.toFixed(1)]]) {
    plot.append(svg("text", { x, y }));
    plot.lastChild.textContent = text;
  }
  d.scans.forEach((scan, i) => {
    const text = scan.name + (d.groups.length ? ` (${d.groups[i]})` : "");
    const dot = svg("circle", { cx: place(scan.scores[across] || 0), cy: -place(scan.scores[upward] || 0), r: 4,
      fill: colorOf(i), tabindex: 0, role: "button", "aria-label": text, "data-scan": i });
    dot.append(svg("title", {}));
    dot.lastChild.textContent = text;
    const select = () => setScores(scan.scores, text);
    dot.addEventListener("click", select);
    dot.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        select();
      }
    });
    plot.append(dot);
    if (focused === String(i)) dot.focus();
  });
  const [x, y] = [place(scores[across] || 0), -place(scores[upward] || 0)];
  plot.append(svg("path", { class: "here", d: `M${x - 7} ${y}h14M${x} ${y - 7}v14` }));
}
for (const [id, first] of [["across", 0], ["upward", 1]]) {
  modes.forEach((_, k) => byId(id).append(new Option(`mode ${k + 1}`, k)));
  byId(id).value = Math.min(first, modes.length - 1);
  byId(id).addEventListener("change", drawPlot);
}
names.forEach((name, k) => {
  const item = document.createElement("li"), mark = document.createElement("span");
  mark.style.background = palette[k % palette.length];
  item.append(mark, name);
  byId("groups").append(item);
});
byId("color").append(...tests.map(({ name }, k) => new Option(name, k)), new Option("distance from the mean", "moved"),
  new Option("none", "none"));
byId("color").value = tests.length ? "0" : "none";
byId("color").addEventListener("change", update);
if (!modes.length) byId("modes").textContent = "All shapes are equal.";
if (gl) view.prepare(true);
view.listen(() => { view.prepare(true); update(); });
show();
