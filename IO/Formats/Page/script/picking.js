// The point under a pixel, and what is told of it.

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
