'use strict';
// Methods x shapes at the chosen noise. Pictures are drawn when they come into sight.

const PICTURE_SIZE = 320; // pixels, twice what is seen, for fine screens and print

const waiting = new Map(); // canvas to row: in sight, not yet drawn
const inSight = renderer && new IntersectionObserver((entries) => {
  for (const entry of entries)
    if (entry.isIntersecting) {
      waiting.set(entry.target, entry.target.row);
      inSight.unobserve(entry.target);
    }
  drawWaiting();
}, { rootMargin: '200px' });

/// One picture per frame, so that the page can be scrolled meanwhile; none while the view is open,
/// which has the renderer.
function drawWaiting() {
  const [first] = waiting;
  if (!first || document.getElementById('viewer').open)
    return;
  const [canvas, row] = first;
  waiting.delete(canvas);
  drawPicture(row, canvas);
  canvas.classList.add('drawn');
  requestAnimationFrame(drawWaiting);
}

function draw(canvas) {
  canvas.classList.remove('drawn');
  inSight.observe(canvas);
}

/// Draws all pictures of a shape again.
function redraw(input) {
  for (const canvas of document.querySelectorAll('#pictures canvas'))
    if (canvas.row.input === input)
      draw(canvas);
}

/// 'components 1/1 · cycles 1/1 · ends 3/3' where the truth is known, the wrong underlined; else
/// 'junctions 5'.
function topology(row) {
  const { metrics } = row;
  const parts = ['components', 'cycles', 'ends'].filter((name) => metrics['true_' + name] !== null)
    .map((name) => element('span',
      { className: metrics[name] === metrics['true_' + name] ? '' : 'wrong' },
      `${name} ${metrics[name]}/${metrics['true_' + name]}`));
  if (parts.length === 0)
    return [`junctions ${metrics.junctions}`];
  return parts.flatMap((part, i) => i === 0 ? [part] : [' · ', part]);
}

function captionOf(row) {
  if (row.status !== 'ok')
    return element('span', { className: 'warning', title: row.message }, statusLabel(row));
  return element('span', {}, `${seconds(row.seconds)} s`, element('br'), ...topology(row));
}

function makeCell(row) {
  const button = element('button', { className: 'picture' });
  button.setAttribute('aria-label',
    `${styleOf(variantOf(row)).label} on ${row.input}: ${statusLabel(row)}`);
  if (renderer && row.cloud !== null) {
    const canvas = element('canvas', { width: PICTURE_SIZE, height: PICTURE_SIZE, row });
    button.append(canvas);
    button.onclick = () => openViewer(row);
    draw(canvas);
  }
  const cell = element('td', { className: `cell ${row.status}` }, button,
    element('div', { className: 'caption' }, captionOf(row)));
  if (row.input_kind === 'wrapped mesh')
    cell.append(element('div', { className: 'caption' }, 'mesh: alpha wrap'));
  return cell;
}

function makeGallery() {
  const noise = chosenNoise.value;
  const head = element('tr', {}, element('th'),
    ...inputs.map((input) => element('th', { scope: 'col' }, input)));
  const lines = variants.map((variant) => {
    const { label, color } = styleOf(variant);
    const method = element('th', { scope: 'row' }, label);
    method.style.borderColor = color;
    return element('tr', {}, method, ...inputs.map((input) => {
      const row = rowAt(variant, input, noise);
      return row ? makeCell(row) : element('td');
    }));
  });
  waiting.clear();
  document.getElementById('no_webgl').hidden = renderer !== null;
  document.getElementById('pictures').replaceChildren(
    element('thead', {}, head), element('tbody', {}, ...lines));
}

function drawAllForPrint() {
  for (const canvas of document.querySelectorAll('#pictures canvas:not(.drawn)')) {
    drawPicture(canvas.row, canvas);
    canvas.classList.add('drawn');
  }
}
