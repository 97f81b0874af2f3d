'use strict';
// Shows a cloud and its skeleton. Coordinates of the scene: the centre of the box is the origin, its
// diagonal is 1.

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);
const skeleton = data.skeleton;
const vertexCount = skeleton.radius.length;
const edgeCount = skeleton.edges.length / 2;

/// Numbers for people: about four digits.
function short(x) {
  return x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6) ? x.toExponential(2)
    : String(Number(x.toPrecision(4)));
}

// --- Data -------------------------------------------------------------------------------------

function decoded(base64) {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;
}

/// Of the cloud, from 16 bits per coordinate to the scene.
function cloudPositions() {
  const bits = new Uint16Array(decoded(data.cloud.positions));
  const result = new Float32Array(bits.length);
  for (let i = 0; i < bits.length; ++i)
    result[i] = (data.cloud.lower[i % 3] + bits[i] / 65535 * data.cloud.size[i % 3]
      - data.centre[i % 3]) / data.diagonal;
  return result;
}

/// Of the vertices; they are given relative to the centre.
const vertices = Float32Array.from(skeleton.points, (x) => x / data.diagonal);

const degree = new Array(vertexCount).fill(0);
for (const vertex of skeleton.edges)
  ++degree[vertex];

/// The x, y, z of these vertices.
function positionsOf(chosen) {
  const result = new Float32Array(3 * chosen.length);
  chosen.forEach((v, i) => result.set(vertices.subarray(3 * v, 3 * v + 3), 3 * i));
  return result;
}

// --- Colours ----------------------------------------------------------------------------------

const RAMP = ['#1b0c7a', '#5b02a3', '#9a179b', '#cb4678', '#eb7852', '#fba72f']
  .map((text) => new THREE.Color(text));
const PALETTE = ['#3366cc', '#dc3912', '#109618', '#990099', '#e08a00', '#0099c6', '#dd4477',
  '#66aa00', '#b82e2e', '#316395', '#994499', '#22aa99', '#8a7d00', '#6633cc', '#a0522d', '#4b6b50']
  .map((text) => new THREE.Color(text));
const CLOUD_COLOUR = new THREE.Color('#9aa4b1');

function ramp(share) {
  const at = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const i = Math.min(Math.floor(at), RAMP.length - 2);
  return RAMP[i].clone().lerp(RAMP[i + 1], at - i);
}

const orders = skeleton.branches.map((branch) => branch.order);
const scales = {
  radius: [Math.min(...skeleton.radius), Math.max(...skeleton.radius)],
  order: [0, Math.max(0, ...orders)],
};

function shareOf(name, value) {
  const [least, greatest] = scales[name];
  return greatest > least ? (value - least) / (greatest - least) : 0;
}

/// The colour of an edge where it has this vertex.
function edgeColour(name, edge, vertex) {
  const branch = skeleton.edge_branches[edge];
  if (name === 'branch')
    return PALETTE[branch % PALETTE.length];
  return ramp(name === 'radius' ? shareOf(name, skeleton.radius[vertex])
    : shareOf(name, orders[branch]));
}

// --- Scene ------------------------------------------------------------------------------------

const discTexture = (() => {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const context = canvas.getContext('2d');
  context.arc(32, 32, 30, 0, 2 * Math.PI);
  context.fillStyle = '#ffffff';
  context.fill();
  return new THREE.CanvasTexture(canvas);
})();

function dots(positions, size, options) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  return new THREE.Points(geometry, new THREE.PointsMaterial(
    { size, sizeAttenuation: false, map: discTexture, transparent: true, ...options }));
}

const scene = new THREE.Scene();
function add(object, order) {
  object.renderOrder = order;
  object.frustumCulled = false;
  scene.add(object);
  return object;
}

// Many points are drawn small and faint, so that the skeleton shows through.
const isDense = data.cloud.count > 60000;
const cloud = add(dots(cloudPositions(), isDense ? 1.8 : 2.4,
  { depthWrite: false, opacity: isDense ? 0.25 : 0.55, vertexColors: THREE.VertexColors }), 0);

// Not transparent, but what is called so is drawn after the cloud.
const lineMaterial = new THREE.LineMaterial(
  { linewidth: 5, vertexColors: THREE.VertexColors, transparent: true });
const lines = new THREE.LineSegments2(
  new THREE.LineSegmentsGeometry().setPositions(positionsOf(skeleton.edges)), lineMaterial);
if (edgeCount > 0)
  add(lines, 1);

/// Dots with a white rim around them.
function marks(chosen, colour) {
  const group = new THREE.Group();
  for (const [size, fill] of [[13, '#ffffff'], [9, colour]]) {
    const object = dots(positionsOf(chosen), size, { color: fill, depthTest: false });
    object.frustumCulled = false;
    object.renderOrder = size === 13 ? 2 : 3;
    group.add(object);
  }
  scene.add(group);
  return group;
}
const every = [...Array(vertexCount).keys()];
const junctions = marks(every.filter((v) => degree[v] >= 3), '#d7191c');
const tips = marks(every.filter((v) => degree[v] <= 1), '#1f8fff');

function colourSkeleton() {
  const name = byId('skeleton_colour').value;
  const colours = new Float32Array(6 * edgeCount);
  skeleton.edges.forEach((vertex, i) =>
    edgeColour(name, i >> 1, vertex).toArray(colours, 3 * i));
  lines.geometry.setColors(colours);
  byId('scale').hidden = name === 'branch';
  if (name !== 'branch') {
    byId('scale_name').textContent = name;
    byId('scale_least').textContent = short(scales[name][0]);
    byId('scale_greatest').textContent = short(scales[name][1]);
  }
}

function colourCloud() {
  const byBranch = byId('cloud_colour').value === 'branch';
  const branches = byBranch ? new Uint16Array(decoded(data.cloud.branches)) : [];
  const outlier = 65535;
  const colours = new Float32Array(3 * data.cloud.count);
  for (let i = 0; i < data.cloud.count; ++i) {
    const isKnown = byBranch && branches[i] !== outlier;
    (isKnown ? PALETTE[branches[i] % PALETTE.length] : CLOUD_COLOUR).toArray(colours, 3 * i);
  }
  cloud.geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
}

// --- View -------------------------------------------------------------------------------------

const FIELD_OF_VIEW = 25; // degrees; narrow, so that near and far are about as large
const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
const renderer = (() => {
  try {
    return new THREE.WebGLRenderer({ antialias: true, alpha: true });
  } catch (error) {
    byId('no_webgl').hidden = false;
    return null;
  }
})();
const controls = renderer && new THREE.OrbitControls(camera, renderer.domElement);

/// From the broader side, a little from the left and from above, and so far that all is in sight.
function resetView() {
  const up = new THREE.Vector3().setComponent(data.up, 1);
  const sides = [0, 1, 2].filter((axis) => axis !== data.up);
  const depth = data.size[sides[0]] < data.size[sides[1]] ? sides[0] : sides[1];
  const towards = new THREE.Vector3().setComponent(depth, depth === 1 ? -1 : 1);
  const aside = new THREE.Vector3().crossVectors(up, towards);
  towards.addScaledVector(aside, -0.35).addScaledVector(up, 0.2).normalize();
  const right = new THREE.Vector3().crossVectors(up, towards).normalize();
  const above = new THREE.Vector3().crossVectors(towards, right);
  const slope = Math.tan(THREE.Math.degToRad(FIELD_OF_VIEW / 2));
  const point = new THREE.Vector3();
  let distance = 0;
  for (const array of [cloud.geometry.getAttribute('position').array, vertices])
    for (let i = 0; i < array.length; i += 3) {
      point.fromArray(array, i);
      const extent = Math.max(Math.abs(point.dot(right)) / Math.min(camera.aspect, 1.6),
        Math.abs(point.dot(above)));
      distance = Math.max(distance, extent / slope + point.dot(towards));
    }
  camera.up.copy(up);
  camera.position.copy(towards).multiplyScalar(1.1 * Math.max(distance, 0.1));
  controls.target.set(0, 0, 0);
  controls.update();
  draw();
}

/// All of it, now.
function draw() {
  cloud.geometry.setDrawRange(0, Infinity);
  renderer.render(scene, camera);
}

/// While the view moves, only as many points of the cloud are drawn as leave 25 frames a second: a
/// beginning, as they come in no order. Nothing is done while it rests.
const motion =
  { points: 50000, isRunning: false, isNew: false, isDrawn: false, tick: 0, changed: 0 };

function move() {
  motion.isNew = true;
  motion.changed = performance.now();
  if (!motion.isRunning)
    requestAnimationFrame(moveOn);
  motion.isRunning = true;
}

function moveOn(now) {
  const [FAST, SLOW, REST] = [25, 40, 250]; // milliseconds
  if (motion.isDrawn && now - motion.tick > SLOW)
    motion.points = Math.max(2000, motion.points / 2);
  else if (motion.isDrawn && now - motion.tick < FAST)
    motion.points = Math.min(1.2 * motion.points, data.cloud.count);
  motion.tick = now;
  motion.isDrawn = motion.isNew;
  motion.isRunning = now - motion.changed < REST;
  if (!motion.isRunning) {
    motion.isDrawn = false;
    draw();
    return;
  }
  if (motion.isNew) {
    cloud.geometry.setDrawRange(0, Math.round(motion.points));
    renderer.render(scene, camera);
    motion.isNew = false;
  }
  requestAnimationFrame(moveOn);
}

function fit() {
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setSize(window.innerWidth, window.innerHeight);
  lineMaterial.resolution.set(window.innerWidth, window.innerHeight);
  camera.aspect = window.innerWidth / window.innerHeight;
  // The panel covers the left: what is shown is in the middle of the rest.
  camera.setViewOffset(window.innerWidth, window.innerHeight,
    -Math.min(130, window.innerWidth / 6), 0, window.innerWidth, window.innerHeight);
  camera.updateProjectionMatrix();
  draw();
}

// --- Picking ----------------------------------------------------------------------------------

/// Where the vertices are on the screen: x, y in pixels.
function projected() {
  const result = new Float32Array(2 * vertexCount);
  const point = new THREE.Vector3();
  for (let v = 0; v < vertexCount; ++v) {
    point.fromArray(vertices, 3 * v).project(camera);
    result[2 * v] = (point.x + 1) / 2 * window.innerWidth;
    result[2 * v + 1] = (1 - point.y) / 2 * window.innerHeight;
  }
  return result;
}

/// The edge nearest to a place on the screen, and where on it that is; null if it is too far.
function nearestEdge(x, y) {
  const REACH = 12; // pixels
  const screen = projected();
  let found = null, least = REACH;
  for (let e = 0; e < edgeCount; ++e) {
    const [a, b] = [2 * skeleton.edges[2 * e], 2 * skeleton.edges[2 * e + 1]];
    const [dx, dy] = [screen[b] - screen[a], screen[b + 1] - screen[a + 1]];
    const along = ((x - screen[a]) * dx + (y - screen[a + 1]) * dy) / (dx * dx + dy * dy || 1);
    const share = Math.min(Math.max(along, 0), 1);
    const distance = Math.hypot(screen[a] + share * dx - x, screen[a + 1] + share * dy - y);
    if (distance < least) {
      least = distance;
      found = { edge: e, share };
    }
  }
  return found;
}

function showPicked(event) {
  const picked = byId('picked');
  const found = event.buttons === 0 && byId('show_skeleton').checked
    && nearestEdge(event.clientX, event.clientY);
  picked.hidden = !found;
  if (!found)
    return;
  const [a, b] = skeleton.edges.slice(2 * found.edge, 2 * found.edge + 2);
  const mixed = (values, at, step) =>
    (1 - found.share) * values[step * a + at] + found.share * values[step * b + at];
  const number = skeleton.edge_branches[found.edge];
  const branch = skeleton.branches[number];
  const place = [0, 1, 2].map((axis) =>
    (data.centre[axis] + mixed(skeleton.points, axis, 3)).toFixed(data.decimals)).join(', ');
  const rows = [['radius', short(mixed(skeleton.radius, 0, 1))], ['place', place],
    ['branch', `${number}, of order ${branch.order}`], ['its length', short(branch.length)],
    ['its mean radius', short(branch.mean_radius)]];
  if (branch.points !== null)
    rows.push(['its points', branch.points.toLocaleString('en')]);
  const table = document.createElement('table');
  for (const [name, value] of rows) {
    const row = table.insertRow();
    const head = document.createElement('th');
    head.textContent = name;
    row.append(head);
    row.insertCell().textContent = value;
  }
  picked.replaceChildren(table);
  const [width, height] = [picked.offsetWidth, picked.offsetHeight];
  picked.style.left = `${Math.min(event.clientX + 16, window.innerWidth - width - 8)}px`;
  picked.style.top = `${Math.min(event.clientY + 16, window.innerHeight - height - 8)}px`;
}

// --- Panel ------------------------------------------------------------------------------------

document.title = `Curve skeleton of ${data.name}`;
byId('name').textContent = data.name;
for (const [name, value] of Object.entries(data.facts)) {
  const [term, number] = [document.createElement('dt'), document.createElement('dd')];
  term.textContent = name;
  number.textContent = Number.isInteger(value) ? value.toLocaleString('en') : short(value);
  byId('facts').append(term, number);
}
if (data.cloud.count === 0)
  byId('show_cloud').closest('label').hidden = byId('cloud_colour').closest('label').hidden = true;
else if (data.cloud.count < data.facts.points)
  byId('shown_points').textContent = `(${data.cloud.count.toLocaleString('en')} shown)`;
byId('scale_bar').style.background =
  `linear-gradient(to right, ${RAMP.map((colour) => `#${colour.getHexString()}`).join()})`;

for (const [id, objects] of [['show_cloud', [cloud]], ['show_skeleton', [lines]],
  ['show_junctions', [junctions]], ['show_tips', [tips]]])
  byId(id).onchange = (event) => {
    for (const object of objects)
      object.visible = event.target.checked;
    draw();
  };
byId('skeleton_colour').onchange = () => { colourSkeleton(); draw(); };
byId('cloud_colour').onchange = () => { colourCloud(); draw(); };

colourSkeleton();
colourCloud();
if (renderer) {
  byId('view').append(renderer.domElement);
  controls.addEventListener('change', move);
  renderer.domElement.addEventListener('pointermove', showPicked);
  byId('reset').onclick = resetView;
  window.addEventListener('resize', fit);
  fit();
  resetView();
}
