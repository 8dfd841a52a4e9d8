// What a person chooses, turns and clicks.

function fillChoices() {
  const add = (value, text) => element("color").add(new Option(text, value, false, Number(value) === description.first));
  add(-1, mesh.texture ? "Texture" : "None");
  mesh.arrays.forEach((array, i) => add(i, labelOf(array)));
}

function showColor(geometry, uniforms) {
  const array = mesh.arrays[Number(element("color").value)];
  uniforms.mode.value = array ? Mode[array.kind] : mesh.texture ? Mode.picture : Mode.plain;
  const hasLegend = Boolean(array) && array.kind === "numbers";
  const [low, high] = hasLegend ? paletteEnds(array, element("whole").checked) : [0, 1];
  if (array) {
    geometry.setAttribute("tint", new THREE.BufferAttribute(tintsOf(array, [low, high]), 3));
  }
  element("legend").hidden = !hasLegend;
  if (hasLegend) {
    element("legend").setAttribute("aria-label", "Legend of " + labelOf(array));
    element("ramp").style.background = `linear-gradient(to right, ${PALETTE.map((c) => `rgb(${c})`)})`;
    const textOf = (code) => valueText(array, array.whole ? array.range[0] + code
      : between(array.range, code / Math.max(array.steps, 1)));
    const [lowest, highest] = paletteEnds(array, true);
    element("low").textContent = (low > lowest ? "\u2264 " : "") + textOf(low);
    element("high").textContent = (high < highest ? "\u2265 " : "") +
      (high < highest ? textOf(high) : valueText(array, array.range[1]));
    const [first, last] = paletteEnds(array, false);
    element("clipping").hidden = first === lowest && last === highest;
    element("missing").hidden = array.missing === 0;
  }
  redraw();
}

// Turn both views about the vertical, once in 12 seconds, until the button is pressed again or a view is
// touched.
let lastTurn = null;
function setTurntable(isOn) {
  element("turntable").setAttribute("aria-pressed", String(isOn));
  const isTurning = lastTurn !== null;
  lastTurn = isOn ? performance.now() : null;
  if (!isOn || isTurning) {
    return;
  }
  const step = (now) => {
    if (lastTurn === null) {
      return;
    }
    const angle = (Math.max(now - lastTurn, 0) / 12000) * 2 * Math.PI;
    lastTurn = Math.max(now, lastTurn);
    Object.values(views).forEach((view) => view.turn(angle, 0));
    draw();
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

// What both views show now, on the color behind them, as a PNG file.
function pictureOfViews() {
  draw();
  const from = element("canvas"), picture = document.createElement("canvas");
  [picture.width, picture.height] = [from.width, from.height];
  const context = picture.getContext("2d");
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(from, 0, 0);
  return new Promise((done) => picture.toBlob(done, "image/png"));
}

async function savePicture() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(await pictureOfViews());
  link.download = document.title.replace(/[^\p{L}\p{N} ._-]/gu, "_") + ".png";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function addTools() {
  element("turntable").addEventListener("click", () => setTurntable(lastTurn === null));
  element("save").addEventListener("click", savePicture);
  element("full").hidden = !document.fullscreenEnabled; // as in frames that do not permit it
  element("full").addEventListener("click", () =>
    document.fullscreenElement ? document.exitFullscreen() : element("stage").requestFullscreen());
  document.addEventListener("fullscreenchange", () => {
    element("full").textContent = document.fullscreenElement ? "Leave full screen" : "Full screen";
  });
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
    setTurntable(false);
    both((other) => other.remember());
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
  // The browser has taken a swipe to scroll the page. Undo the turn that the start of the swipe made.
  view.box.addEventListener("pointercancel", (event) => {
    if (pointers.delete(event.pointerId)) {
      both((other) => other.restore());
      redraw();
    }
  });
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
