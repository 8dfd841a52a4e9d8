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

  remember() {
    this.remembered = [this.mesh.quaternion.clone(), this.distance];
  }

  restore() {
    this.mesh.quaternion.copy(this.remembered[0]);
    this.distance = this.remembered[1];
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
