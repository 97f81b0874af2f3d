'use strict';
// The rows of the comparison and how to find one.

const results = JSON.parse(document.getElementById('results').textContent);
const paper = JSON.parse(document.getElementById('paper').textContent);

function unique(values) {
  return [...new Set(values)];
}

function ascending(values) {
  return unique(values).sort((a, b) => a - b);
}

/// A method on decimated meshes is drawn and listed as a method of its own, after the paper's Fig. 6.
function variantOf(row) {
  return row.method + (row.input_kind === 'decimated mesh' ? '*' : '');
}

function styleOf(variant) {
  const name = variant.replace('*', '');
  const style = METHODS[name] || { label: name, color: '#777777', point: 'circle' };
  return { ...style, decimated: name !== variant,
    label: style.label + (name === variant ? '' : '\u2217') };
}

function keyOf(variant, input, noise) {
  return JSON.stringify([variant, input, noise]);
}

/// The rows of each key, one for every seed.
const rowsByKey = new Map();
for (const row of results.rows) {
  const key = keyOf(variantOf(row), row.input, row.noise);
  rowsByKey.set(key, [...(rowsByKey.get(key) || []), row]);
}

/// That of the first seed.
function rowAt(variant, input, noise) {
  return (rowsByKey.get(keyOf(variant, input, noise)) || [])[0];
}

/// The mean of the numbers that are there; null if none is.
function mean(values) {
  const numbers = values.filter((value) => value !== null && value !== undefined);
  return numbers.length > 0 ? numbers.reduce((sum, x) => sum + x, 0) / numbers.length : null;
}

/// That of the first seed with a skeleton, its seconds and metrics averaged over all of these.
function meanRowAt(variant, input, noise) {
  const good = (rowsByKey.get(keyOf(variant, input, noise)) || [])
    .filter((row) => row.status === 'ok');
  if (good.length === 0)
    return rowAt(variant, input, noise);
  const stages = unique(good.flatMap((row) => row.stages.map(([name]) => name)));
  return { ...good[0], seconds: mean(good.map((row) => row.seconds)),
    stages: stages.map((name) => [name, mean(good.map((row) => stageSeconds(row, name)))]),
    metrics: Object.fromEntries(Object.keys(good[0].metrics)
      .map((name) => [name, mean(good.map((row) => row.metrics[name]))])) };
}

/// The seconds of the stages of a row with a name; null if there is none.
function stageSeconds(row, name) {
  const found = row && row.stages.filter(([stage]) => stage === name);
  return found && found.length > 0 ? found.reduce((sum, [, value]) => sum + value, 0) : null;
}

const inputs = unique(results.rows.map((row) => row.input));
const noiseLevels = ascending(results.rows.map((row) => row.noise));
const seeds = ascending(results.rows.map((row) => row.seed));

/// 'seed 3' or 'mean of 5 seeds'.
const seedsLabel = seeds.length === 1 ? `seed ${seeds[0]}` : `mean of ${seeds.length} seeds`;

/// In the order of METHODS, others after; decimated beside not decimated.
const variants = (() => {
  const known = Object.keys(METHODS).flatMap((name) => [name, name + '*']);
  const present = unique(results.rows.map(variantOf));
  return [...known.filter((name) => present.includes(name)),
    ...present.filter((name) => !known.includes(name))];
})();

function noiseLabel(noise) {
  return noise === 0 ? 'none (clean)' : String(noise);
}

function statusLabel(row) {
  return STATUS[row.status] || row.status;
}

/// One for the noise levels of the whole page; what shows one level registers a function.
const chosenNoise = {
  value: noiseLevels[0],
  listeners: [],
  set(value) {
    this.value = value;
    for (const listener of this.listeners)
      listener();
  },
};

/// A new element with properties and children.
function element(name, properties = {}, ...children) {
  const result = Object.assign(document.createElement(name), properties);
  result.append(...children);
  return result;
}
