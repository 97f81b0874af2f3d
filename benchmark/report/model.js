'use strict';
// Draws the cloud and the skeleton of a row. Browsers limit WebGL contexts: one renderer draws all.

const UNIT = 1e-4; // of the coordinates, in diagonals of the cloud's bounding box

const renderer = (() => {
  try {
    const made = new THREE.WebGLRenderer({ antialias: true });
    made.setClearColor('#ffffff');
    return made;
  } catch (error) {
    return null;
  }
})();

function scaled(points) {
  return Float32Array.from(points, (x) => UNIT * x);
}

/// The vertices of a skeleton with three edges or more.
function junctionsOf(skeleton) {
  const degree = new Array(skeleton.points.length / 3).fill(0);
  for (const vertex of skeleton.edges)
    ++degree[vertex];
  return degree.flatMap((edges, vertex) => edges >= 3 ? [vertex] : []);
}

/// The coordinates of the vertices, one after the other.
function coordinates(points, vertices) {
  const result = new Float32Array(3 * vertices.length);
  vertices.forEach((vertex, i) => result.set(points.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
  return result;
}

const discTexture = (() => {
  const canvas = element('canvas', { width: 64, height: 64 });
  const context = canvas.getContext('2d');
  context.arc(32, 32, 30, 0, 2 * Math.PI);
  context.fillStyle = '#ffffff';
  context.fill();
  return new THREE.CanvasTexture(canvas);
})();

function pointsObject(coordinatesArray, color, size, options) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(coordinatesArray, 3));
  const material = new THREE.PointsMaterial(
    { color, size, sizeAttenuation: false, map: discTexture, transparent: true, ...options });
  return new THREE.Points(geometry, material);
}

function linesObject(coordinatesArray, color, linewidth, width, height) {
  const geometry = new THREE.LineSegmentsGeometry().setPositions(coordinatesArray);
  const material = new THREE.LineMaterial({ color, linewidth });
  material.resolution.set(width, height);
  return new THREE.LineSegments2(geometry, material);
}

/// The cloud behind, the skeleton before it, its junctions before both.
/// \param size of the picture: {width, height} and the pixels that a line is wide
function makeScene(row, size, withCloud = true) {
  const scene = new THREE.Scene();
  const add = (object, order) => {
    object.renderOrder = order;
    object.frustumCulled = false;
    scene.add(object);
  };
  if (withCloud)
    add(pointsObject(scaled(results.clouds[row.cloud].points), '#a9b0b8', 0.7 * size.line,
      { depthWrite: false, opacity: 0.7 }), 0);
  if (!row.skeleton || row.skeleton.edges.length === 0)
    return scene;
  const points = scaled(row.skeleton.points);
  const { color } = styleOf(variantOf(row));
  add(linesObject(coordinates(points, row.skeleton.edges), color, size.line,
    size.width, size.height), 1);
  add(pointsObject(coordinates(points, junctionsOf(row.skeleton)), JUNCTION_COLOR, 3 * size.line,
    { depthTest: false }), 2);
  return scene;
}

function dispose(scene) {
  for (const object of scene.children) {
    object.geometry.dispose();
    object.material.dispose();
  }
}

const FIELD_OF_VIEW = 25; // degrees; narrow, so that near and far are about as large

/// From the side on which the cloud is broadest, a little from the left and from above.
function firstView(cloud) {
  const points = scaled(cloud.points);
  const box = new THREE.Box3().setFromArray(points);
  const size = box.getSize(new THREE.Vector3()).toArray();
  const depth = size.indexOf(Math.min(...size));
  const up = new THREE.Vector3(0, depth === 1 ? 0 : 1, depth === 1 ? 1 : 0);
  const towards = new THREE.Vector3().setComponent(depth, 1);
  const aside = new THREE.Vector3().crossVectors(up, towards);
  towards.addScaledVector(aside, -0.35).addScaledVector(up, 0.25).normalize();
  const target = box.getCenter(new THREE.Vector3());
  return { target, up, position: fitted(points, target, towards, up) };
}

/// Where in this direction a camera has all points in a square picture.
function fitted(points, target, towards, up) {
  const right = new THREE.Vector3().crossVectors(up, towards).normalize();
  const above = new THREE.Vector3().crossVectors(towards, right);
  const slope = Math.tan(THREE.Math.degToRad(FIELD_OF_VIEW / 2));
  const point = new THREE.Vector3();
  let distance = 0;
  for (let i = 0; i < points.length; i += 3) {
    point.fromArray(points, i).sub(target);
    const extent = Math.max(Math.abs(point.dot(right)), Math.abs(point.dot(above)));
    distance = Math.max(distance, extent / slope + point.dot(towards));
  }
  const margin = 1.06;
  return target.clone().addScaledVector(towards, margin * Math.max(distance, 0.1));
}

const views = new Map(); // of an input: where it is looked at from

function viewOf(row) {
  if (!views.has(row.input))
    views.set(row.input, firstView(results.clouds[row.cloud]));
  return views.get(row.input);
}

function makeCamera(view, aspect) {
  const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, aspect, 0.01, 100);
  camera.up.copy(view.up);
  camera.position.copy(view.position);
  camera.lookAt(view.target);
  return camera;
}

/// Draws a row into a 2D canvas of the canvas' own size.
function drawPicture(row, canvas) {
  const { width, height } = canvas;
  const scene = makeScene(row, { width, height, line: Math.max(2, width / 70) });
  renderer.setPixelRatio(1);
  renderer.setSize(width, height, false);
  renderer.render(scene, makeCamera(viewOf(row), width / height));
  canvas.getContext('2d').drawImage(renderer.domElement, 0, 0);
  dispose(scene);
}
