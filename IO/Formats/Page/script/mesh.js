// The surface and its sphere.

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
