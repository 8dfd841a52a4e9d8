// Shows a surface beside its sphere. vtkSurfacePageWriter puts this into a page, with the data in the
// elements "description", "data", "picture" and "three".
//
// For scripts: window.page.ready is a promise of the page being drawn; window.page.pick(view, x, y)
// picks the point under a pixel of "surface" or "sphere" and returns what is known of it, or null.
"use strict";
window.page = {};
window.page.ready = (async () => {
  const element = (id) => document.getElementById(id);
  const PALETTE = [[38, 24, 74], [56, 82, 139], [33, 127, 141], [63, 172, 118], [170, 214, 70], [253, 231, 76]];
  const PLAIN = "#c9a27c", MISSING = "#8c8c8c", MARK = "#d81b60";
  const Mode = { plain: 0, picture: 1, numbers: 2, colors: 3 };

  // What the writer put in.

  function bytesOf(id) {
    const text = atob(element(id).textContent.trim());
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) {
      bytes[i] = text.charCodeAt(i);
    }
    return bytes;
  }

  async function inflated(id) {
    const stream = new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // Codes of a width of bytes: differences with the sign as the lowest bit, lowest bytes first.
  function codeReader(bytes) {
    let at = 0;
    return (count, width) => {
      const codes = new Uint32Array(count);
      const mask = width === 4 ? 0xffffffff : (1 << (8 * width)) - 1;
      let code = 0;
      for (let i = 0; i < count; ++i) {
        let folded = 0;
        for (let b = 0; b < width; ++b) {
          folded |= bytes[at + b * count + i] << (8 * b);
        }
        code = (code + ((folded >>> 1) ^ -(folded & 1))) & mask;
        codes[i] = code;
      }
      at += width * count;
      return codes;
    };
  }

  const between = (range, fraction) => range[0] * (1 - fraction) + range[1] * fraction;

  function directionOf(u, v) {
    let x = (2 * u) / 65535 - 1, y = (2 * v) / 65535 - 1;
    const z = 1 - Math.abs(x) - Math.abs(y);
    if (z < 0) {
      [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
    }
    const length = Math.hypot(x, y, z);
    return [x / length, y / length, z / length];
  }

  // The library, in a scope of its own. It exports as a CommonJS module does.
  function loadThree(source) {
    const script = document.createElement("script");
    script.textContent = "(function (exports, module) {" + source + "\n})(window.page.three = {}, {});";
    document.head.append(script);
    const library = window.page.three;
    delete window.page.three;
    return library;
  }

  async function loadPicture() {
    const image = new Image();
    image.src = "data:image/jpeg;base64," + element("picture").textContent.trim();
    await image.decode();
    return image;
  }

  // A vector by its coordinates along axes: right, up and towards the viewer.
  const along = (axes, v) => [0, 3, 6].map((i) => axes[i] * v[0] + axes[i + 1] * v[1] + axes[i + 2] * v[2]);

  function loadMesh(data) {
    const read = codeReader(data);
    const count = description.points;
    const codes = description.bounds.map(() => read(count, 2));
    const sphereCodes = [read(count, 2), read(count, 2)];
    const corners = read(3 * description.triangles, 4);
    const mesh = {
      codes, corners,
      shown: new Float32Array(3 * count), // in a ball of radius 1, as the sphere is
      directions: new Float64Array(3 * count),
      ball: new Float32Array(3 * count),
      texture: null,
    };
    const half = description.bounds.map(([low, high]) => high / 2 - low / 2);
    const longest = Math.max(...half) || 1;
    let radius = 0;
    for (let i = 0; i < count; ++i) {
      const place = half.map((h, c) => ((2 * codes[c][i]) / 65535 - 1) * (h / longest));
      radius = Math.max(radius, Math.hypot(...place));
      const direction = directionOf(sphereCodes[0][i], sphereCodes[1][i]);
      mesh.shown.set(along(description.surfaceAxes, place), 3 * i);
      mesh.directions.set(direction, 3 * i);
      mesh.ball.set(along(description.sphereAxes, direction), 3 * i);
    }
    mesh.shown.forEach((value, i) => { mesh.shown[i] = value / (radius || 1); });
    if (description.textureBounds) {
      const [u, v] = [read(count, 2), read(count, 2)];
      mesh.texture = new Float32Array(2 * count);
      for (let i = 0; i < count; ++i) {
        mesh.texture[2 * i] = between(description.textureBounds[0], u[i] / 65535);
        mesh.texture[2 * i + 1] = between(description.textureBounds[1], v[i] / 65535);
      }
    }
    mesh.arrays = description.arrays.map((array) => ({
      ...array,
      codes: array.kind === "colors" ? [0, 1, 2].map(() => read(count, 1)) : read(count, array.width),
    }));
    return mesh;
  }

  // Normals of the surface: where it is cut for its texture, points of one place have one normal.
  function normalsOf(mesh) {
    const count = description.points;
    const places = new Map(), placeOf = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
      const key = (mesh.codes[0][i] * 65536 + mesh.codes[1][i]) * 65536 + mesh.codes[2][i];
      if (!places.has(key)) {
        places.set(key, places.size);
      }
      placeOf[i] = places.get(key);
    }
    const sums = new Float64Array(3 * places.size), p = mesh.shown;
    for (let t = 0; t < mesh.corners.length; t += 3) {
      const [a, b, c] = [3 * mesh.corners[t], 3 * mesh.corners[t + 1], 3 * mesh.corners[t + 2]];
      const e = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
      const f = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
      const n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
      for (let k = 0; k < 3; ++k) {
        const place = 3 * placeOf[mesh.corners[t + k]];
        sums[place] += n[0];
        sums[place + 1] += n[1];
        sums[place + 2] += n[2];
      }
    }
    const normals = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) {
      const n = sums.subarray(3 * placeOf[i], 3 * placeOf[i] + 3);
      const length = Math.hypot(n[0], n[1], n[2]) || 1;
      normals.set([n[0] / length, n[1] / length, n[2] / length], 3 * i);
    }
    return normals;
  }

  // Numbers and texts.

  // With the digits that steps of this size tell.
  function numberText(value, step) {
    const digits = step > 0 ? Math.ceil(Math.log10(Math.abs(value) / step)) : 6;
    return String(Number(value.toPrecision(Math.min(Math.max(digits, 1), 15))));
  }

  function valueText(array, value) {
    if (value === null) {
      return "no value";
    }
    if (array.kind === "colors") {
      return value.join(", ");
    }
    const [low, high] = array.range;
    return array.whole ? String(value)
      : numberText(value, high / array.steps - low / array.steps);
  }

  const labelOf = (array) => (array.name || "(no name)") + (array.components > 1 ? " (length)" : "");

  function numberOf(array, point) {
    const code = array.codes[point];
    return code > array.steps ? null
      : array.whole ? array.range[0] + code : between(array.range, code / array.steps);
  }

  // Between the corners of a triangle; whole numbers and colors are those of the nearest one.
  function valueAt(array, corners, weights) {
    const nearest = corners[weights.indexOf(Math.max(...weights))];
    if (array.kind === "colors") {
      return array.codes.map((codes) => codes[nearest]);
    }
    if (array.whole) {
      return numberOf(array, nearest);
    }
    const values = corners.map((corner) => numberOf(array, corner));
    return values.includes(null) ? null : values.reduce((sum, v, k) => sum + v * weights[k], 0);
  }

  // Colors.

  function paletteBytes() {
    const bytes = new Uint8Array(4 * 256);
    for (let i = 0; i < 256; ++i) {
      const place = (i / 255) * (PALETTE.length - 1), k = Math.min(Math.floor(place), PALETTE.length - 2);
      bytes.set([0, 1, 2].map((c) => Math.round(between([PALETTE[k][c], PALETTE[k + 1][c]], place - k))), 4 * i);
      bytes[4 * i + 3] = 255;
    }
    return bytes;
  }

  // For each point its color, or the fraction of the range and whether there is a value.
  function tintsOf(array) {
    const tints = new Float32Array(3 * description.points);
    for (let i = 0; i < description.points; ++i) {
      const isMissing = array.kind === "numbers" && array.codes[i] > array.steps;
      tints.set(array.kind === "colors" ? array.codes.map((codes) => codes[i] / 255)
        : isMissing ? [0, 0, 0] : [array.codes[i] / Math.max(array.steps, 1), 1, 0], 3 * i);
    }
    return tints;
  }

  const VERTEX_SHADER = `
    attribute vec3 ball;
    attribute vec3 tint;
    uniform float morph;
    varying vec3 shownNormal;
    varying vec3 shownPosition;
    varying vec3 shownTint;
    varying vec2 place;
    void main() {
      vec4 seen = modelViewMatrix * vec4(mix(position, ball, morph), 1.0);
      shownPosition = seen.xyz;
      shownNormal = normalMatrix * mix(normal, normalize(ball), morph);
      shownTint = tint;
      place = uv;
      gl_Position = projectionMatrix * seen;
    }`;
  const FRAGMENT_SHADER = `
    uniform int mode;
    uniform sampler2D picture;
    uniform sampler2D palette;
    uniform vec3 plain;
    uniform vec3 missing;
    varying vec3 shownNormal;
    varying vec3 shownPosition;
    varying vec3 shownTint;
    varying vec2 place;
    void main() {
      vec3 color = plain;
      if (mode == ${Mode.picture}) { color = texture2D(picture, place).rgb; }
      if (mode == ${Mode.numbers}) {
        color = shownTint.y > 0.999 ? texture2D(palette, vec2(shownTint.x * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb : missing;
      }
      if (mode == ${Mode.colors}) { color = shownTint; }
      float light = abs(dot(normalize(shownNormal), normalize(shownPosition)));
      gl_FragColor = vec4(color * (0.3 + 0.7 * light), 1.0);
    }`;

  // The two views: one canvas, drawn in two parts.

  class View {
    constructor(name, geometry, uniforms, morph) {
      this.box = element(name);
      this.morph = { value: morph };
      this.camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
      this.mesh = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
        uniforms: { ...uniforms, morph: this.morph },
        vertexShader: VERTEX_SHADER, fragmentShader: FRAGMENT_SHADER, side: THREE.DoubleSide,
      }));
      this.mesh.frustumCulled = false;
      this.scene = new THREE.Scene();
      this.scene.add(this.mesh);
      // A mark with a white rim, one over the other; behind the surface it shines through.
      this.marks = [
        [0.03, { color: MARK, opacity: 0.35, depthTest: false }],
        [0.042, { color: "#ffffff" }],
        [0.03, { color: MARK }],
      ].map(([radius, look], order) => {
        const mark = new THREE.Mesh(new THREE.SphereGeometry(radius, 24, 16),
          new THREE.MeshBasicMaterial({ transparent: true, depthWrite: false, ...look }));
        mark.renderOrder = order;
        mark.visible = false;
        this.mesh.add(mark);
        return mark;
      });
      this.reset();
    }

    reset() {
      this.mesh.quaternion.set(0, 0, 0, 1);
      this.distance = 4.3;
    }

    turn(x, y) {
      const step = new THREE.Quaternion().setFromEuler(new THREE.Euler(y, x, 0));
      this.mesh.quaternion.premultiply(step).normalize();
    }

    zoom(factor) {
      this.distance = Math.min(Math.max(this.distance * factor, 1.3), 20);
    }

    prepare() {
      const { width, height } = this.box.getBoundingClientRect();
      this.camera.aspect = width / height;
      this.camera.position.z = this.distance * Math.max(1, height / width); // narrow ones show all, too
      this.camera.updateProjectionMatrix();
      this.scene.updateMatrixWorld();
      this.camera.updateMatrixWorld();
      for (const mark of this.marks) {
        mark.visible = picked !== null;
        if (picked) {
          mark.position.copy(this.placeOf(picked));
          mark.scale.setScalar(this.distance / 4.3);
        }
      }
    }

    // A point of a triangle, as the mesh shows it now.
    placeOf({ corners, weights }) {
      const place = new THREE.Vector3(), t = this.morph.value;
      corners.forEach((corner, k) => {
        const at = (c) => weights[k] * ((1 - t) * mesh.shown[3 * corner + c] + t * mesh.ball[3 * corner + c]);
        place.add(new THREE.Vector3(at(0), at(1), at(2)));
      });
      return place;
    }

    // The pixel of this view where a point of a triangle is.
    pixelOf(point) {
      this.prepare();
      this.scene.updateMatrixWorld();
      const { width, height } = this.box.getBoundingClientRect();
      const seen = this.mesh.localToWorld(this.placeOf(point)).project(this.camera);
      return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height];
    }

    // The triangle under a pixel, and the weights of its corners there; null if there is none.
    hit(x, y) {
      this.prepare();
      const { width, height } = this.box.getBoundingClientRect();
      const back = this.mesh.quaternion.clone().conjugate();
      const direction = new THREE.Vector3((2 * x) / width - 1, 1 - (2 * y) / height, 0.5)
        .unproject(this.camera).sub(this.camera.position).normalize().applyQuaternion(back);
      const origin = this.camera.position.clone().applyQuaternion(back);
      return nearestTriangle(origin.toArray(), direction.toArray(), this.morph.value);
    }

    draw(renderer) {
      this.prepare();
      const all = element("views").getBoundingClientRect(), own = this.box.getBoundingClientRect();
      const area = [own.left - all.left, all.bottom - own.bottom, own.width, own.height];
      renderer.setViewport(...area);
      renderer.setScissor(...area);
      renderer.render(this.scene, this.camera);
    }
  }

  // By the method of T. Moeller and B. Trumbore, with all triangles: a few milliseconds.
  function nearestTriangle(o, d, morph) {
    const p = new Float64Array(mesh.shown.length);
    for (let i = 0; i < p.length; ++i) {
      p[i] = (1 - morph) * mesh.shown[i] + morph * mesh.ball[i];
    }
    let nearest = Infinity, found = null;
    for (let t = 0; t < mesh.corners.length; t += 3) {
      const a = 3 * mesh.corners[t], b = 3 * mesh.corners[t + 1], c = 3 * mesh.corners[t + 2];
      const ex = p[b] - p[a], ey = p[b + 1] - p[a + 1], ez = p[b + 2] - p[a + 2];
      const fx = p[c] - p[a], fy = p[c + 1] - p[a + 1], fz = p[c + 2] - p[a + 2];
      const px = d[1] * fz - d[2] * fy, py = d[2] * fx - d[0] * fz, pz = d[0] * fy - d[1] * fx;
      const volume = ex * px + ey * py + ez * pz;
      if (volume === 0) {
        continue;
      }
      const sx = o[0] - p[a], sy = o[1] - p[a + 1], sz = o[2] - p[a + 2];
      const u = (sx * px + sy * py + sz * pz) / volume;
      if (!(u >= 0 && u <= 1)) {
        continue;
      }
      const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
      const v = (d[0] * qx + d[1] * qy + d[2] * qz) / volume;
      const distance = (fx * qx + fy * qy + fz * qz) / volume;
      if (v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) {
        nearest = distance;
        found = { corners: Array.from(mesh.corners.subarray(t, t + 3)), weights: [1 - u - v, u, v] };
      }
    }
    return found;
  }

  // Picking.

  function pick(name, x, y) {
    const hit = views[name].hit(x, y);
    picked = hit;
    showPicked();
    redraw();
    return hit && {
      ...placeOnMaps(hit),
      values: mesh.arrays.map((array) => ({ name: array.name, value: valueAt(array, hit.corners, hit.weights) })),
      pixels: { surface: views.surface.pixelOf(hit), sphere: views.sphere.pixelOf(hit) },
    };
  }

  // Position, and east longitude and latitude in degrees: north is (0, 0, 1), 0 towards (1, 0, 0).
  function placeOnMaps({ corners, weights }) {
    const mean = (value) => corners.reduce((sum, corner, k) => sum + weights[k] * value(corner), 0);
    const position = [0, 1, 2].map((c) =>
      mean((corner) => between(description.bounds[c], mesh.codes[c][corner] / 65535)));
    const [x, y, z] = [0, 1, 2].map((c) => mean((corner) => mesh.directions[3 * corner + c]));
    const degrees = 180 / Math.PI;
    return {
      position,
      longitude: (Math.atan2(y, x) * degrees + 360) % 360,
      latitude: Math.atan2(z, Math.hypot(x, y)) * degrees,
    };
  }

  function showPicked() {
    const rows = [];
    if (picked) {
      const { position, longitude, latitude } = placeOnMaps(picked);
      rows.push(["Longitude", longitude.toFixed(2) + "\u00b0"], ["Latitude", latitude.toFixed(2) + "\u00b0"]);
      position.forEach((value, c) => {
        const range = description.bounds[c];
        rows.push(["xyz"[c], numberText(value, range[1] / 65535 - range[0] / 65535)]);
      });
      for (const array of mesh.arrays) {
        rows.push([labelOf(array), valueText(array, valueAt(array, picked.corners, picked.weights))]);
      }
    }
    element("picked").replaceChildren(...rows.flatMap(([name, text]) => {
      const [term, value] = [document.createElement("dt"), document.createElement("dd")];
      term.textContent = name;
      value.textContent = text;
      return [term, value];
    }));
  }

  // The controls.

  function fillChoices() {
    const add = (value, text) => element("color").add(new Option(text, value, false, Number(value) === description.first));
    add(-1, mesh.texture ? "Texture" : "None");
    mesh.arrays.forEach((array, i) => add(i, labelOf(array)));
  }

  function showColor(geometry, uniforms) {
    const array = mesh.arrays[Number(element("color").value)];
    uniforms.mode.value = array ? Mode[array.kind] : mesh.texture ? Mode.picture : Mode.plain;
    if (array) {
      geometry.setAttribute("tint", new THREE.BufferAttribute(tintsOf(array), 3));
    }
    const hasLegend = Boolean(array) && array.kind === "numbers";
    element("legend").hidden = !hasLegend;
    if (hasLegend) {
      element("legend").setAttribute("aria-label", "Legend of " + labelOf(array));
      element("ramp").style.background = `linear-gradient(to right, ${PALETTE.map((c) => `rgb(${c})`)})`;
      element("low").textContent = valueText(array, array.range[0]);
      element("high").textContent = valueText(array, array.range[1]);
      element("missing").hidden = array.missing === 0;
    }
    redraw();
  }

  function turnable(view) {
    const both = (action) => (element("linked").checked ? Object.values(views) : [view]).forEach(action);
    const pointers = new Map();
    let hasMoved = false;
    const apart = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    view.box.addEventListener("pointerdown", (event) => {
      hasMoved = pointers.size > 0; // a second finger picks nothing
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY, first: [event.clientX, event.clientY] });
      view.box.setPointerCapture(event.pointerId);
    });
    view.box.addEventListener("pointermove", (event) => {
      const pointer = pointers.get(event.pointerId);
      if (!pointer) {
        return;
      }
      const distance = pointers.size === 2 ? apart() : 0;
      const [x, y] = [event.clientX - pointer.x, event.clientY - pointer.y];
      hasMoved = hasMoved || Math.hypot(event.clientX - pointer.first[0], event.clientY - pointer.first[1]) > 4;
      pointer.x = event.clientX;
      pointer.y = event.clientY;
      if (pointers.size === 2 && distance > 0 && apart() > 0) {
        both((other) => other.zoom(distance / apart()));
      } else if (pointers.size === 1 && hasMoved) {
        both((other) => other.turn(x * 0.008, y * 0.008));
      }
      redraw();
    });
    view.box.addEventListener("pointerup", (event) => {
      const box = view.box.getBoundingClientRect();
      if (pointers.delete(event.pointerId) && !hasMoved) {
        pick(view.box.id, event.clientX - box.left, event.clientY - box.top);
      }
    });
    view.box.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
    view.box.addEventListener("wheel", (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 0 ? event.deltaY / 40 : event.deltaY;
      both((other) => other.zoom(1.05 ** Math.min(Math.max(lines, -4), 4)));
      redraw();
    }, { passive: false });
    const step = Math.PI / 36;
    const keys = {
      ArrowLeft: (other) => other.turn(-step, 0), ArrowRight: (other) => other.turn(step, 0),
      ArrowUp: (other) => other.turn(0, -step), ArrowDown: (other) => other.turn(0, step),
      "+": (other) => other.zoom(1 / 1.1), "=": (other) => other.zoom(1 / 1.1), "-": (other) => other.zoom(1.1),
      Home: (other) => other.reset(),
    };
    view.box.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) {
        return;
      }
      if (event.key === "Enter" || event.key === " ") {
        pick(view.box.id, view.box.clientWidth / 2, view.box.clientHeight / 2);
      } else if (keys[event.key]) {
        both(keys[event.key]);
        redraw();
      } else {
        return;
      }
      event.preventDefault();
    });
  }

  function makeRenderer() {
    const canvas = element("canvas");
    const context = canvas.getContext("webgl2", { antialias: true, alpha: true });
    if (!context) {
      throw new Error("it has no WebGL 2");
    }
    const renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setScissorTest(true);
    canvas.addEventListener("webglcontextrestored", () => redraw());
    new ResizeObserver(() => {
      const box = element("views").getBoundingClientRect();
      renderer.setSize(box.width, box.height, false);
      draw();
    }).observe(element("views"));
    return renderer;
  }

  function makeTexture(image, width, height) {
    const texture = image instanceof Image ? new THREE.Texture(image)
      : new THREE.DataTexture(image, width, height, THREE.RGBAFormat);
    if (image instanceof Image) {
      const wrap = description.repeatsTexture ? THREE.RepeatWrapping : THREE.ClampToEdgeWrapping;
      texture.wrapS = texture.wrapT = wrap;
      texture.anisotropy = 16; // triangles at the border of a picture may be long and thin in it
    } else {
      texture.minFilter = texture.magFilter = THREE.LinearFilter;
    }
    texture.needsUpdate = true;
    return texture;
  }

  let THREE, mesh, renderer, picked = null, isWaiting = false;
  const views = {};
  const description = JSON.parse(element("description").textContent);

  function draw() {
    if (renderer) {
      Object.values(views).forEach((view) => view.draw(renderer));
    }
  }

  function redraw() {
    if (!isWaiting) {
      isWaiting = true;
      requestAnimationFrame(() => {
        isWaiting = false;
        draw();
      });
    }
  }

  async function start() {
    THREE = loadThree(new TextDecoder().decode(await inflated("three")));
    mesh = loadMesh(await inflated("data"));
    const geometry = new THREE.BufferGeometry();
    const add = (name, values, size) => geometry.setAttribute(name, new THREE.BufferAttribute(values, size));
    add("position", mesh.shown, 3);
    add("normal", normalsOf(mesh), 3);
    add("ball", mesh.ball, 3);
    add("uv", mesh.texture || new Float32Array(2 * description.points), 2);
    add("tint", new Float32Array(3 * description.points), 3);
    geometry.setIndex(new THREE.BufferAttribute(mesh.corners, 1));
    const palette = makeTexture(paletteBytes(), 256, 1);
    const vector = (text) => new THREE.Vector3(...[1, 3, 5].map((i) => parseInt(text.substr(i, 2), 16) / 255));
    const uniforms = {
      mode: { value: Mode.plain }, palette: { value: palette },
      picture: { value: mesh.texture ? makeTexture(await loadPicture()) : palette },
      plain: { value: vector(PLAIN) }, missing: { value: vector(MISSING) },
    };
    views.surface = new View("surface", geometry, uniforms, 0);
    views.sphere = new View("sphere", geometry, uniforms, 1);
    Object.values(views).forEach(turnable);
    fillChoices();
    element("color").addEventListener("change", () => showColor(geometry, uniforms));
    element("morph").addEventListener("input", () => {
      views.surface.morph.value = Number(element("morph").value);
      redraw();
    });
    element("reset").addEventListener("click", () => {
      Object.values(views).forEach((view) => view.reset());
      element("morph").value = views.surface.morph.value = 0;
      redraw();
    });
    renderer = makeRenderer();
    showColor(geometry, uniforms);
    window.page.pick = pick;
    element("message").textContent = "";
  }

  try {
    await start();
  } catch (error) {
    element("message").textContent = "This browser cannot show the surface: " + error.message;
    throw error;
  }
})();
