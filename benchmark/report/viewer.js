'use strict';
// One row, large and to be turned.

const viewer = {
  dialog: document.getElementById('viewer'),
  view: document.getElementById('view'),
  row: null,
  scene: null,
  camera: null,
  controls: null,
};

function openViewer(row) {
  viewer.dialog.showModal();
  viewer.view.append(renderer.domElement);
  viewer.camera = makeCamera(viewOf(row), 1);
  viewer.controls = new THREE.OrbitControls(viewer.camera, renderer.domElement);
  viewer.controls.enableKeys = false; // the arrow keys change the method
  viewer.controls.target.copy(viewOf(row).target);
  viewer.controls.addEventListener('change', renderViewer);
  showRow(row);
}

/// Puts another row of the same input into the open view.
function showRow(row) {
  viewer.row = row;
  fitViewer();
  const { label, color } = styleOf(variantOf(row));
  const method = document.getElementById('view_method');
  method.textContent = label;
  method.style.borderColor = color;
  document.getElementById('view_input').textContent =
    `${row.input}, noise ${noiseLabel(row.noise)}; from ${row.input_kind}`;
  document.getElementById('view_status').textContent =
    row.status === 'ok' ? '' : `${statusLabel(row)}: ${row.message}`;
  document.getElementById('view_numbers').replaceChildren(...numbersOf(row));
}

/// Lines of name and value: seconds by stage, then what was measured.
function numbersOf(row) {
  const line = (name, value, title = '') =>
    element('tr', { title }, element('th', {}, name), element('td', {}, value));
  const stages = row.stages.map(([name, value]) => line(`– ${name}`, `${seconds(value)} s`));
  const metrics = Object.entries(METRICS)
    .filter(([name]) => row.metrics && !name.startsWith('true_') && row.metrics[name] !== null)
    .map(([name, { label, title, digits }]) => {
      const truth = row.metrics['true_' + name];
      return line(label, fixed(row.metrics[name], digits)
        + (truth === null || truth === undefined ? '' : ` (true: ${truth})`), title);
    });
  return [line('seconds', `${seconds(row.seconds)} s`), ...stages,
    line('peak memory', `${fixed(row.peak_memory_mib)} MiB`), ...metrics];
}

/// Makes the scene anew for the size that the view has.
function fitViewer() {
  const { clientWidth: width, clientHeight: height } = viewer.view;
  renderer.setPixelRatio(window.devicePixelRatio);
  renderer.setSize(width, height);
  if (viewer.scene)
    dispose(viewer.scene);
  viewer.scene = makeScene(viewer.row, { width, height, line: 4 },
    document.getElementById('show_cloud').checked);
  viewer.camera.aspect = width / height;
  viewer.camera.updateProjectionMatrix();
  renderViewer();
}

function renderViewer() {
  renderer.render(viewer.scene, viewer.camera);
}

/// The next row, in the order of the gallery, that has a picture.
function step(by) {
  const rows = variants.map((variant) => rowAt(variant, viewer.row.input, viewer.row.noise))
    .filter((row) => row && row.cloud !== null);
  showRow(rows[(rows.indexOf(viewer.row) + by + rows.length) % rows.length]);
}

function closeViewer() {
  views.set(viewer.row.input, { up: viewer.camera.up, position: viewer.camera.position,
    target: viewer.controls.target });
  viewer.controls.dispose();
  dispose(viewer.scene);
  viewer.scene = null;
  redraw(viewer.row.input);
  drawWaiting();
}

viewer.dialog.addEventListener('close', closeViewer);
viewer.dialog.addEventListener('keydown', (event) => {
  if (event.key === 'ArrowLeft' || event.key === 'ArrowRight')
    step(event.key === 'ArrowLeft' ? -1 : 1);
});
document.getElementById('previous').onclick = () => step(-1);
document.getElementById('next').onclick = () => step(1);
document.getElementById('show_cloud').onchange = fitViewer;
window.addEventListener('resize', () => viewer.dialog.open && fitViewer());
