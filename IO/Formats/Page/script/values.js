// Numbers of arrays, and their texts.

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
