// Drawing of a surface by WebGL: light, turning and zooming. Pages define update() and label a canvas.
const byId = (id) => document.getElementById(id);
function setNormals(points, triangles, normals) {
  normals.fill(0);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    for (const v of [a, b, c]) {
      normals[v] += nx; normals[v + 1] += ny; normals[v + 2] += nz;
    }
  }
}

function rampColor(ramp, x) {
  const place = Math.min(Math.max(x, 0), 1) * (ramp.length - 1), k = Math.min(Math.floor(place), ramp.length - 2);
  return ramp[k].map((low, c) => low + (place - k) * (ramp[k + 1][c] - low));
}
const gradientOf = (ramp) => `linear-gradient(to right, ${ramp.map((c) => `rgb(${c})`).join(",")})`;

const canvas = byId("canvas");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: true });
if (!gl) byId("message").textContent = "This browser cannot draw surfaces: WebGL 2 is missing or switched off.";

// A view of triangles. The attributes p, n (normals) and c of vertices are arrays of 3 numbers each. The code of a
// fragment sets "vec3 color" from "vec3 value", the interpolated c, and may use further uniforms and a picture.
class View {
  constructor(axes, triangles, colorCode, uniforms = "") {
    Object.assign(this, { turn: axes.slice(), zoom: 1, triangles, colorCode, uniforms, waiting: false });
  }
  programOf() {
    const program = gl.createProgram();
    const sources = [[gl.VERTEX_SHADER, `#version 300 es
      in vec3 p, n, c; uniform mat3 turn; uniform vec2 scale; out vec3 normal, value;
      void main() {
        normal = turn * n; value = c;
        vec3 q = turn * p;
        gl_Position = vec4(scale * q.xy, -0.3 * q.z, 1.0);
      }`], [gl.FRAGMENT_SHADER, `#version 300 es
      precision highp float; in vec3 normal, value; out vec4 pixel; uniform sampler2D picture;
      ${this.uniforms}
      void main() {
        vec3 color;
        ${this.colorCode}
        float light = max(dot(normalize(normal), normalize(vec3(0.3, 0.5, 1.0))), 0.0);
        pixel = vec4(color * (0.35 + 0.7 * light), 1.0);
      }`]];
    for (const [kind, text] of sources) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }
  // Make everything that the graphics processor holds. Colors are bytes if isByte.
  prepare(isByte) {
    this.program = this.programOf();
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    this.buffers = ["p", "n", "c"].map((name) => {
      const buffer = gl.createBuffer(), place = gl.getAttribLocation(this.program, name);
      const bytes = isByte && name === "c";
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, bytes ? gl.UNSIGNED_BYTE : gl.FLOAT, bytes, 0, 0);
      return buffer;
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.triangles, gl.STATIC_DRAW);
  }
  setVertices(points, normals, values) {
    if (!gl) return;
    [points, normals, values].forEach((numbers, k) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[k]);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
    });
  }
  draw() {
    if (!gl || this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      const ratio = window.devicePixelRatio || 1;
      const width = Math.max(Math.round(canvas.clientWidth * ratio), 1);
      const height = Math.max(Math.round(canvas.clientHeight * ratio), 1);
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      gl.viewport(0, 0, width, height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const side = 0.9 * this.zoom * Math.min(width, height);
      gl.uniform2f(gl.getUniformLocation(this.program, "scale"), side / width, side / height);
      gl.uniformMatrix3fv(gl.getUniformLocation(this.program, "turn"), true, this.turn);
      gl.drawElements(gl.TRIANGLES, this.triangles.length, gl.UNSIGNED_INT, 0);
    });
  }
  turnBy(x, y) {
    const [cx, sx, cy, sy] = [Math.cos(y), Math.sin(y), Math.cos(x), Math.sin(x)];
    const more = [cy, 0, sy, sx * sy, cx, -sx * cy, -cx * sy, sx, cx * cy], old = this.turn;
    this.turn = more.map((_, i) => {
      const [row, column] = [3 * Math.floor(i / 3), i % 3];
      return more[row] * old[column] + more[row + 1] * old[3 + column] + more[row + 2] * old[6 + column];
    });
    this.draw();
  }
  zoomBy(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.2), 20);
    this.draw();
  }
  // Turn and zoom by pointer, wheel and keys. restore() draws again after the graphics processor was reset.
  listen(restore) {
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.turnBy(0.01 * event.movementX, 0.01 * event.movementY);
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoomBy(Math.exp(-0.001 * event.deltaY));
    }, { passive: false });
    const keys = { ArrowLeft: () => this.turnBy(-0.1, 0), ArrowRight: () => this.turnBy(0.1, 0),
      ArrowUp: () => this.turnBy(0, -0.1), ArrowDown: () => this.turnBy(0, 0.1), "+": () => this.zoomBy(1.1),
      "-": () => this.zoomBy(1 / 1.1) };
    canvas.addEventListener("keydown", (event) => {
      if (keys[event.key]) {
        event.preventDefault();
        keys[event.key]();
      }
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", restore);
  }
}
