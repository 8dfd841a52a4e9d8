const d = JSON.parse(document.getElementById("description").textContent);
const bytes = Uint8Array.from(atob(document.getElementById("data").textContent), (c) => c.charCodeAt(0)).buffer;
const vectors = ([place, size, unit]) => Float32Array.from(new Int16Array(bytes, place, size), (v) => v * unit);
const triangles = new Uint32Array(bytes, ...d.triangles);
const sphere = vectors(d.sphere);
const frames = d.frames.map((frame) => ({ ...frame, points: vectors(frame.points) }));
const normals = new Float32Array(sphere.length);
const map = byId("map"), slider = byId("time"), [width, height] = d.size;
Object.assign(map, { width, height });
const context = map.getContext("2d");

// Colors: brightness in gray, numbers of both signs from blue over white to red, others from violet to yellow.
const ramps = {
  gray: [[0, 0, 0], [255, 255, 255]],
  signed: [[33, 102, 172], [146, 197, 222], [247, 247, 247], [244, 165, 130], [178, 24, 43]],
  positive: [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]],
};

// Decoded pictures: 4 bytes for each pixel.
const decoded = new Map();
function pictureOf(array, frame) {
  const key = `${array} ${frame}`;
  if (!decoded.has(key)) {
    decoded.set(key, (async () => {
      const [place, size] = d.arrays[array].pictures[frame];
      const text = Array.from(new Uint8Array(bytes, place, size), (b) => String.fromCharCode(b)).join("");
      const image = new Image();
      image.src = "data:image/png;base64," + btoa(text);
      await image.decode();
      const scratch = Object.assign(document.createElement("canvas"), { width, height });
      const drawing = scratch.getContext("2d", { willReadFrequently: true });
      drawing.drawImage(image, 0, 0);
      const pixels = drawing.getImageData(0, 0, width, height), { ramp } = d.arrays[array];
      if (ramp !== "colors") {
        const table = Array.from({ length: 256 }, (_, k) => rampColor(ramps[ramp], (k - 1) / 254));
        table[0] = [128, 128, 128]; // no value
        for (let i = 0; i < pixels.data.length; i += 4) pixels.data.set(table[pixels.data[i]], i);
      }
      return pixels;
    })());
  }
  return decoded.get(key);
}

const view = new View(d.axes, triangles, `
  vec3 s = normalize(value);
  vec2 place = vec2(atan(s.y, s.x) / 6.28318531 + 0.5, 0.5 - asin(clamp(s.z, -1.0, 1.0)) / 3.14159265);
  color = textureLod(picture, place, 0.0).rgb;
  if (dot(s, mark) > 0.9985) color = vec3(1.0, 0.85, 0.0);`, "uniform vec3 mark;");
let mark = null;

function prepare() {
  view.prepare(false);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
    [gl.TEXTURE_WRAP_S, gl.REPEAT], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) {
    gl.texParameteri(gl.TEXTURE_2D, name, value);
  }
}

const numberText = (number) => Number(number.toPrecision(3)).toString().replace("-", "\u2212");
let wanted = 0;
async function show() {
  const now = ++wanted, k = Number(slider.value), frame = frames[k], array = d.arrays[Number(byId("color").value)];
  const pixels = await pictureOf(Number(byId("color").value), k);
  if (now !== wanted) return; // another time was chosen meanwhile
  byId("when").textContent = `${numberText(frame.time)} s: ${frame.name}`;
  byId("legend").hidden = array.ramp === "colors";
  if (array.ramp !== "colors") {
    byId("ramp").style.background = gradientOf(ramps[array.ramp]);
    byId("low").textContent = numberText(array.range[0]);
    byId("high").textContent = numberText(array.range[1]) + (array.unit ? " " + array.unit : "");
  }
  byId("measures").replaceChildren(...frame.measures.map(([name, value, unit]) => {
    const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
    head.textContent = name;
    cell.textContent = numberText(value) + (unit ? " " + unit : "");
    row.append(head, cell);
    return row;
  }));
  context.putImageData(pixels, 0, 0);
  if (mark) {
    context.strokeStyle = "#ffd900";
    context.lineWidth = 2;
    context.beginPath();
    context.arc((Math.atan2(mark[1], mark[0]) / (2 * Math.PI) + 0.5) * width, (0.5 - Math.asin(mark[2]) / Math.PI) * height,
      6, 0, 2 * Math.PI);
    context.stroke();
  }
  if (gl) {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels.data);
    gl.uniform3fv(gl.getUniformLocation(view.program, "mark"), mark || [0, 0, 0]);
    setNormals(frame.points, triangles, normals);
    view.setVertices(frame.points, normals, sphere);
    view.draw();
  }
  document.body.dataset.frame = k;
}

slider.max = frames.length - 1;
slider.addEventListener("input", show);
byId("color").append(...d.arrays.map(({ name }, k) => new Option(name, k)));
byId("color").addEventListener("change", show);
map.addEventListener("click", (event) => {
  const x = (event.offsetX / map.clientWidth - 0.5) * 2 * Math.PI, y = (0.5 - event.offsetY / map.clientHeight) * Math.PI;
  mark = [Math.cos(y) * Math.cos(x), Math.cos(y) * Math.sin(x), Math.sin(y)];
  show();
});
let playing = null;
byId("play").addEventListener("click", () => {
  if (playing) {
    clearInterval(playing);
    playing = null;
  } else {
    playing = setInterval(() => {
      slider.value = (Number(slider.value) + 1) % frames.length;
      show();
    }, 300);
  }
  byId("play").setAttribute("aria-pressed", String(Boolean(playing)));
  byId("play").textContent = playing ? "Stop" : "Play";
});
if (gl) prepare();
view.listen(() => { prepare(); show(); });
show();
