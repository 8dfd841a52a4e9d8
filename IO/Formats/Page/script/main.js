// Shows a surface beside its sphere. vtkSurfacePageWriter puts this script into a page, with the data in
// the elements "description", "data", "picture" and "three".
//
// For scripts: window.page.ready is a promise of the page being drawn; window.page.pick(view, x, y)
// picks the point under a pixel of "surface" or "sphere" and returns what is known of it, or null;
// window.page.picture() is a promise of a PNG file of both views, as a Blob.

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
  const fit = () => {
    const box = element("views").getBoundingClientRect();
    renderer.setSize(box.width, box.height, false);
  };
  fit(); // the observer is called later, at the next frame
  new ResizeObserver(() => {
    fit();
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
  ["color", "whole"].forEach((id) => element(id).addEventListener("change", () => showColor(geometry, uniforms)));
  addTools();
  element("morph").addEventListener("input", () => {
    views.surface.morph.value = Number(element("morph").value);
    redraw();
  });
  element("reset").addEventListener("click", () => {
    setTurntable(false);
    Object.values(views).forEach((view) => view.reset());
    element("morph").value = views.surface.morph.value = 0;
    redraw();
  });
  renderer = makeRenderer();
  showColor(geometry, uniforms);
  draw();
  window.page.pick = pick;
  window.page.picture = pictureOfViews;
  element("message").textContent = "";
}

window.page = {
  ready: start().catch((error) => {
    element("message").textContent = "This browser cannot show the surface: " + error.message;
    throw error;
  }),
};
