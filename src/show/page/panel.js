// State, what is picked, and the panel beside the scene.

const $ = (id) => document.getElementById(id);

/** An element with text, never markup: names of a scene may be anything. */
function node(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) result.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false) result.setAttribute(key, value);
  }
  result.append(...children);
  return result;
}

const state = {mode: run.missed ? 'difference' : 'covered_by', k: run.covers.length, picked: null};
let view = null;

const counts = {element: run.areas.length, region: run.regions.count, viewpoint: run.viewpoints.length};
const chosen = () => (state.k ? run.covers[state.k - 1].regions : []);

function colouring() {
  if (state.picked && state.picked.kind === 'region') return bySight(run.seen, state.picked.index, 'region');
  if (state.picked && state.picked.kind === 'viewpoint') return bySight(run.seenFrom, state.picked.index, 'viewpoint');
  return colourings[state.mode].make(state.k);
}

function drawLegend({title, entries, ramp}) {
  const legend = $('legend');
  legend.replaceChildren(node('span', {class: 'soft'}, title));
  for (const {colour, text} of entries) {
    legend.append(node('span', {}, node('i', {style: `background:${css(colour)}`}), text));
  }
  if (ramp) {
    const stops = palette.ramp.map(css).join(',');
    legend.append(node('span', {}, '1', node('i', {class: 'ramp', style: `background:linear-gradient(90deg,${stops})`}), String(ramp)));
  }
}

/** Shows the state: colours, marks, texts. */
function update() {
  const colours = colouring();
  if (view) {
    view.colour(colours.of);
    const strong = new Map(chosen().map((r) => [r, [r, palette.chosen, 0.85]]));
    const {picked} = state;
    if (picked && picked.kind === 'element') {
      for (const r of run.seen.rowsWith(picked.index)) if (!strong.has(r)) strong.set(r, [r, palette.lit, 0.3]);
      for (const r of chosen()) if (run.seen.test(r, picked.index)) strong.set(r, [r, palette.lit, 0.85]);
    }
    if (picked && picked.kind === 'region') strong.set(picked.index, [picked.index, palette.lit, 0.95]);
    view.colourRegions([...strong.values()]);
    view.viewpoints.forEach((dot, i) => {
      const on = picked && (picked.kind === 'viewpoint' ? picked.index === i :
          picked.kind === 'element' && run.seenFrom.test(i, picked.index));
      dot.material.color.set(on ? css(palette.lit) : '#f5f5f5');
    });
    drawMark();
  }
  drawLegend(colours);
  const cover = state.k ? run.covers[state.k - 1] : null;
  $('k').value = state.k;
  $('k-text').textContent = cover ? `${state.k} of ${run.covers.length}: ${percent(cover.covered)}` : 'none chosen';
  $('k').setAttribute('aria-valuetext', `${$('k-text').textContent} of the area`);
  $('mode').value = state.mode;
  drawSelection();
  for (const row of document.querySelectorAll('[data-k]')) row.classList.toggle('now', Number(row.dataset.k) === state.k);
  if ($('coverage')) $('coverage').replaceChildren(...(run.covers.length ? [coveragePlot(run.covers, state.k, setK)] : []));
}

function drawMark() {
  const colour = getComputedStyle(document.documentElement).getPropertyValue('--pick').trim();
  const {picked} = state;
  if (!picked || picked.kind === 'viewpoint') return view.mark([], run.pieces, colour);
  if (picked.kind === 'region') return view.mark([picked.index], run.regions, colour);
  const pieces = [];
  for (let p = run.elementPiece[picked.index]; p < run.pieces.count && run.pieceElement[p] === picked.index; ++p) pieces.push(p);
  // From the viewpoints that see it, lines to its middle.
  const lines = [], middle = centreOf(run.pieces, pieces[0]).toArray();
  run.viewpoints.forEach((viewpoint, i) => {
    if (run.seenFrom.test(i, picked.index)) lines.push(...viewpoint.position, ...middle);
  });
  return view.mark(pieces, run.pieces, colour, lines);
}

function setK(k) {
  state.k = Math.min(Math.max(k, run.covers.length ? 1 : 0), run.covers.length);
  update();
}
function setMode(mode) {
  state.mode = mode;
  if (state.picked && state.picked.kind !== 'element') state.picked = null;
  update();
}
function pick(picked, look = false) {
  state.picked = picked;
  if (picked) {
    $('go-kind').value = picked.kind;
    $('go-number').value = picked.index + 1;
    if (look && view && picked.kind === 'element') {
      const middle = centreOf(run.pieces, run.elementPiece[picked.index]);
      view.camera.position.add(middle.clone().sub(view.controls.target));
      view.controls.target.copy(middle);
      view.controls.update();
    }
  }
  update();
}
function step(by) {
  const kind = state.picked ? state.picked.kind : $('go-kind').value;
  if (!counts[kind]) return;
  const from = state.picked ? state.picked.index + by : 0;
  pick({kind, index: (from + counts[kind]) % counts[kind]});
}

function chips(kind, numbers, marked = new Set()) {
  const most = 400;
  const all = numbers.slice(0, most).map((i) => node('button', {type: 'button', class: marked.has(i) ? 'chosen' : undefined,
    title: marked.has(i) ? `${kind}, chosen` : kind, onclick: () => pick({kind, index: i})}, String(i + 1)));
  if (numbers.length > most) all.push(`and ${numbers.length - most} more`);
  return node('div', {class: 'chips'}, ...(all.length ? all : [node('span', {class: 'soft'}, 'none')]));
}

function facts(rows) {
  return node('table', {}, ...rows.map(([name, value, attributes]) => node('tr', {}, node('td', {class: 'soft'}, name), node('td', {...attributes}, value))));
}

function elementFacts(e) {
  const surface = run.elementSurface[e], regions = run.seen.rowsWith(e), set = new Set(chosen());
  const parts = [
    node('p', {class: 'big'}, `Element ${e + 1}`),
    facts([['seen by', `${run.timesVisible[e]} of ${counts.region} regions`, {id: 'times-visible', 'data-value': run.timesVisible[e]}],
           ['of the chosen', `${regions.filter((r) => set.has(r)).length} of ${set.size}`],
           ['area', short(run.areas[e])], ['group', groupOf(surface) || '(no name)', {id: 'picked-group'}], ['surface', String(surface + 1)]]),
    node('h2', {}, 'Regions that see it'), chips('region', regions, set)];
  if (counts.viewpoint) parts.push(node('h2', {}, 'Viewpoints that see it'), chips('viewpoint', run.seenFrom.rowsWith(e)));
  if (run.otherSeen) {
    let missed = 0, excess = 0;
    for (let p = run.elementPiece[e]; p < run.pieces.count && run.pieceElement[p] === e; ++p) {
      missed = Math.max(missed, run.missed[p]);
      excess = Math.max(excess, run.excess[p]);
    }
    parts.splice(2, 0, node('p', {class: missed ? 'missed' : 'soft', id: 'picked-missed', 'data-value': missed},
        `${missed} regions see it here and not by ${data.other_name}, ${excess} the other way round`));
  }
  return parts;
}

function sightFacts(kind, index) {
  const bits = kind === 'region' ? run.seen : run.seenFrom;
  let number = 0, area = 0, coverable = 0;
  for (let e = 0; e < counts.element; ++e) {
    coverable += run.timesVisible[e] ? run.areas[e] : 0;
    if (!bits.test(index, e)) continue;
    ++number;
    area += run.areas[e];
  }
  const rows = [['sees', `${short(number)} of ${short(counts.element)} elements`],
                ['of what can be seen', percent(coverable ? 100 * area / coverable : 100)]];
  const parts = [node('p', {class: 'big'}, `${kind === 'region' ? 'Region' : 'Viewpoint'} ${index + 1}`)];
  if (kind === 'viewpoint') {
    rows.push(['position', run.viewpoints[index].position.map(short).join(', ')], ['region', String(run.viewpoints[index].region + 1)]);
  } else {
    rows.push(['chosen', chosen().includes(index) ? 'yes' : 'no']);
    const inside = [...run.viewpoints.keys()].filter((v) => run.viewpoints[v].region === index);
    if (counts.viewpoint) rows.push(['viewpoints in it', inside.map((v) => v + 1).join(', ') || 'none']);
    if (run.otherSeen) {
      let missed = 0;
      for (let p = 0; p < run.pieces.count; ++p) missed += bits.test(index, run.pieceElement[p]) && !run.otherSeen.test(index, run.pieceOther[p]) ? 1 : 0;
      rows.push([`missed by ${data.other_name}`, `${missed} pieces`]);
    }
  }
  return [...parts, facts(rows)];
}

function drawSelection() {
  const {picked} = state;
  if (!picked) {
    const all = [...Array(counts.viewpoint).keys()];
    $('selection').replaceChildren(
        node('p', {class: 'soft'}, 'Click a surface to see who sees it, a viewpoint or (with shift) a region to see what it sees.'),
        node('h2', {}, `The best ${state.k} regions`), chips('region', chosen()),
        ...(counts.viewpoint ? [node('h2', {}, 'Viewpoints'), chips('viewpoint', all)] : []));
  } else if (picked.kind === 'element') {
    $('selection').replaceChildren(...elementFacts(picked.index));
  } else {
    $('selection').replaceChildren(...sightFacts(picked.kind, picked.index));
  }
}

function pickRow(cells, action, attributes = {}) {
  const act = (event) => {
    if (event.type === 'keydown' && event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    action();
  };
  return node('tr', {class: 'pick', tabindex: 0, onclick: act, onkeydown: act, ...attributes},
              ...cells.map((cell, i) => node('td', {class: i ? 'n' : undefined}, cell)));
}
const head = (...titles) => node('tr', {}, ...titles.map((title, i) => node('th', {class: i ? 'n' : undefined}, title)));

/** Surfaces with elements that no region, or only one, sees, by area. */
function fillHidden() {
  const surfaces = new Map();
  for (let e = 0; e < counts.element; ++e) {
    if (run.timesVisible[e] > 1) continue;
    const s = run.elementSurface[e];
    if (!surfaces.has(s)) surfaces.set(s, {s, unseen: 0, hardly: 0, largest: e, score: -1});
    const entry = surfaces.get(s);
    if (run.timesVisible[e]) entry.hardly += run.areas[e];
    else entry.unseen += run.areas[e];
    const score = run.areas[e] + (run.timesVisible[e] ? 0 : 1e30);
    if (score > entry.score) Object.assign(entry, {score, largest: e});
  }
  const list = [...surfaces.values()].sort((a, b) => b.unseen - a.unseen || b.hardly - a.hardly || a.s - b.s);
  const sum = (key) => list.reduce((total, entry) => total + entry[key], 0), most = 500;
  const all = run.areas.reduce((a, b) => a + b, 0);
  $('hidden-list').replaceChildren(
      node('p', {}, `${short(sum('unseen'))} of ${short(all)} square units (${percent(100 * sum('unseen') / all)}) are seen by no region, ${short(sum('hardly'))} by one only. Choose a surface to go there.`),
      node('table', {}, node('thead', {}, head('surface', 'unseen', 'by one')), node('tbody', {}, ...list.slice(0, most).map((entry) =>
        pickRow([`${entry.s + 1} ${groupOf(entry.s)}`, entry.unseen ? short(entry.unseen) : '', entry.hardly ? short(entry.hardly) : ''], () => {
          state.mode = 'unseen';
          pick({kind: 'element', index: entry.largest}, true);
        })))),
      list.length > most ? `and ${list.length - most} more` : '');
}

function fillTables() {
  const runs = [data.run, ...(data.other_run ? [data.other_run] : [])];
  const of = (record, ...path) => path.reduce((value, key) => (value === undefined || value === null ? value : value[key]), record);
  const row = (name, ...path) => node('tr', {}, node('td', {}, name), ...runs.map((record) => {
    const value = of(record, ...path);
    return node('td', {class: 'n'}, typeof value === 'number' ? short(value) : value === undefined || value === null ? '–' : String(value));
  }));
  $('tables').replaceChildren(
      node('h2', {}, '1. Scene and visibility'),
      node('table', {}, head('', ...runs.map((_, i) => (i ? data.other_name : data.name_of_run))),
           row('backend', 'options', 'backend'), row('polygons', 'scene', 'polygons'), row('elements', 'results', 'elements'),
           row('visible elements', 'results', 'visible_elements'), row('visibility, s', 'measured', 'seconds', 'visibility'), row('links', 'results', 'links'),
           row('regions', 'results', 'regions'), row('optimal regions', 'results', 'optimal_regions'), row('proved least', 'results', 'regions_lower_bound'),
           row('optimization, s', 'measured', 'seconds', 'cover'), row('viewpoints', 'results', 'viewpoints'),
           row('proved least', 'results', 'viewpoints_lower_bound'), row('viewpoints, s', 'measured', 'seconds', 'viewpoints'), row('memory, kB', 'measured', 'peak_memory_kb')),
      node('h2', {}, '2. The best set for each number of regions'),
      node('table', {}, head('regions', 'area', 'at most', 'evaluations', 's'), ...run.covers.map((c, i) => pickRow(
        [String(i + 1), percent(c.covered), percent(Math.min(c.bound, 100)), short(c.evaluations), short(c.seconds)], () => setK(i + 1), {'data-k': i + 1}))),
      node('h2', {}, '3. Viewpoints'),
      run.viewpoints.length ? node('table', {}, head('viewpoint', 'region', 'area so far', 's'), ...run.viewpoints.map((v, i) => pickRow(
        [String(i + 1), String(v.region + 1), percent(v.covered), short(v.seconds)], () => pick({kind: 'viewpoint', index: i})))) : node('p', {class: 'soft'}, 'none were looked for'));
}

function fillPlots() {
  const runs = [data.run, ...(data.other_run ? [data.other_run] : [])];
  const results = data.run.results || {};
  const brackets = [['regions', results.regions_lower_bound ?? null, run.covers.length]];
  if (run.viewpoints.length) brackets.push(['viewpoints', results.viewpoints_lower_bound ?? null, run.viewpoints.length]);
  const verdicts = Object.keys(data.run.verdicts || {}).map((name) => [name.replace(/_/g, ' '), runs.map((r) => (r.verdicts || {})[name] || 0)]);
  $('plots').replaceChildren(
      node('h2', {}, 'Covered area against the number of regions'), node('div', {id: 'coverage'}),
      node('p', {class: 'soft'}, 'Line: the best found. Dashed: no set of so many regions covers more.'),
      node('h2', {}, 'How many are needed'), bracketPlot(brackets),
      node('p', {class: 'soft'}, 'Dot: found. Dashed: fewer are proved not to do.'),
      node('h2', {}, 'How shafts were decided'), barPlot(verdicts),
      ...(data.other_run ? [node('p', {class: 'soft'}, `Above: ${data.name_of_run}; below: ${data.other_name}.`)] : []));
}

/** Nested objects as rows `a.b.c`. */
function flat(value, prefix, rows) {
  for (const [key, inner] of Object.entries(value)) {
    const name = prefix ? `${prefix}.${key}` : key;
    if (inner !== null && typeof inner === 'object' && !Array.isArray(inner)) flat(inner, name, rows);
    else rows.push([name.replace(/_/g, ' '), Array.isArray(inner) ? inner.join(' ') : String(inner)]);
  }
  return rows;
}

function fillRun() {
  const parts = [];
  const {options, inputs, scene, measured, backend_statistics: statistics, ...rest} = data.run;
  delete rest.verdicts;
  for (const [title, part] of [['Options', options], ['Inputs', inputs], ['Program and results', rest], ['Scene', scene], ['Measured', measured], ['Backend', statistics]]) {
    if (part) parts.push(node('h2', {}, title), facts(flat(part, '', [])));
  }
  if (data.other_run) parts.push(node('h2', {}, `Compared with: options of ${data.other_name}`), facts(flat(data.other_run.options || {}, '', [])));
  $('run').replaceChildren(...parts);
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  if (view) view.scene.background = new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue('--stage').trim());
  update();
}

function showTab(tab) {
  for (const other of document.querySelectorAll('[role=tab]')) {
    const on = other === tab;
    other.setAttribute('aria-selected', on);
    other.tabIndex = on ? 0 : -1;
    $(other.getAttribute('aria-controls')).hidden = !on;
  }
}

function connect() {
  for (const [mode, {name}] of Object.entries(colourings)) $('mode').append(node('option', {value: mode}, name));
  $('mode').addEventListener('change', () => setMode($('mode').value));
  Object.assign($('k'), {min: run.covers.length ? 1 : 0, max: run.covers.length});
  $('k').addEventListener('input', () => setK(Number($('k').value)));
  const tabs = [...document.querySelectorAll('[role=tab]')];
  tabs.forEach((tab, i) => {
    tab.addEventListener('click', () => showTab(tab));
    tab.addEventListener('keydown', (event) => {
      const by = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!by) return;
      const next = tabs[(i + by + tabs.length) % tabs.length];
      showTab(next);
      next.focus();
      event.stopPropagation();
    });
  });
  $('go').addEventListener('submit', (event) => {
    event.preventDefault();
    const kind = $('go-kind').value, index = Number($('go-number').value) - 1;
    if (index >= 0 && index < counts[kind]) pick({kind, index});
  });
  $('clear').addEventListener('click', () => pick(null));
  $('theme').addEventListener('click', () => setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'));
  const keys = {
    '[': () => setK(state.k - 1), ']': () => setK(state.k + 1), n: () => step(1), p: () => step(-1), Escape: () => pick(null),
    m: () => { const all = Object.keys(colourings); setMode(all[(all.indexOf(state.mode) + 1) % all.length]); },
    t: () => $('theme').click(), 0: () => view && view.home(), '+': () => view && view.zoom(0.85), '=': () => view && view.zoom(0.85), '-': () => view && view.zoom(1 / 0.85),
  };
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT)$/.test(event.target.tagName)) return;
    if (keys[event.key]) keys[event.key]();
  });
  if (!view) return;
  const canvas = $('canvas'), turn = 0.09;
  const arrows = {ArrowLeft: [-turn, 0], ArrowRight: [turn, 0], ArrowUp: [0, turn], ArrowDown: [0, -turn]};
  canvas.addEventListener('keydown', (event) => {
    if (!arrows[event.key]) return;
    view.turn(...arrows[event.key]);
    event.preventDefault();
  });
  let pressed = null;
  canvas.addEventListener('mousedown', (event) => { pressed = [event.clientX, event.clientY]; canvas.focus({preventScroll: true}); });
  canvas.addEventListener('click', (event) => {
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const box = canvas.getBoundingClientRect();
    showTab($('tab-explore'));
    pick(view.pick(event.clientX - box.left, event.clientY - box.top, event.shiftKey));
  });
  $('show-regions').addEventListener('change', () => { view.regions.visible = $('show-regions').checked; view.draw(); });
  $('show-lines').addEventListener('change', () => { view.showLines = $('show-lines').checked; view.setCoarse(false); });
  $('home').addEventListener('click', () => view.home());
}

function start() {
  $('title').textContent = run.name;
  document.title = `${run.name} – viewcover`;
  const seen = run.timesVisible.reduce((total, n) => total + (n > 0), 0);
  $('summary').textContent = `${short(run.surfaces.count)} polygons, ${short(counts.element)} elements (${short(seen)} can be seen), ` +
      `${run.covers.length} of ${counts.region} regions` + (counts.viewpoint ? `, ${counts.viewpoint} viewpoints` : '') +
      (run.missed ? `; ${data.name_of_run} against ${data.other_name}: ${short(run.missed.filter((m) => m > 0).length)} pieces with missed regions` : '');
  $('summary').title = $('summary').textContent;
  try {
    view = new SceneView($('canvas'));
  } catch (error) {
    $('message').hidden = false;
    $('message').textContent = `The scene cannot be drawn: ${error.message}. The tables are all here.`;
  }
  connect();
  fillHidden();
  fillTables();
  fillPlots();
  fillRun();
  if (!run.viewpoints.length) $('go-kind').querySelector('[value=viewpoint]').remove();
  setTheme(window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
  if (view) view.drawNow();
}

start();
