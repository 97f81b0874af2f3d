'use strict';
// Puts the parts together.

function makeSummary() {
  const count = (status) => results.rows.filter((row) => row.status === status).length;
  const bad = Object.entries(STATUS).filter(([status]) => count(status) > 0)
    .map(([status, label]) => `${count(status)} ${label}`);
  document.getElementById('summary').textContent =
    `${variants.length} methods on ${inputs.length} shapes at ${noiseLevels.length} levels of `
    + `noise: ${results.rows.length} rows, ${[`${count('ok')} ok`, ...bad].join(', ')}.`;
  document.getElementById('paper_source').textContent = paper.source;
}

function makeNoiseChoice() {
  const select = document.getElementById('noise');
  select.append(...noiseLevels.map((noise) => element('option', { value: noise },
    noiseLabel(noise))));
  select.onchange = () => chosenNoise.set(Number(select.value));
}

function showNoise() {
  for (const place of document.querySelectorAll('span.noise'))
    place.textContent = noiseLabel(chosenNoise.value);
}

makeSummary();
makeNoiseChoice();
showNoise();
makeGallery();
makePlots();
makeSecondTable();
makeRowTable();
chosenNoise.listeners.push(showNoise, makeGallery, updateSecondPlot, makeSecondTable);
window.addEventListener('beforeprint', () => renderer && drawAllForPrint());
