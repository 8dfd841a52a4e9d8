// What a person chooses, turns and clicks.

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
