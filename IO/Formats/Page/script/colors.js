// Colors: of arrays, and how they are shaded.
const PALETTE = [[38, 24, 74], [56, 82, 139], [33, 127, 141], [63, 172, 118], [170, 214, 70], [253, 231, 76]];
const PLAIN = "#c9a27c", MISSING = "#8c8c8c", MARK = "#d81b60";
const Mode = { plain: 0, picture: 1, numbers: 2, colors: 3 };

function paletteBytes() {
  const bytes = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    const place = (i / 255) * (PALETTE.length - 1), k = Math.min(Math.floor(place), PALETTE.length - 2);
    bytes.set([0, 1, 2].map((c) => Math.round(between([PALETTE[k][c], PALETTE[k + 1][c]], place - k))), 4 * i);
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

// The codes that the ends of the palette stand for. If the smallest and the largest hundredth of the
// values take more than a third of their range, these are left to the ends of the palette.
function paletteEnds(array, isWhole) {
  const ends = [0, Math.max(array.steps, 1)];
  if (array.whole || isWhole) {
    return ends;
  }
  const codes = array.codes.filter((code) => code <= array.steps).sort();
  const [low, high] = [0.01, 0.99].map((part) => codes[Math.round(part * (codes.length - 1))]);
  return high > low && 1.5 * (high - low) < array.steps ? [low, high] : ends;
}

// For each point its color, or the fraction of the palette and whether there is a value.
function tintsOf(array, [low, high]) {
  const fraction = (code) => Math.min(Math.max((code - low) / (high - low), 0), 1);
  const tints = new Float32Array(3 * description.points);
  for (let i = 0; i < description.points; ++i) {
    const isMissing = array.kind === "numbers" && array.codes[i] > array.steps;
    tints.set(array.kind === "colors" ? array.codes.map((codes) => codes[i] / 255)
      : isMissing ? [0, 0, 0] : [fraction(array.codes[i]), 1, 0], 3 * i);
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
