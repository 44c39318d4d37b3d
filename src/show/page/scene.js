// The scene on the canvas: one geometry for all pieces, coloured by vertex; drawn when it changes.

/** Walls between the camera and the viewing region are cut: plane.xyz . p < plane.w is their
 *  outside (show/cutaway.h); without normal they stay. */
const pieceMaterial = new THREE.ShaderMaterial({
  side: THREE.DoubleSide,
  uniforms: {light: {value: new THREE.Vector3()}},
  vertexShader: `
    attribute vec4 plane;
    attribute vec3 tint;
    attribute vec3 facing;
    uniform vec3 light;
    varying vec3 shade;
    void main() {
      shade = tint * (0.72 + 0.28 * abs(dot(facing, light)));
      bool cut = dot(plane.xyz, plane.xyz) > 0.0 && dot(plane.xyz, cameraPosition) < plane.w;
      gl_Position = cut ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: 'varying vec3 shade; void main() { gl_FragColor = vec4(shade, 1.0); }',
  polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
});

function corner(mesh, polygon, i) {
  const at = 3 * (mesh.first[polygon] + i);
  return new THREE.Vector3(mesh.corners[at], mesh.corners[at + 1], mesh.corners[at + 2]);
}
const size = (mesh, polygon) => mesh.first[polygon + 1] - mesh.first[polygon];

function normalOf(mesh, polygon) {
  const normal = new THREE.Vector3(), n = size(mesh, polygon), origin = corner(mesh, polygon, 0);
  for (let i = 1; i + 1 < n; ++i) {
    normal.add(corner(mesh, polygon, i).sub(origin).cross(corner(mesh, polygon, i + 1).sub(origin)));
  }
  return normal.normalize();
}

function centreOf(mesh, polygon) {
  const centre = new THREE.Vector3(), n = size(mesh, polygon);
  for (let i = 0; i < n; ++i) centre.add(corner(mesh, polygon, i));
  return centre.divideScalar(n);
}

/** Fans of triangles; owner[triangle] is the polygon. */
function fanGeometry(mesh) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(mesh.corners, 3));
  const triangles = mesh.first[mesh.count] - 2 * mesh.count;
  const index = new Uint32Array(3 * triangles), owner = new Uint32Array(triangles);
  for (let p = 0, t = 0; p < mesh.count; ++p) {
    for (let i = mesh.first[p] + 1; i + 1 < mesh.first[p + 1]; ++i, ++t) {
      index.set([mesh.first[p], i, i + 1], 3 * t);
      owner[t] = p;
    }
  }
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  return {geometry, owner};
}

/** Edges of the polygons as pairs of corners, each once. */
function edgeGeometry(mesh, which) {
  const places = [], met = new Set();
  for (const p of which) {
    const n = size(mesh, p);
    for (let i = 0; i < n; ++i) {
      const [a, b] = [i, (i + 1) % n].map((k) => mesh.corners.subarray(3 * (mesh.first[p] + k), 3 * (mesh.first[p] + k) + 3));
      const names = [a.join(), b.join()].sort().join(';');
      if (met.has(names)) continue;
      met.add(names);
      places.push(...a, ...b);
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(places), 3));
  return geometry;
}

class SceneView {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.scene = new THREE.Scene();
    this.up = [new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 1, 0), new THREE.Vector3(0, 0, 1)][run.upAxis];
    this.addPieces();
    this.addRegions();
    this.addViewpoints();
    this.marks = new THREE.Group();
    this.scene.add(this.marks);
    this.addCamera();
    this.caster = new THREE.Raycaster();
    this.wanted = false;
    this.coarse = false;
    this.showLines = true;
    this.pace = this.last = 0;
    window.addEventListener('resize', () => this.fit());
    this.fit();
    this.home();
  }

  addPieces() {
    const {geometry, owner} = fanGeometry(run.pieces);
    this.pieceOfTriangle = owner;
    const corners = run.pieces.first[run.pieces.count];
    const planes = new Float32Array(4 * corners), facing = new Float32Array(3 * corners);
    this.tints = new Uint8Array(3 * corners);
    for (let p = 0; p < run.pieces.count; ++p) {
      const plane = run.cutPlanes.subarray(4 * run.pieceSurface[p], 4 * run.pieceSurface[p] + 4);
      const normal = normalOf(run.pieces, p).toArray();
      for (let i = run.pieces.first[p]; i < run.pieces.first[p + 1]; ++i) {
        planes.set(plane, 4 * i);
        facing.set(normal, 3 * i);
      }
    }
    geometry.setAttribute('plane', new THREE.BufferAttribute(planes, 4));
    geometry.setAttribute('facing', new THREE.BufferAttribute(facing, 3));
    geometry.setAttribute('tint', new THREE.BufferAttribute(this.tints, 3, true));
    this.pieces = new THREE.Mesh(geometry, pieceMaterial);
    geometry.computeBoundingSphere();
    this.sphere = geometry.boundingSphere;
    const all = [...Array(run.surfaces.count).keys()];
    this.lines = new THREE.LineSegments(edgeGeometry(run.surfaces, all),
        new THREE.LineBasicMaterial({color: 0x808690, transparent: true, opacity: 0.55}));
    this.scene.add(this.pieces, this.lines);
    // As in the figures: from above, north and a little east.
    const byAxis = [new THREE.Vector3(1.6, 0.5, 0.9), new THREE.Vector3(0.5, 1.6, -0.9), new THREE.Vector3(0.5, 0.9, 1.6)];
    pieceMaterial.uniforms.light.value.copy(byAxis[run.upAxis]).normalize();
  }

  addRegions() {
    const {geometry, owner} = fanGeometry(run.regions);
    this.regionOfTriangle = owner;
    const material = new THREE.MeshBasicMaterial({color: new THREE.Color(css(palette.region)), side: THREE.DoubleSide,
      transparent: true, opacity: 0.5, depthWrite: false});
    this.regions = new THREE.Group();
    this.regionMesh = new THREE.Mesh(geometry, material);
    this.strongRegions = new THREE.Group();
    const all = [...Array(run.regions.count).keys()];
    this.regions.add(this.regionMesh, this.strongRegions, new THREE.LineSegments(edgeGeometry(run.regions, all),
        new THREE.LineBasicMaterial({color: 0x30333a, transparent: true, opacity: 0.5})));
    this.scene.add(this.regions);
  }

  addViewpoints() {
    const geometry = new THREE.SphereBufferGeometry(this.sphere.radius / 75, 16, 12);
    this.viewpoints = run.viewpoints.map((viewpoint) => {
      const dot = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({color: 0xf5f5f5}));
      dot.position.set(...viewpoint.position);
      const rim = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({color: 0x14161a, side: THREE.BackSide}));
      rim.scale.setScalar(1.25);
      dot.add(rim);
      this.scene.add(dot);
      return dot;
    });
  }

  addCamera() {
    this.camera = new THREE.PerspectiveCamera(32, 1, this.sphere.radius / 100, this.sphere.radius * 20);
    this.camera.up.copy(this.up);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener('change', () => this.moved());
  }

  home() {
    const {azimuth, elevation} = data.view;
    const [east, north] = [[[0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 0, -1]], [[1, 0, 0], [0, 1, 0]]][run.upAxis]
        .map((v) => new THREE.Vector3(...v));
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    const back = east.multiplyScalar(Math.cos(a) * Math.cos(e)).addScaledVector(north, Math.sin(a) * Math.cos(e))
        .addScaledVector(this.up, Math.sin(e));
    this.controls.target.copy(this.sphere.center);
    const wide = Math.min(1, (this.camera.aspect || 1) / 1.25);
    this.camera.position.copy(this.sphere.center).addScaledVector(back, 2.75 * this.sphere.radius / wide);
    this.controls.update();
    this.draw();
  }

  /** Turns round the target by angles in radians. */
  turn(azimuth, elevation) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const right = new THREE.Vector3().crossVectors(this.up, offset).normalize();
    const angle = offset.angleTo(this.up);
    const step = Math.min(Math.max(angle - elevation, 0.02), Math.PI - 0.02) - angle;
    offset.applyAxisAngle(right, step).applyAxisAngle(this.up, azimuth);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.moved();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.moved();
  }

  fit() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Draws as the camera moves: coarsely where the machine cannot keep up, finely at rest. */
  moved() {
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.setCoarse(false), 300);  // milliseconds
    const now = performance.now(), pause = 1000, slow = 60;  // milliseconds a frame
    if (now - this.last < pause) this.pace = (this.pace + now - this.last) / 2;
    this.last = now;
    if (this.pace > slow && !this.coarse) this.setCoarse(true);
    this.draw();
  }
  setCoarse(coarse) {
    const ratio = Math.min(window.devicePixelRatio || 1, 2), many = 20000;  // corners of lines
    if (coarse !== this.coarse) this.renderer.setPixelRatio(coarse ? ratio / 2 : ratio);
    this.coarse = coarse;
    if (!coarse) this.pace = 0;
    this.lines.visible = this.showLines && !(coarse && this.lines.geometry.attributes.position.count > many);
    this.draw();
  }

  /** Draws with the next frame. */
  draw() {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => this.drawNow());
  }
  drawNow() {
    this.wanted = false;
    this.renderer.render(this.scene, this.camera);
  }

  /** `of` gives the colour of a piece. */
  colour(of) {
    const {first, count} = run.pieces;
    for (let p = 0; p < count; ++p) {
      const [red, green, blue] = of(p);
      for (let at = 3 * first[p]; at < 3 * first[p + 1]; at += 3) {
        this.tints[at] = red;
        this.tints[at + 1] = green;
        this.tints[at + 2] = blue;
      }
    }
    this.pieces.geometry.attributes.tint.needsUpdate = true;
    this.draw();
  }

  /** `strong`: numbers of regions with their colours; the others are part of the background. */
  colourRegions(strong) {
    this.strongRegions.children.slice().forEach((child) => {
      child.geometry.dispose();
      this.strongRegions.remove(child);
    });
    for (const [region, colour, opacity] of strong) {
      const places = [], n = size(run.regions, region);
      for (let i = 1; i + 1 < n; ++i) {
        for (const k of [0, i, i + 1]) places.push(...corner(run.regions, region, k).toArray());
      }
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(places), 3));
      this.strongRegions.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
        color: new THREE.Color(css(colour)), side: THREE.DoubleSide, transparent: true, opacity, depthWrite: false})));
    }
    this.draw();
  }

  /** Outlines pieces through everything in front; `of` is run.pieces or run.regions. */
  mark(which, of, colour, lines = []) {
    this.marks.children.slice().forEach((child) => {
      child.geometry.dispose();
      this.marks.remove(child);
    });
    const add = (geometry) => {
      const shape = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: new THREE.Color(colour), depthTest: false}));
      shape.renderOrder = 10;
      this.marks.add(shape);
    };
    if (which.length) add(edgeGeometry(of, which));
    if (lines.length) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(lines), 3));
      add(geometry);
    }
    this.draw();
  }

  isCut(surface) {
    const [x, y, z, offset] = run.cutPlanes.subarray(4 * surface, 4 * surface + 4);
    const c = this.camera.position;
    return (x || y || z) && x * c.x + y * c.y + z * c.z < offset;
  }

  /** Where a point is on the canvas, CSS pixels from its top left. */
  place(point) {
    const p = point.clone().project(this.camera);
    return [(p.x + 1) / 2 * this.canvas.clientWidth, (1 - p.y) / 2 * this.canvas.clientHeight, p.z];
  }

  /** What lies at a place of the canvas: a viewpoint, else an element (or a region, if asked for). */
  pick(x, y, regions) {
    const near = 11;  // CSS pixels
    let best = null, least = near;
    this.viewpoints.forEach((dot, i) => {
      const [u, v] = this.place(dot.position);
      const distance = Math.hypot(u - x, v - y);
      if (dot.visible && distance < least) {
        least = distance;
        best = {kind: 'viewpoint', index: i};
      }
    });
    if (best) return best;
    this.camera.updateMatrixWorld();
    this.caster.setFromCamera(new THREE.Vector2(2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight), this.camera);
    const hits = this.caster.intersectObject(this.pieces).filter((hit) => !this.isCut(run.pieceSurface[this.pieceOfTriangle[hit.faceIndex]]));
    if (regions && this.regions.visible) {
      const region = this.caster.intersectObject(this.regionMesh)[0];
      if (region) return {kind: 'region', index: this.regionOfTriangle[region.faceIndex]};
    }
    if (!hits.length) return null;
    return {kind: 'element', index: run.pieceElement[this.pieceOfTriangle[hits[0].faceIndex]],
      piece: this.pieceOfTriangle[hits[0].faceIndex]};
  }
}
