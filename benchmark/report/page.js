'use strict';
// Puts the parts together.

function makeSummary() {
  const count = (status) => results.rows.filter((row) => row.status === status).length;
  const bad = Object.entries(STATUS).filter(([status]) => count(status) > 0)
    .map(([status, label]) => `${count(status)} ${label}`);
  const number = (n, name) => `${n} ${name}${n === 1 ? '' : 's'}`;
  const methods = unique(results.rows.map((row) => row.method)).length;
  const decimated = variants.length - methods;
  document.getElementById('summary').textContent = number(methods, 'method')
    + (decimated > 0 ? `, ${decimated} of them also on decimated meshes,` : '')
    + ` on ${number(inputs.length, 'shape')} at ${number(noiseLevels.length, 'level')} of noise: `
    + `${number(results.rows.length, 'row')}, ${[`${count('ok')} ok`, ...bad].join(', ')}.`;
  document.getElementById('paper_source').textContent = paper.source;
}

function makeNoiseChoice() {
  const select = document.getElementById('noise');
  select.append(...noiseLevels.map((noise) => element('option', { value: noise },
    noiseLabel(noise))));
  select.onchange = () => chosenNoise.set(Number(select.value));
}

function showSeeds() {
  for (const place of document.querySelectorAll('span.seeds'))
    place.textContent = seedsLabel;
  document.getElementById('first_seed').textContent = `seed ${seeds[0]}`;
}

function showNoise() {
  for (const place of document.querySelectorAll('span.noise'))
    place.textContent = noiseLabel(chosenNoise.value);
}

makeSummary();
makeNoiseChoice();
showNoise();
showSeeds();
makeGallery();
makePlots();
makeSecondTable();
makeRowTable();
chosenNoise.listeners.push(showNoise, makeGallery, updateSecondPlot, makeSecondTable);
window.addEventListener('beforeprint', () => renderer && drawAllForPrint());
