// The report's view in three dimensions: free surfaces, hulls and bodies over time, by three.js.
// The page gives, in the JSON block view3d-data:
//   box      low and high corner of everything drawn [m]; subject: the same of the hull or the bodies, for the camera
//   ship     the subject is a hull, seen from astern
//   cut      where bodies move in a tank, y of the plane at which the water can be cut open [m], or null
//   scale    low, high [m] and evenly spaced colours of the heights
//   time     times of the slider's steps [s]
//   sources  name, mirror (half model: draw the other side too), time of each surface, step -> number of its surface,
//            points (base64 of three 16-bit numbers each, 0..65535 over the box) and triangles (16-bit point numbers)
//   hulls    sources (numbers of those it belongs to), points, triangles; of what moves also poses, for each of its
//            sources one matrix per surface of that source, columns first
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide,
  LinearSRGBColorSpace, MathUtils, Mesh, MeshPhongMaterial, PerspectiveCamera, Plane, Scene, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

const element = name => document.getElementById('view3d-' + name);

/** Colours are shown as the page and its legend name them, without a conversion to a linear space and back. */
ColorManagement.enabled = false;
const grey = new Color(0.62, 0.63, 0.65);
const light = {ambient: 0.25 * Math.PI, direct: 0.75 * Math.PI};  // a surface scatters the 1/pi-th part
const opening = MathUtils.degToRad(32);  // of the camera, as in the pictures
const narrow = 1.3;                      // pictures narrower than this, width over height, show more of their height
const stepsPerSecond = 12;

class View3d {
  constructor(data, context) {
    this.data = data;
    this.canvas = element('canvas');
    this.low = new Vector3(...data.box[0]);
    this.edge = new Vector3(...data.box[1]).sub(this.low);
    this.renderer = new WebGLRenderer({canvas: this.canvas, context, antialias: true});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.localClippingEnabled = true;
    this.renderer.setScissorTest(true);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera();
    this.camera.up.set(0, 0, 1);
    this.lamp = new DirectionalLight(0xffffff, light.direct);
    this.scene.add(new AmbientLight(0xffffff, light.ambient), this.lamp, this.lamp.target);
    this.cutPlane = new Plane();

    this.geometries = new Map();  // by key, made when first shown
    this.shown = {step: data.time.length - 1, hull: true, cut: data.cut !== null, colour: 'height', layout: 'beside'};
    const clippingPlanes = [];
    const shine = {side: DoubleSide, specular: 0x1f1f1f, shininess: 30};
    const material = properties => new MeshPhongMaterial({...shine, ...properties});
    this.byHeight = material({vertexColors: true, clippingPlanes});
    this.waterPlanes = clippingPlanes;
    const hullMaterial = material({color: grey, flatShading: true});  // hulls have edges
    this.sources = data.sources.map((source, s) => ({source, s, shown: true})).filter(x => x.source.step.length > 0);
    for (const x of this.sources) {
      x.ofMethod = material({clippingPlanes});
      x.water = (x.source.mirror ? [1, -1] : [1]).map(side => {
        const mesh = new Mesh(undefined, this.byHeight);
        mesh.scale.y = side;
        this.scene.add(mesh);
        return mesh;
      });
    }
    // What stays is there once; what moves, once for each source that has it.
    this.solids = data.hulls.flatMap((hull, h) => (hull.poses ? hull.sources : [null]).map((s, k) => {
      const geometry = this.geometry('hull ' + h, () => this.makeGeometry(hull.points, hull.triangles));
      const mesh = new Mesh(geometry, hullMaterial);
      mesh.matrixAutoUpdate = false;
      this.scene.add(mesh);
      return {mesh, s, having: hull.sources, poses: hull.poses && hull.poses[k]};
    }));
    for (const mesh of this.scene.children) mesh.frustumCulled = false;

    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableZoom = false;  // the page scrolls on until the view was clicked into
    this.controls.addEventListener('change', () => this.redraw());
    this.resetCamera();
  }

  // ---- surfaces ----------------------------------------------------------------------------------------------------
  geometry(key, make) {
    if (!this.geometries.has(key)) this.geometries.set(key, make());
    return this.geometries.get(key);
  }
  makeGeometry(points, triangles) {
    // 16-bit numbers, low byte first, as on every machine that has WebGL.
    const numbers = base64 => new Uint16Array(Uint8Array.from(atob(base64), c => c.charCodeAt(0)).buffer);
    const low = this.low.toArray(), edge = this.edge.toArray();
    const at = Float32Array.from(numbers(points), (q, i) => low[i % 3] + q / 65535 * edge[i % 3]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(at, 3));
    geometry.setIndex(new BufferAttribute(numbers(triangles), 1));
    return geometry;
  }
  /** Water is smooth, and coloured by its height. */
  makeWater(source, k) {
    const geometry = this.makeGeometry(source.points[k], source.triangles[k]), at = geometry.attributes.position.array;
    geometry.computeVertexNormals();
    const normals = geometry.attributes.normal.array, step = this.edge.y / 65535;
    for (let i = 1; source.mirror && i < at.length; i += 3)  // the halves meet on y = 0 without a gap or a crease
      if (Math.abs(at[i]) <= step) at[i] = normals[i] = 0;
    const {low, high, stops} = this.data.scale, last = stops.length - 1, colours = new Float32Array(at.length);
    for (let i = 0; i < at.length; i += 3) {
      const t = MathUtils.clamp((at[i + 2] - low) / (high - low), 0, 1) * last, k0 = Math.min(Math.floor(t), last - 1);
      for (let c = 0; c < 3; ++c) colours[i + c] = MathUtils.lerp(stops[k0][c], stops[k0 + 1][c], t - k0);
    }
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    return geometry;
  }

  // ---- camera ------------------------------------------------------------------------------------------------------
  /** From the target to the eye. */
  back() { return this.camera.position.clone().sub(this.controls.target).normalize(); }
  place(target, yaw, pitch, distance) {
    this.controls.target.copy(target);
    this.camera.position.set(Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch));
    this.camera.position.multiplyScalar(distance).add(target);
    this.controls.update();
    this.redraw();
  }
  /** A hull from astern, to one side and above, as in the pictures; a tank, or the way of its bodies, x to the right. */
  resetCamera() {
    const {ship, cut, subject} = this.data;
    const low = new Vector3(...subject[0]), size = new Vector3(...subject[1]).sub(low);
    const target = low.addScaledVector(size, 0.5);
    if (ship) target.add(new Vector3(0.35 * size.x, 0, -0.35 * size.z));
    const yaw = ship ? 0.65 : -1.1, pitch = ship ? 0.445 : cut === null ? 0.5 : 0.25;
    const back = new Vector3(Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch));
    const right = new Vector3(-Math.sin(yaw), Math.cos(yaw), 0), up = back.clone().cross(right);
    const f = 1.05 / Math.tan(opening / 2);
    let distance = 1.74 * Math.max(size.x, 2 * size.y);
    if (!ship) {
      const half = on => (on ? 0.5 : -0.5);
      const corner = k => new Vector3(half(k & 1), half(k & 2), half(k & 4)).multiply(size);
      const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(corner);
      const clear = c => back.dot(c) + f * Math.max(Math.abs(right.dot(c)) / narrow, Math.abs(up.dot(c)));
      distance = Math.max(...corners.map(clear));
    }
    this.controls.minDistance = 0.02 * distance;
    this.controls.maxDistance = 20 * distance;
    this.place(target, yaw, pitch, distance);
  }
  turn(right, up) {
    const {target} = this.controls, back = this.back(), pitch = MathUtils.clamp(Math.asin(back.z) + up, -1.55, 1.55);
    const yaw = Math.atan2(back.y, back.x) - right;
    this.place(target.clone(), yaw, pitch, this.camera.position.distanceTo(target));
  }
  /** By shares of the picture's height. */
  move(right, up) {
    const metres = 2 * this.camera.position.distanceTo(this.controls.target) * Math.tan(opening / 2);
    const axis = k => new Vector3().setFromMatrixColumn(this.camera.matrix, k), across = axis(0), upwards = axis(1);
    const by = across.multiplyScalar(-right * metres).addScaledVector(upwards, -up * metres);
    this.controls.target.add(by);
    this.camera.position.add(by);
    this.controls.update();
    this.redraw();
  }
  zoom(factor) {
    const {target, minDistance, maxDistance} = this.controls, back = this.back();
    const distance = MathUtils.clamp(this.camera.position.distanceTo(target) / factor, minDistance, maxDistance);
    this.camera.position.copy(target).addScaledVector(back, distance);
    this.controls.update();
    this.redraw();
  }

  // ---- drawing -----------------------------------------------------------------------------------------------------
  redraw() { this.waiting = this.waiting || requestAnimationFrame(() => this.draw()); }
  styled(name) { return getComputedStyle(this.canvas).getPropertyValue(name).trim(); }
  drawPanel(panel, left, top, width, height) {
    const {camera, shown, data, controls, renderer} = this;
    for (const x of this.sources) {
      const there = panel.includes(x);
      for (const mesh of x.water) mesh.visible = there;
      if (!there) continue;
      const k = x.source.step[shown.step];
      const geometry = this.geometry(`water ${x.s} ${k}`, () => this.makeWater(x.source, k));
      x.ofMethod.color.set(this.styled('--s' + x.s % 4));
      const material = shown.colour === 'height' ? this.byHeight : x.ofMethod;
      for (const mesh of x.water) Object.assign(mesh, {geometry, material});
    }
    for (const solid of this.solids) {
      const x = solid.poses ? panel.find(y => y.s === solid.s) : panel.find(y => solid.having.includes(y.s));
      solid.mesh.visible = shown.hull && Boolean(x || (!solid.poses && panel.length === 0));
      if (solid.poses && x) solid.mesh.matrix.fromArray(solid.poses[x.source.step[shown.step]]);
    }
    this.waterPlanes.length = 0;
    if (shown.cut) {
      const side = Math.sign(camera.position.y - data.cut);  // the water on the eye's side is left out
      this.waterPlanes.push(this.cutPlane.set(new Vector3(0, -side, 0), side * data.cut));
    }
    const distance = camera.position.distanceTo(controls.target);
    camera.aspect = width / height;
    camera.fov = MathUtils.radToDeg(2 * Math.atan(Math.tan(opening / 2) * Math.max(1, narrow / camera.aspect)));
    camera.near = 0.02 * distance;
    const middle = this.low.clone().addScaledVector(this.edge, 0.5);
    camera.far = distance + 2 * this.edge.length() + middle.distanceTo(controls.target);
    camera.updateProjectionMatrix();
    this.lamp.target.position.copy(controls.target);
    this.lamp.position.copy(controls.target).add(this.back().add(new Vector3(0, 0, 0.5)));
    renderer.setViewport(left, top, width, height);
    renderer.setScissor(left, top, width, height);
    renderer.render(this.scene, camera);
  }
  /** Name and time of a frame; where a run has begun later or ended earlier the picture stands still. */
  labelOf({source}) {
    const {time} = this.data, k = source.step[this.shown.step], t = source.time[k], wanted = time[this.shown.step];
    const apart = time.length > 1 ? (time[time.length - 1] - time[0]) / (time.length - 1) : 0;
    const still = Math.abs(t - wanted) <= apart + 1e-9 ? '' : t < wanted ? ' (its last frame)' : ' (its first frame)';
    return source.name + ', t = ' + t.toFixed(3) + ' s' + still;
  }
  draw() {
    this.waiting = 0;
    const {renderer, canvas, data} = this;
    const width = Math.max(1, canvas.clientWidth), height = Math.max(1, canvas.clientHeight);
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(width, height, false);
    renderer.setClearColor(this.styled('--panel'));
    const shown = this.sources.filter(x => x.shown);
    const panels = this.shown.layout === 'beside' && shown.length > 1 ? shown.map(x => [x]) : [shown];
    const across = width >= height ? panels.length : 1, down = panels.length / across;
    const w = width / across, h = height / down;
    const labels = element('labels');
    labels.textContent = '';
    panels.forEach((panel, k) => {
      const left = k % across * w, top = Math.floor(k / across) * h;
      this.drawPanel(panel, left, height - top - h, w, h);
      panel.forEach((x, line) => {
        const label = labels.appendChild(document.createElement('div'));
        label.className = 'view3d-label';
        label.style.left = 100 * left / width + '%';
        label.style.top = `calc(${100 * top / height}% + ${1.4 * line}em)`;
        label.appendChild(document.createElement('span')).className = 'key k' + x.s % 4;
        label.append(this.labelOf(x));  // as text, whatever it holds
      });
    });
    const clock = 't = ' + data.time[this.shown.step].toFixed(3) + ' s';
    element('clock').textContent = clock;
    element('time').setAttribute('aria-valuetext', clock);
    element('legend').hidden = this.shown.colour !== 'height';
  }

  // ---- time --------------------------------------------------------------------------------------------------------
  setStep(step) {
    this.shown.step = step % this.data.time.length;
    element('time').value = this.shown.step;
    this.redraw();
  }
  setPlaying(on) {
    clearInterval(this.timer);
    this.timer = on ? setInterval(() => this.setStep(this.shown.step + 1), 1000 / stepsPerSecond) : null;
    element('play').textContent = on ? 'Pause' : 'Play';
  }
}

/** What the page's controls, the keys and changes of the window do with the view. Turning, moving and zooming with mouse
    and fingers is OrbitControls'. */
function connect(view) {
  const {canvas, data, shown} = view, slider = element('time');
  canvas.addEventListener('pointerdown', () => canvas.focus({preventScroll: true}));
  canvas.addEventListener('focus', () => { view.controls.enableZoom = true; });
  canvas.addEventListener('blur', () => { view.controls.enableZoom = false; });
  canvas.addEventListener('keydown', e => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key];
    if (arrow && e.shiftKey) view.move(0.05 * arrow[0], 0.05 * arrow[1]);
    else if (arrow) view.turn(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (e.key === '+' || e.key === '=') view.zoom(1.2);
    else if (e.key === '-') view.zoom(1 / 1.2);
    else if (e.key === '0') view.resetCamera();
    else if (e.key === ' ') view.setPlaying(!view.timer);
    else return;
    e.preventDefault();
  });

  function addToggle(text, key, change) {
    const label = element('toggles').appendChild(document.createElement('label'));
    const box = label.appendChild(document.createElement('input'));
    box.type = 'checkbox';
    box.checked = true;
    box.addEventListener('change', () => { change(box.checked); view.redraw(); });
    label.append(' ');
    if (key) label.appendChild(document.createElement('span')).className = 'key ' + key;
    label.append(text);
  }
  for (const x of view.sources) addToggle(x.source.name, 'k' + x.s % 4, on => { x.shown = on; });
  if (data.hulls.length > 0) addToggle(data.ship ? 'hull' : 'bodies', '', on => { shown.hull = on; });
  if (data.cut !== null) addToggle('water cut open', '', on => { shown.cut = on; });
  element('layout-label').hidden = view.sources.length < 2;
  slider.max = data.time.length - 1;
  slider.addEventListener('input', () => { view.setPlaying(false); view.setStep(Number(slider.value)); });
  element('play').addEventListener('click', () => view.setPlaying(!view.timer));
  element('reset').addEventListener('click', () => view.resetCamera());
  for (const choice of ['colour', 'layout'])
    element(choice).addEventListener('change', e => { shown[choice] = e.target.value; view.redraw(); });
  canvas.addEventListener('webglcontextrestored', () => view.redraw());
  window.addEventListener('resize', () => view.redraw());
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view.redraw());
}

function start() {
  const context = element('canvas').getContext('webgl2', {antialias: true});
  if (!context) return;  // the sentence for readers without scripts stays
  const view = new View3d(JSON.parse(element('data').textContent), context);
  connect(view);
  element('fallback').hidden = true;
  element('stage').hidden = false;
  view.setStep(view.shown.step);
}
// After the first screen is shown: the view stands below it.
addEventListener('load', () => setTimeout(start));
