'use strict';
// Table 1 beside the paper's, and all rows; tablesorter sorts and filters.

function sortable(table, options = {}) {
  $(table).tablesorter({ emptyTo: 'bottom', stringTo: 'max', sortReset: true, sortRestart: true, ...options });
}

/// The stages of several rows in the order in which they come.
function stageNames(rows) {
  return unique(rows.flatMap((row) => row.stages.map(([name]) => name)));
}

function numberCell(text, className = '') {
  return element('td', { className: `number ${className}` }, text);
}

/// Ours; the status sorts after all numbers.
function secondsCell(row) {
  if (!row)
    return numberCell('');
  if (row.status === 'ok')
    return numberCell(seconds(row.seconds));
  return element('td', { className: 'number warning', title: row.message }, statusLabel(row));
}

/// The paper's line for a method of ours, if it has one.
function paperMethod(variant) {
  return paper.methods.find((method) => method.ours.includes(variant));
}

/// The paper's models, each with our shapes of its kind, of generated ones whatever the seed; then
/// our other shapes.
const KINDS = (() => {
  const known = paper.models.map((model, place) => ({ ...model, place,
    inputs: inputs.filter((input) => model.here.includes(input.replace(/:.*/, ''))) }));
  const others = inputs.filter((input) => known.every((kind) => !kind.inputs.includes(input)));
  return others.length === 0 ? known : [...known, { kind: 'other shapes', inputs: others }];
})();

/// The cells of a line, kind by kind.
/// \param theirs a function of the place of the paper's model; \param ours of our shape
function byKind(theirs, ours) {
  return KINDS.flatMap(({ place, inputs: shapes }) =>
    [...(place === undefined ? [] : [theirs(place)]), ...shapes.map(ours)]);
}

/// A line of the paper's seconds or of none, and of our cells.
function secondLine(name, className, paperSeconds, cellOf) {
  return element('tr', { className }, element('th', { scope: 'row' }, name),
    ...byKind((place) => numberCell(paperSeconds ? paperSeconds[place].toFixed(2) : '', 'paper'),
      cellOf));
}

/// A method's line, then its stages: the paper's where it gives any, and ours.
function secondLines(variant) {
  const theirs = paperMethod(variant);
  const rowOf = (input) => meanRowAt(variant, input, chosenNoise.value);
  const stage = (...line) => secondLine(line[0], 'tablesorter-childRow stage', ...line.slice(1));
  const names = stageNames(inputs.map(rowOf).filter((row) => row));
  return [
    secondLine(styleOf(variant).label, '', theirs && theirs.seconds,
      (input) => secondsCell(rowOf(input))),
    ...(theirs && theirs.stages || []).map(({ name, seconds: values }) =>
      stage(`${name} (paper)`, values, () => numberCell(''))),
    ...(names.length > 1 ? names : []).map((name) =>
      stage(name, null, (input) => numberCell(seconds(stageSeconds(rowOf(input), name))))),
  ];
}

function makeSecondTable() {
  const kindHead = ({ kind, place, inputs: shapes }) => element('th',
    { colSpan: shapes.length + (place === undefined ? 0 : 1), className: 'sorter-false kind' },
    kind);
  const columnHead = (name, below, className = '') => element('th',
    { className: `sorter-digit ${className}` }, name, element('br'), element('small', {}, below));
  const head = element('thead', {},
    element('tr', {}, element('th', { className: 'sorter-false' }), ...KINDS.map(kindHead)),
    element('tr', {}, element('th', {}, 'method'),
      ...byKind((place) => columnHead(paper.models[place].name, 'paper', 'paper'),
        (input) => columnHead(input, pointCount(input)))));
  const table = element('table', { id: 'second_table', className: 'sortable' }, head,
    element('tbody', {}, ...variants.flatMap(secondLines)));
  document.getElementById('second_table').replaceWith(table);
  sortable(table);
}

function pointCount(input) {
  const row = results.rows.find((candidate) => candidate.input === input
    && candidate.noise === chosenNoise.value && candidate.cloud !== null);
  return row ? `${results.clouds[row.cloud].size} points` : '';
}

const ROW_COLUMNS = [
  { label: 'shape', choice: true, text: (row) => row.input },
  { label: 'noise', choice: true, text: (row) => String(row.noise),
    title: 'standard deviation, in diagonals of the bounding box' },
  { label: 'seed', choice: true, text: (row) => String(row.seed), title: 'of points and noise' },
  { label: 'method', choice: true, text: (row) => styleOf(variantOf(row)).label },
  { label: 'from', choice: true, text: (row) => row.input_kind, title: 'what the method was given' },
  { label: 'status', choice: true, text: statusLabel, hint: (row) => row.message,
    className: (row) => row.status === 'ok' ? '' : 'warning' },
  { label: 'seconds', number: true, text: (row) => seconds(row.seconds),
    title: 'wall-clock, all stages; pointing at it shows them',
    hint: (row) => row.stages.map(([name, value]) => `${name}: ${seconds(value)} s`).join('\n') },
  { label: 'MiB', number: true, text: (row) => fixed(row.peak_memory_mib), title: 'peak memory' },
  ...Object.entries(METRICS).map(([name, { label, title, digits }]) => ({ label, title,
    number: true, text: (row) => row.metrics ? fixed(row.metrics[name], digits) : '' })),
];

function makeRowTable() {
  const head = element('tr', {}, ...ROW_COLUMNS.map(({ label, title = '', choice, number }) => {
    const cell = element('th', { title, className: choice ? 'filter-select' : '' }, label);
    cell.classList.toggle('number', Boolean(number));
    cell.classList.toggle('sorter-digit', Boolean(number));
    return cell;
  }));
  const lines = results.rows.map((row) => element('tr', {},
    ...ROW_COLUMNS.map(({ text, number, hint, className }) => element('td',
      { title: hint ? hint(row) : '',
        className: (number ? 'number ' : '') + (className ? className(row) : '') },
      text(row)))));
  const table = document.getElementById('row_table');
  table.append(element('thead', {}, head), element('tbody', {}, ...lines));
  sortable(table, { widgets: ['filter'],
    widgetOptions: { filter_matchType: { input: 'match', select: 'exact' } } });
}
