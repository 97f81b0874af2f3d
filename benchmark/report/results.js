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

const rowByKey = new Map(
  results.rows.map((row) => [keyOf(variantOf(row), row.input, row.noise), row]));

function rowAt(variant, input, noise) {
  return rowByKey.get(keyOf(variant, input, noise));
}

const inputs = unique(results.rows.map((row) => row.input));
const noiseLevels = ascending(results.rows.map((row) => row.noise));

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
