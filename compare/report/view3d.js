// The report's view in three dimensions: free surfaces and hulls over time, drawn with WebGL 1 and nothing else.
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
(function () {
  'use strict';

  const element = name => document.getElementById('view3d-' + name);
  const data = JSON.parse(element('data').textContent);
  const canvas = element('canvas'), slider = element('time'), play = element('play');
  const gl = canvas.getContext('webgl', {antialias: true});
  if (!gl) return;  // the sentence for readers without scripts stays

  // ---- vectors -----------------------------------------------------------------------------------------------------
  const add = (a, b, f) => [a[0] + f * b[0], a[1] + f * b[1], a[2] + f * b[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const size = box => add(box[1], box[0], -1);
  const middle = box => add(box[0], size(box), 0.5);

  // ---- shaders: one light a little above the eye, both sides of a triangle alike -----------------------------------
  const vertexShader = `
    attribute vec3 position, normal;
    uniform mat4 view, pose;
    uniform float side;  // -1: mirror image in y = 0
    varying vec3 at, n;
    void main() {
      at = (pose * vec4(position, 1.0)).xyz * vec3(1.0, side, 1.0);
      n = (pose * vec4(normal, 0.0)).xyz * vec3(1.0, side, 1.0);
      gl_Position = view * vec4(at, 1.0);
    }`;
  const segments = data.scale.stops.length - 1;
  const fragmentShader = `
    #ifdef GL_FRAGMENT_PRECISION_HIGH
    precision highp float;
    #else
    precision mediump float;
    #endif
    uniform vec3 eye, colour, stops[${segments + 1}];
    uniform vec2 range, cut;  // cut: y of a plane, and on which side of it nothing is drawn: 1, -1, or 0 for neither
    uniform bool by_height;
    varying vec3 at, n;
    void main() {
      if ((at.y - cut.x) * cut.y > 0.0) discard;
      vec3 c = colour;
      if (by_height) {
        float t = (at.z - range.x) / (range.y - range.x) * ${segments}.0;
        c = stops[0];
        for (int k = 0; k < ${segments}; ++k) c = mix(c, stops[k + 1], clamp(t - float(k), 0.0, 1.0));
      }
      vec3 to_eye = normalize(eye - at), light = normalize(to_eye + vec3(0.0, 0.0, 0.5)), m = normalize(n);
      if (dot(m, to_eye) < 0.0) m = -m;
      float shine = pow(max(dot(reflect(-light, m), to_eye), 0.0), 30.0);
      gl_FragColor = vec4(c * (0.25 + 0.75 * max(dot(m, light), 0.0)) + 0.12 * shine, 1.0);
    }`;

  const place = {};   // of the program's attributes and uniforms
  let surfaces = {};  // buffers by key, made when first shown
  function setUp() {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return false;
    gl.useProgram(program);
    for (const name of ['position', 'normal']) {
      place[name] = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(place[name]);
    }
    for (const name of ['view', 'pose', 'side', 'eye', 'colour', 'stops', 'range', 'cut', 'by_height'])
      place[name] = gl.getUniformLocation(program, name);
    gl.uniform3fv(place.stops, [].concat(...data.scale.stops));
    gl.uniform2f(place.range, data.scale.low, data.scale.high);
    gl.enable(gl.DEPTH_TEST);
    surfaces = {};
    return true;
  }

  // ---- surfaces ----------------------------------------------------------------------------------------------------
  // 16-bit numbers, low byte first, as on every machine that has WebGL.
  const numbers = base64 => new Uint16Array(Uint8Array.from(atob(base64), c => c.charCodeAt(0)).buffer);
  function positions(base64) {
    const low = data.box[0], edge = size(data.box);
    return Float32Array.from(numbers(base64), (q, i) => low[i % 3] + q / 65535 * edge[i % 3]);
  }
  /// Normal of a triangle as long as twice its area.
  function areaVector(p, a, b, c) {
    const corner = i => [p[3 * i], p[3 * i + 1], p[3 * i + 2]];
    return cross(add(corner(b), corner(a), -1), add(corner(c), corner(a), -1));
  }
  function buffer(target, values) {
    const b = gl.createBuffer();
    gl.bindBuffer(target, b);
    gl.bufferData(target, values, gl.STATIC_DRAW);
    return b;
  }
  /// Water is smooth: a point's normal is the sum of its triangles'. Hulls have edges: every triangle keeps corners of
  /// its own (the page gives few enough for 16 bits).
  function makeSurface(base64Points, base64Triangles, smooth, mirror) {
    let points = positions(base64Points), triangles = numbers(base64Triangles);
    if (!smooth) {
      const shared = points;
      points = new Float32Array(3 * triangles.length);
      triangles.forEach((c, i) => points.set(shared.subarray(3 * c, 3 * c + 3), 3 * i));
      triangles = triangles.map((c, i) => i);
    }
    const normals = new Float32Array(points.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const n = areaVector(points, triangles[t], triangles[t + 1], triangles[t + 2]);
      for (let k = 0; k < 9; ++k) normals[3 * triangles[t + Math.floor(k / 3)] + k % 3] += n[k % 3];
    }
    const step = size(data.box)[1] / 65535;
    for (let i = 1; mirror && i < points.length; i += 3)  // the halves meet on y = 0 without a gap or a crease
      if (Math.abs(points[i]) <= step) points[i] = normals[i] = 0;
    return {
      position: buffer(gl.ARRAY_BUFFER, points), normal: buffer(gl.ARRAY_BUFFER, normals),
      triangles: buffer(gl.ELEMENT_ARRAY_BUFFER, triangles), count: triangles.length
    };
  }
  const kept = (key, make) => surfaces[key] || (surfaces[key] = make());
  const water = (s, k) => kept('water ' + s + ' ' + k,
    () => makeSurface(data.sources[s].points[k], data.sources[s].triangles[k], true, data.sources[s].mirror));
  const hull = h => kept('hull ' + h, () => makeSurface(data.hulls[h].points, data.hulls[h].triangles, false, false));

  // ---- what is shown -----------------------------------------------------------------------------------------------
  const sources = data.sources.map((source, s) => ({source, s, shown: true})).filter(x => x.source.step.length > 0);
  const view = {step: data.time.length - 1, hull: true, cut: data.cut !== null, colour: 'height', layout: 'beside', playing: false};
  const camera = {};
  const opening = 32 * Math.PI / 180;  // of the camera, as in the pictures [rad]
  const narrow = 1.3;                  // pictures narrower than this, width over height, are seen from farther off

  const towardsEye = () => [Math.cos(camera.pitch) * Math.cos(camera.yaw),
    Math.cos(camera.pitch) * Math.sin(camera.yaw), Math.sin(camera.pitch)];
  const toTheRight = () => [-Math.sin(camera.yaw), Math.cos(camera.yaw), 0];

  /// A hull from astern, to one side and above, as in the pictures; a tank, or the way of its bodies, x to the right.
  function resetCamera() {
    const s = size(data.subject), ship = data.ship;
    camera.target = add(middle(data.subject), ship ? [0.35 * s[0], 0, -0.35 * s[2]] : [0, 0, 0], 1);
    camera.yaw = ship ? 0.65 : -1.1;
    camera.pitch = ship ? 0.445 : data.cut === null ? 0.5 : 0.25;
    const back = towardsEye(), right = toTheRight(), up = cross(back, right), f = 1.05 / Math.tan(opening / 2);
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map(k => s.map((edge, axis) => (k >> axis & 1 ? 0.5 : -0.5) * edge));
    const clear = v => dot(back, v) + f * Math.max(Math.abs(dot(right, v)) / narrow, Math.abs(dot(up, v)));
    camera.home = camera.distance = ship ? 1.74 * Math.max(s[0], 2 * s[1]) : Math.max(...corners.map(clear));
  }

  /// Sets the view for a picture of this width over height: a perspective, columns first.
  function lookThrough(aspect) {
    const back = towardsEye(), right = toTheRight(), up = cross(back, right);
    const distance = camera.distance * Math.max(1, narrow / aspect);
    const eye = add(camera.target, back, distance);
    const f = 1 / Math.tan(opening / 2), near = 0.02 * distance;
    const far = distance + 2 * Math.hypot(...size(data.box)) + Math.hypot(...add(camera.target, middle(data.box), -1));
    const a = (far + near) / (near - far), b = 2 * far * near / (near - far);
    const m = [];
    for (let k = 0; k < 3; ++k) m.push(f / aspect * right[k], f * up[k], a * back[k], -back[k]);
    m.push(-f / aspect * dot(right, eye), -f * dot(up, eye), -a * dot(back, eye) + b, dot(back, eye));
    gl.uniformMatrix4fv(place.view, false, m);
    gl.uniform3fv(place.eye, eye);
    return eye;
  }

  /// A colour of the style sheet (#rgb or #rrggbb), 0..1: light and dark come with it.
  function styled(name) {
    let hex = getComputedStyle(canvas).getPropertyValue(name).trim().slice(1);
    if (hex.length === 3) hex = [...hex].map(c => c + c).join('');
    return [0, 2, 4].map(k => parseInt(hex.slice(k, k + 2), 16) / 255);
  }
  const atRest = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  function drawBuffers(b, side, pose) {
    for (const name of ['position', 'normal']) {
      gl.bindBuffer(gl.ARRAY_BUFFER, b[name]);
      gl.vertexAttribPointer(place[name], 3, gl.FLOAT, false, 0, 0);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, b.triangles);
    gl.uniform1f(place.side, side);
    gl.uniformMatrix4fv(place.pose, false, pose);
    gl.drawElements(gl.TRIANGLES, b.count, gl.UNSIGNED_SHORT, 0);
  }
  function drawScene(shown, eye) {
    gl.uniform1i(place.by_height, 0);
    gl.uniform2f(place.cut, 0, 0);
    gl.uniform3fv(place.colour, [0.62, 0.63, 0.65]);
    data.hulls.forEach((h, number) => {
      if (!view.hull) return;
      const having = shown.filter(x => h.sources.includes(x.s));
      if (!h.poses && (having.length || !shown.length)) drawBuffers(hull(number), 1, atRest);
      for (const {source, s} of h.poses ? having : [])
        drawBuffers(hull(number), 1, h.poses[h.sources.indexOf(s)][source.step[view.step]]);
    });
    if (view.cut) gl.uniform2f(place.cut, data.cut, Math.sign(eye[1] - data.cut));
    for (const {source, s} of shown) {
      gl.uniform1i(place.by_height, view.colour === 'height' ? 1 : 0);
      gl.uniform3fv(place.colour, styled('--s' + s % 4));
      const b = water(s, source.step[view.step]);
      drawBuffers(b, 1, atRest);
      if (source.mirror) drawBuffers(b, -1, atRest);
    }
  }

  /// Name and time of a frame; where a run has begun later or ended earlier the picture stands still.
  function labelOf({source}) {
    const k = source.step[view.step], t = source.time[k], wanted = data.time[view.step];
    const apart = data.time.length > 1 ? (data.time[data.time.length - 1] - data.time[0]) / (data.time.length - 1) : 0;
    const still = Math.abs(t - wanted) <= apart + 1e-9 ? '' : t < wanted ? ' (its last frame)' : ' (its first frame)';
    return source.name + ', t = ' + t.toFixed(3) + ' s' + still;
  }

  let waiting = 0;
  const redraw = () => { waiting = waiting || requestAnimationFrame(draw); };
  function draw() {
    waiting = 0;
    const dots = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map(n => Math.max(1, Math.round(n * dots)));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.clearColor(...styled('--panel'), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);

    const shown = sources.filter(x => x.shown);
    const panels = view.layout === 'beside' && shown.length > 1 ? shown.map(x => [x]) : [shown];
    const across = width >= height ? panels.length : 1, down = panels.length / across;
    const labels = element('labels');
    labels.textContent = '';
    panels.forEach((panel, k) => {
      const w = width / across, h = height / down, left = k % across * w, top = Math.floor(k / across) * h;
      gl.viewport(left, height - top - h, w, h);
      drawScene(panel, lookThrough(w / h));
      panel.forEach((x, line) => {
        const label = labels.appendChild(document.createElement('div'));
        label.className = 'view3d-label';
        label.style.left = 100 * left / width + '%';
        label.style.top = `calc(${100 * top / height}% + ${1.4 * line}em)`;
        label.appendChild(document.createElement('span')).className = 'key k' + x.s % 4;
        label.appendChild(document.createTextNode(labelOf(x)));
      });
    });
    element('clock').textContent = 't = ' + data.time[view.step].toFixed(3) + ' s';
    slider.setAttribute('aria-valuetext', element('clock').textContent);
    element('legend').hidden = view.colour !== 'height';
  }

  // ---- time --------------------------------------------------------------------------------------------------------
  const stepsPerSecond = 12;
  let timer = 0;
  function setStep(step) {
    view.step = step % data.time.length;
    slider.value = view.step;
    redraw();
  }
  function setPlaying(on) {
    clearInterval(timer);
    view.playing = on;
    play.textContent = on ? 'Pause' : 'Play';
    if (on) timer = setInterval(() => setStep(view.step + 1), 1000 / stepsPerSecond);
  }

  // ---- mouse, touch and keys ---------------------------------------------------------------------------------------
  function turn(right, up) {
    camera.yaw -= right;
    camera.pitch = Math.max(-1.55, Math.min(1.55, camera.pitch + up));
    redraw();
  }
  /// By shares of the picture's height.
  function move(right, up) {
    const metres = 2 * camera.distance * Math.tan(opening / 2);
    camera.target = add(camera.target, toTheRight(), -right * metres);
    camera.target = add(camera.target, cross(towardsEye(), toTheRight()), -up * metres);
    redraw();
  }
  function zoom(factor) {
    camera.distance = Math.max(0.02 * camera.home, Math.min(20 * camera.home, camera.distance / factor));
    redraw();
  }
  const fingers = new Map();  // pointers that are down, where they were last
  canvas.addEventListener('pointerdown', e => {
    canvas.focus({preventScroll: true});
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, [e.clientX, e.clientY]);
  });
  canvas.addEventListener('pointermove', e => {
    const before = fingers.get(e.pointerId);
    if (!before) return;
    const now = [e.clientX, e.clientY], height = canvas.clientHeight;
    const dx = (now[0] - before[0]) / height, dy = (now[1] - before[1]) / height;
    if (fingers.size === 2) {
      const other = [...fingers].find(([id]) => id !== e.pointerId)[1];
      const apart = p => Math.max(10, Math.hypot(p[0] - other[0], p[1] - other[1]));
      zoom(apart(now) / apart(before));
      move(dx / 2, -dy / 2);
    } else if (e.shiftKey || e.buttons & 6) move(dx, -dy);
    else turn(3 * dx, 3 * dy);
    fingers.set(e.pointerId, now);
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
    canvas.addEventListener(end, e => fingers.delete(e.pointerId));
  canvas.addEventListener('contextmenu', e => e.preventDefault());
  canvas.addEventListener('wheel', e => {
    if (document.activeElement !== canvas) return;  // the page scrolls on until the view was clicked into
    e.preventDefault();
    zoom(Math.exp(-0.0015 * e.deltaY * (e.deltaMode === 1 ? 30 : 1)));
  }, {passive: false});
  canvas.addEventListener('keydown', e => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const arrow = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key];
    if (arrow && e.shiftKey) move(0.05 * arrow[0], 0.05 * arrow[1]);
    else if (arrow) turn(0.1 * arrow[0], 0.1 * arrow[1]);
    else if (e.key === '+' || e.key === '=') zoom(1.2);
    else if (e.key === '-') zoom(1 / 1.2);
    else if (e.key === '0') { resetCamera(); redraw(); }
    else if (e.key === ' ') setPlaying(!view.playing);
    else return;
    e.preventDefault();
  });

  // ---- controls ----------------------------------------------------------------------------------------------------
  function addToggle(text, key, change) {
    const label = element('toggles').appendChild(document.createElement('label'));
    const box = label.appendChild(document.createElement('input'));
    box.type = 'checkbox';
    box.checked = true;
    box.addEventListener('change', () => { change(box.checked); redraw(); });
    label.append(' ');
    if (key) label.appendChild(document.createElement('span')).className = 'key ' + key;
    label.append(text);  // as text, whatever it holds
  }
  for (const x of sources) addToggle(x.source.name, 'k' + x.s % 4, on => { x.shown = on; });
  if (data.hulls.length > 0) addToggle(data.ship ? 'hull' : 'bodies', '', on => { view.hull = on; });
  if (data.cut !== null) addToggle('water cut open', '', on => { view.cut = on; });
  element('layout-label').hidden = sources.length < 2;
  slider.max = data.time.length - 1;
  slider.addEventListener('input', () => { setPlaying(false); setStep(Number(slider.value)); });
  play.addEventListener('click', () => setPlaying(!view.playing));
  element('reset').addEventListener('click', () => { resetCamera(); redraw(); });
  element('colour').addEventListener('change', e => { view.colour = e.target.value; redraw(); });
  element('layout').addEventListener('change', e => { view.layout = e.target.value; redraw(); });
  canvas.addEventListener('webglcontextlost', e => e.preventDefault());  // so that it may come back
  canvas.addEventListener('webglcontextrestored', () => { if (setUp()) redraw(); });
  window.addEventListener('resize', redraw);
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);

  if (!setUp()) return;
  element('fallback').hidden = true;
  element('stage').hidden = false;
  resetCamera();
  setStep(view.step);
})();
