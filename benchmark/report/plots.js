'use strict';
// Junctions, stability and seconds; Chart.js draws. One legend for all.

Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
Chart.defaults.color = '#333333';
Chart.defaults.animation = false;
Chart.defaults.plugins.legend.display = false;

const charts = [];
const hidden = new Set();
let foremost = null; // the variant that is pointed at

/// Counts are drawn as log(1 + count): none is on the axis, and a thousand as well.
const countAxis = {
  toAxis: (count) => Math.log10(1 + count),
  fromAxis: (value) => Math.round(10 ** value - 1),
  ticks: [0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000, 100000],
};

function countScale() {
  return {
    min: 0,
    grace: '5%',
    ticks: { callback: (value) => countAxis.fromAxis(value) },
    afterBuildTicks: (axis) => {
      axis.ticks = countAxis.ticks.map((count) => ({ value: countAxis.toAxis(count) }))
        .filter(({ value }) => value <= axis.max);
    },
  };
}

/// With lines at 1, 2 and 5 of every power of ten.
function logarithmicScale(title) {
  return {
    type: 'logarithmic',
    title: { display: title !== '', text: title },
    afterBuildTicks: (axis) => {
      axis.ticks = axis.ticks.filter(({ value }) => '125'.includes(value.toExponential(0)[0]));
    },
    ticks: { autoSkip: false, maxRotation: 0,
      callback: (value) => String(Number(value.toPrecision(1))) },
  };
}

function curveStyle(variant) {
  const { label, color, point, decimated } = styleOf(variant);
  return { label, variant, borderColor: color, backgroundColor: color, pointStyle: point,
    borderDash: decimated ? [5, 4] : [], borderWidth: variant === 'l1_medial' ? 3 : 1.5,
    pointRadius: 3.5, pointBorderWidth: 1.5 };
}

function addChart(parent, label, config) {
  const canvas = element('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', label);
  parent.append(element('div', { className: 'plot' }, canvas));
  charts.push(new Chart(canvas, config));
}

/// One small plot per shape that has anything to show, a line per method: a value of its rows
/// against their noise.
/// \param value a function of a row; null if there is none
/// \param tip the text for the value at the pointer
function addNoisePlots(id, levels, value, scale, tip) {
  const parent = document.getElementById(id);
  const valueAt = (variant, input, noise) => {
    const row = meanRowAt(variant, input, noise);
    return row && row.metrics ? value(row) : null;
  };
  for (const input of inputs) {
    const datasets = variants.map((variant) => ({ ...curveStyle(variant), clip: 8,
      data: levels.map((noise) => ({ x: noise, y: valueAt(variant, input, noise) })) }));
    if (datasets.some(({ data }) => data.some(({ y }) => y !== null)))
      addChart(parent, `${id} of ${input}`,
        noisePlot(input, levels, datasets, scale, tip));
  }
  if (!parent.hasChildNodes())
    parent.append('Nothing of it was measured.');
}

function noisePlot(input, levels, datasets, scale, tip) {
  const noiseAxis = { type: 'linear', min: 0, max: levels[levels.length - 1],
    afterBuildTicks: (axis) => { axis.ticks = levels.map((noise) => ({ value: noise })); },
    ticks: { callback: (noise) => String(noise), maxRotation: 60, autoSkip: false } };
  return { type: 'line', data: { datasets }, options: {
    aspectRatio: 1.1,
    plugins: { title: { display: true, text: input },
      tooltip: { callbacks: { title: ([item]) => `noise ${item.parsed.x}`,
        label: (item) => `${item.dataset.label}: ${tip(item.parsed.y)}` } } },
    scales: { x: noiseAxis, y: scale } } };
}

/// One line per method, one dot per shape.
function makeSecondPlot() {
  const datasets = variants.map((variant, line) => ({ ...curveStyle(variant), showLine: false,
    data: inputs.map((input) => ({ row: meanRowAt(variant, input, chosenNoise.value), y: line }))
      .filter(({ row }) => row && row.status === 'ok')
      .map(({ row, y }) => ({ x: row.seconds, y, input: row.input })) }));
  const parent = document.getElementById('second_plot');
  parent.style.setProperty('--lines', variants.length);
  addChart(parent, 'seconds of every method', {
    type: 'scatter', data: { datasets }, options: {
      maintainAspectRatio: false,
      plugins: { tooltip: { callbacks: {
        label: (item) => `${item.dataset.label}, ${item.raw.input}: ${seconds(item.raw.x)} s` } } },
      scales: { x: logarithmicScale('seconds'),
        y: { min: -0.5, max: variants.length - 0.5, reverse: true,
          afterBuildTicks: (axis) => { axis.ticks = variants.map((_, value) => ({ value })); },
          ticks: { autoSkip: false, callback: (line) => styleOf(variants[line]).label } } },
    } });
}

/// Hides what is hidden and greys out all but what is pointed at.
function restyle() {
  for (const chart of charts) {
    chart.data.datasets.forEach((dataset, i) => {
      const faded = foremost !== null && dataset.variant !== foremost;
      const color = faded ? '#e3e3e3' : styleOf(dataset.variant).color;
      Object.assign(dataset, { borderColor: color, backgroundColor: color, order: faded ? 1 : 0 });
      chart.setDatasetVisibility(i, !hidden.has(dataset.variant));
    });
    chart.update();
  }
}

function toggle(variant, button) {
  if (!hidden.delete(variant))
    hidden.add(variant);
  button.setAttribute('aria-pressed', String(!hidden.has(variant)));
  restyle();
}

function makeLegend() {
  const point = (variant) => { foremost = variant; restyle(); };
  document.getElementById('legend').replaceChildren(...variants.map((variant) => {
    const { label, color, decimated } = styleOf(variant);
    const line = element('span', { className: 'line' });
    line.style.borderTop = `3px ${decimated ? 'dashed' : 'solid'} ${color}`;
    const button = element('button', {}, line, label);
    button.setAttribute('aria-pressed', 'true');
    button.onclick = () => toggle(variant, button);
    button.onpointerenter = () => point(hidden.has(variant) ? null : variant);
    button.onpointerleave = () => point(null);
    return button;
  }));
}

function makePlots() {
  makeLegend();
  addNoisePlots('junction_plots', noiseLevels,
    (row) => countAxis.toAxis(row.metrics.junctions), countScale(), countAxis.fromAxis);
  addNoisePlots('stability_plots', noiseLevels.filter((noise) => noise > 0),
    (row) => row.metrics.moved_mean, logarithmicScale(''), (value) => value.toPrecision(2));
  makeSecondPlot();
}

function updateSecondPlot() {
  charts.pop().destroy();
  document.getElementById('second_plot').replaceChildren();
  makeSecondPlot();
  restyle();
}
