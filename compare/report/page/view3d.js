// The report's view in three dimensions: free surfaces, hulls and bodies over time, by three.js.
// The page gives, in the JSON block view3d-data:
//   box      low and high corner of everything drawn [m]; subject: the same of the hull or the bodies, for the camera
//   ship     the subject is a hull, seen from astern
//   cut      where bodies move in a tank, y of the plane at which the water can be cut open [m], or null
//   scale    low, high [m] and evenly spaced colours of the heights; pressure: the colours of the hull's, or null
//   time     times of the slider's steps [s]
//   sources  name, mirror (half model: draw the other side too), time of each surface, step -> number of its surface,
//            water: points and triangles (how many each surface has), steps (numbers of places over the box's edges) and
//            block, as SurfacePack in view3d_mesh.h says
//   hulls    sources (numbers of those it belongs to), surface (as water, of one surface); pressures: for each of its sources a byte per
//            triangle in base64, 0..254 over the colours and 255 for dry, or null; of what moves also poses, for each of
//            its sources one matrix per surface of that source, columns first
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, ColorManagement, DirectionalLight, DoubleSide,
  LinearSRGBColorSpace, MathUtils, Mesh, MeshPhongMaterial, PerspectiveCamera, Plane, Scene, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';

const element = name => document.getElementById('view3d-' + name);

/** Colours are shown as the page and its legend name them, without a conversion to a linear space and back. */
ColorManagement.enabled = false;
const grey = new Color(0.62, 0.63, 0.65);
// A surface scatters the 1/pi-th part. Where colours are values of pressure they are hardly shaded, as in the pictures.
const light = {ambient: 0.25 * Math.PI, direct: 0.75 * Math.PI}, evenLight = {ambient: 0.8 * Math.PI, direct: 0.2 * Math.PI};
const dry = 255;  // in place of a pressure
const opening = MathUtils.degToRad(32);  // of the camera, as in the pictures
const narrow = 1.3;                      // pictures narrower than this, width over height, show more of their height
const stepsPerSecond = 12;

const bytesOf = base64 => Uint8Array.from(atob(base64), c => c.charCodeAt(0));
/** The colour at this share of a scale of evenly spaced ones. */
function colourAt(stops, share) {
  const last = stops.length - 1, t = MathUtils.clamp(share, 0, 1) * last, k = Math.min(Math.floor(t), last - 1);
  return stops[k].map((c, i) => MathUtils.lerp(c, stops[k + 1][i], t - k));
}

/** One list of points (three numbers each) and triangles (three point numbers each) for every surface of a block. */
async function unpacked({points, triangles, steps, block}) {
  if (!block) return [];
  const stream = new Blob([bytesOf(block)]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  let at = 0;
  const row = count => {
    const low = bytes.subarray(at, at + count), high = bytes.subarray(at + count, at + 2 * count);
    let number = 0;
    at += 2 * count;
    return Uint16Array.from(low, (byte, i) => {
      const folded = byte | high[i] << 8;
      return number = (number + (folded >> 1 ^ -(folded & 1))) & 65535;
    });
  };
  const surfaces = points.map(count => {
    const axes = [row(count), row(count), row(count)], places = new Uint16Array(3 * count);
    axes.forEach((axis, a) => axis.forEach((place, i) => { places[3 * i + a] = place; }));
    return {points: places, steps};
  });
  surfaces.forEach((surface, k) => { surface.triangles = row(3 * triangles[k]); });
  return surfaces;
}

class View3d {
  constructor(data, context) {
    this.data = data;
    this.canvas = element('canvas');
    this.low = new Vector3(...data.box[0]);
    this.edge = new Vector3(...data.box[1]).sub(this.low);
    this.renderer = new WebGLRenderer({canvas: this.canvas, context});
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.localClippingEnabled = true;
    this.renderer.setScissorTest(true);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera();
    this.camera.up.set(0, 0, 1);
    this.lamp = new DirectionalLight(0xffffff);
    this.glow = new AmbientLight(0xffffff);
    this.scene.add(this.glow, this.lamp, this.lamp.target);
    this.cutPlane = new Plane();

    this.geometries = new Map();  // by key, made when first shown
    this.shown = {step: data.time.length - 1, hull: true, cut: data.cut !== null, colour: 'height', layout: 'beside'};
    const clippingPlanes = [];
    const shine = {side: DoubleSide, specular: 0x1f1f1f, shininess: 30};
    const material = properties => new MeshPhongMaterial({...shine, ...properties});
    this.byHeight = material({vertexColors: true, clippingPlanes});
    this.waterPlanes = clippingPlanes;
    this.faint = material({color: 0x8fb2c9, transparent: true, opacity: 0.3, depthWrite: false, clippingPlanes});
    this.hullGrey = material({color: grey, flatShading: true});  // hulls have edges
    // Behind the faint water in the order of drawing, which would change its colours.
    this.byPressure = material({vertexColors: true, flatShading: true, specular: 0, transparent: true});
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
      const mesh = new Mesh();
      mesh.matrixAutoUpdate = false;
      mesh.renderOrder = 1;
      this.scene.add(mesh);
      return {mesh, s, h, hull, poses: hull.poses && hull.poses[k]};
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
  makeGeometry({points, triangles, steps}) {
    const low = this.low.toArray(), edge = this.edge.toArray();
    const at = Float32Array.from(points, (q, i) => low[i % 3] + q / steps * edge[i % 3]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(at, 3));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    return geometry;
  }
  /** Water is smooth, and coloured by its height. */
  makeWater(source, k) {
    const geometry = this.makeGeometry(source.surfaces[k]), at = geometry.attributes.position.array;
    geometry.computeVertexNormals();
    const normals = geometry.attributes.normal.array, step = this.edge.y / source.water.steps;
    for (let i = 1; source.mirror && i < at.length; i += 3)  // the halves meet on y = 0 without a gap or a crease
      if (Math.abs(at[i]) <= step) at[i] = normals[i] = 0;
    const {low, high, stops} = this.data.scale, colours = new Float32Array(at.length);
    for (let i = 0; i < at.length; i += 3) colours.set(colourAt(stops, (at[i + 2] - low) / (high - low)), i);
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    return geometry;
  }
  hullGeometry(h) {
    return this.geometry('hull ' + h, () => this.makeGeometry(this.data.hulls[h].surfaces[0]));
  }
  /** Every triangle of a hull with the one colour of its pressure. */
  makePressed(h, bytes) {
    const geometry = this.hullGeometry(h).toNonIndexed(), colours = new Float32Array(9 * bytes.length);
    const {stops} = this.data.pressure, none = grey.toArray();
    bytes.forEach((byte, t) => {
      const colour = byte === dry ? none : colourAt(stops, byte / (dry - 1));
      for (let corner = 0; corner < 3; ++corner) colours.set(colour, 9 * t + 3 * corner);
    });
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    return geometry;
  }
  /** What a hull or a body looks like with this source. */
  looks({h, hull}, x) {
    const pressures = x && this.shown.colour === 'pressure' && hull.pressures[hull.sources.indexOf(x.s)];
    if (!pressures) return {geometry: this.hullGeometry(h), material: this.hullGrey};
    const geometry = this.geometry(`hull ${h} of ${x.s}`, () => this.makePressed(h, bytesOf(pressures)));
    return {geometry, material: this.byPressure};
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
  /** A hull from astern, to one side and above, as in the pictures, or with its pressures from below; a tank, or the way
      of its bodies, x to the right. */
  resetCamera() {
    const {ship, cut, subject} = this.data, below = this.shown.colour === 'pressure';
    const low = new Vector3(...subject[0]), size = new Vector3(...subject[1]).sub(low);
    const target = low.addScaledVector(size, 0.5);
    if (ship && !below) target.add(new Vector3(0.35 * size.x, 0, -0.35 * size.z));
    const yaw = ship ? 0.65 : -1.1, pitch = below ? -0.7 : ship ? 0.445 : cut === null ? 0.5 : 0.25;
    const back = new Vector3(Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch));
    const right = new Vector3(-Math.sin(yaw), Math.cos(yaw), 0), up = back.clone().cross(right);
    const f = 1.05 / Math.tan(opening / 2);
    let distance = (below ? 1.6 : 1.74) * Math.max(size.x, 2 * size.y);
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
      const material = {height: this.byHeight, pressure: this.faint, method: x.ofMethod}[shown.colour];
      for (const mesh of x.water) Object.assign(mesh, {geometry, material});
    }
    for (const solid of this.solids) {
      const x = panel.find(y => (solid.poses ? y.s === solid.s : solid.hull.sources.includes(y.s)));
      Object.assign(solid.mesh, this.looks(solid, x));
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
    const lit = shown.colour === 'pressure' ? evenLight : light;
    this.glow.intensity = lit.ambient;
    this.lamp.intensity = lit.direct;
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
    const {colour, layout} = this.shown, beside = layout === 'beside' || colour === 'pressure';  // a hull has one colour
    const panels = beside && shown.length > 1 ? shown.map(x => [x]) : [shown];
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
    element('legend').hidden = colour !== 'height';
    if (data.pressure) element('pressure').hidden = colour !== 'pressure';
    element('layout').disabled = colour === 'pressure';
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
  element('layout').addEventListener('change', e => { shown.layout = e.target.value; view.redraw(); });
  element('colour').addEventListener('change', e => {
    const turned = [shown.colour, e.target.value].includes('pressure');
    shown.colour = e.target.value;
    if (turned) view.resetCamera();
    view.redraw();
  });
  canvas.addEventListener('webglcontextrestored', () => view.redraw());
  window.addEventListener('resize', () => view.redraw());
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view.redraw());
}

/** The stage takes the place of the sentence for readers without scripts, or gives it back. */
function showStage(shown) {
  element('fallback').hidden = shown;
  element('stage').hidden = !shown;
}

async function start() {
  try {
    const context = element('canvas').getContext('webgl2', {antialias: true});
    if (!context) return showStage(false);
    const data = JSON.parse(element('data').textContent);
    for (const source of data.sources) source.surfaces = await unpacked(source.water);
    for (const hull of data.hulls) hull.surfaces = await unpacked(hull.surface);
    const view = new View3d(data, context);
    connect(view);
    view.setStep(view.shown.step);
  } catch (error) {
    showStage(false);
    throw error;
  }
}

// A drawing context alone can take a second, so it is made when the view comes near the screen. Its place is there from
// the beginning: nothing moves then.
showStage(true);
new IntersectionObserver((entries, observer) => {
  if (!entries.some(entry => entry.isIntersecting)) return;
  observer.disconnect();
  start();
}, {rootMargin: '600px 0px'}).observe(element('stage'));
