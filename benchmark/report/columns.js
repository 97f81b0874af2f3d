'use strict';
// How methods and measurements are called and drawn.

const METHODS = {
  l1_medial: { label: 'This package', color: '#0b4f9e', point: 'circle' },
  l1_medial_published: { label: 'As published', color: '#3d97d3', point: 'circle' },
  l1_medial_published_tuned: { label: 'As published, tuned', color: '#8cc4e8', point: 'circle' },
  l1_wlop: { label: 'L1-WLOP', color: '#e07b00', point: 'rect' },
  lapcon10: { label: 'LapCon10', color: '#8c510a', point: 'rectRot' },
  rosa: { label: 'ROSA', color: '#7b3fa0', point: 'triangle' },
  tangent_ball: { label: 'Tangent Ball', color: '#4a4a4a', point: 'cross' },
  mcf: { label: 'MCF', color: '#1a7a35', point: 'rect' },
  wrap_mcf: { label: 'Alpha wrap, MCF', color: '#55a630', point: 'rectRot' },
  poisson_mcf: { label: 'Poisson, MCF', color: '#7d9a1e', point: 'triangle' },
  lapcon08_vc: { label: 'LapCon08VC', color: '#a3195b', point: 'star' },
  lapcon08_ec: { label: 'LapCon08EC', color: '#d45fb0', point: 'crossRot' },
  wave_fronts: { label: 'Wave Fronts', color: '#00868b', point: 'star' },
  teasar: { label: 'TEASAR', color: '#a08a00', point: 'crossRot' },
};

const JUNCTION_COLOR = '#d7191c';

const METRICS = {
  components: { label: 'comp', title: 'connected components' },
  true_components: { label: 'true', title: 'connected components of the shape' },
  cycles: { label: 'cycles', title: 'independent cycles' },
  true_cycles: { label: 'true', title: 'independent cycles of the shape: its genus' },
  ends: { label: 'ends', title: 'vertices with one edge' },
  true_ends: { label: 'true', title: 'ends of the shape' },
  junctions: { label: 'junctions', title: 'vertices with three edges or more' },
  off_centre: { label: 'off-centre', digits: 3,
    title: 'median distance to the centroid of the cross-section, in its radii' },
  inside: { label: 'inside', digits: 3, title: 'share of the length that is inside the shape' },
  spurs: { label: 'spurs', title: 'ends that do not leave the ball of their junction' },
  unexplained: { label: 'unexplained', digits: 3,
    title: 'share of the points further than two radii from the skeleton' },
  moved_mean: { label: 'moved', digits: 4,
    title: 'mean distance to the skeleton of the clean cloud, in diagonals' },
  moved_maximum: { label: 'moved, max', digits: 4,
    title: 'largest distance to the skeleton of the clean cloud, in diagonals' },
};

const STATUS = { failed: 'failed', time_limit: 'time limit', invalid: 'invalid result',
  unreadable: 'unreadable' };

/// '' for null, which is what cannot be measured.
function fixed(value, digits = 0) {
  return value === null || value === undefined ? '' : value.toFixed(digits);
}

/// To the hundredth, or with two significant digits: what is fast is not 0, what is slow not exact.
function seconds(value) {
  if (value === null || value === undefined)
    return '';
  if (value < 0.1)
    return value.toFixed(Math.min(4, value > 0 ? 1 - Math.floor(Math.log10(value)) : 2));
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}
