'use strict';
// Table 1 beside the paper's, and all rows; tablesorter sorts and filters.

function sortable(table, options) {
  $(table).tablesorter({ emptyTo: 'bottom', sortReset: true, sortRestart: true, ...options });
}

/// The stages of several rows in the order in which they come.
function stageNames(rows) {
  return unique(rows.flatMap((row) => row.stages.map(([name]) => name)));
}

function numberCell(text, className = '') {
  return element('td', { className: `number ${className}` }, text);
}

function secondsCell(row) {
  if (!row)
    return numberCell('');
  if (row.status === 'ok')
    return numberCell(seconds(row.seconds));
  return element('td', { className: 'number warning', title: row.message }, statusLabel(row));
}

function stageSeconds(row, name) {
  const found = row && row.stages.filter(([stage]) => stage === name);
  return found && found.length > 0 ? found.reduce((sum, [, value]) => sum + value, 0) : null;
}

/// The paper's line for a method of ours, if it has one.
function paperMethod(variant) {
  return paper.methods.find((method) => method.ours.includes(variant));
}

/// A method's line, then its stages: the paper's where it gives any, and ours.
function secondLines(variant) {
  const theirs = paperMethod(variant);
  const rows = inputs.map((input) => rowAt(variant, input, chosenNoise.value));
  const { label } = styleOf(variant);
  const line = element('tr', {}, element('th', { scope: 'row' }, label),
    ...paper.models.map((_, i) => numberCell(theirs ? theirs.seconds[i].toFixed(2) : '', 'paper')),
    ...rows.map(secondsCell));
  const child = (name, paperSeconds, ourSeconds) => element('tr',
    { className: 'tablesorter-childRow stage' }, element('th', { scope: 'row' }, name),
    ...paper.models.map((_, i) => numberCell(paperSeconds ? paperSeconds[i].toFixed(2) : '',
      'paper')),
    ...ourSeconds.map((value) => numberCell(seconds(value))));
  const none = inputs.map(() => null);
  const paperStages = (theirs && theirs.stages || [])
    .map((stage) => child(`${stage.name} (paper)`, stage.seconds, none));
  const ours = stageNames(rows.filter((row) => row));
  const ourStages = (ours.length > 1 ? ours : [])
    .map((name) => child(name, null, rows.map((row) => stageSeconds(row, name))));
  return [line, ...paperStages, ...ourStages];
}

function makeSecondTable() {
  const heading = (text, span, className = '') => {
    const cell = element('th', { colSpan: span, className: `sorter-false ${className}` }, text);
    return cell;
  };
  const columnHead = (text, kind, className = '') =>
    element('th', { className, title: kind }, text, element('br'),
      element('small', {}, kind));
  const head = element('thead', {},
    element('tr', {}, heading('', 1),
      heading('Paper, Table 1: another machine', paper.models.length, 'paper'),
      heading('Here', inputs.length)),
    element('tr', {}, element('th', {}, 'method'),
      ...paper.models.map((model) => columnHead(model.name, model.kind, 'paper')),
      ...inputs.map((input) => columnHead(input, pointCount(input)))));
  const table = element('table', { id: 'second_table', className: 'sortable' }, head,
    element('tbody', {}, ...variants.flatMap(secondLines)));
  document.getElementById('second_table').replaceWith(table);
  sortable(table, { sortInitialOrder: 'asc' });
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
