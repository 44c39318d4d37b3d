// What colours mean. Each colouring gives a colour for each piece, [0, 255] a channel, and a legend.

const palette = data.palette;

function along(stops, t) {
  const place = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const below = Math.min(Math.floor(place), stops.length - 2);
  return stops[below].map((c, i) => Math.round(c + (stops[below + 1][i] - c) * (place - below)));
}
const rampPlace = (n, most) => (most <= 1 ? 1 : (n - 1) / (most - 1));
const css = (colour) => `rgb(${colour.join(',')})`;
const most = (counts) => counts.reduce((a, b) => Math.max(a, b), 0);

function byCount(counts, title) {
  const end = most(counts);
  const table = [palette.never];
  for (let n = 1; n <= end; ++n) table.push(along(palette.ramp, rampPlace(n, end)));
  const entries = [{colour: palette.never, text: 'never'}];
  if (end <= 8) for (let n = 1; n <= end; ++n) entries.push({colour: table[n], text: String(n)});
  return {title, entries, ramp: end > 8 ? end : 0, of: (p) => table[counts[run.pieceElement[p]]]};
}

function byDifference() {
  const missed = most(run.missed), excess = most(run.excess);
  const entries = [{colour: palette.quiet, text: 'none'}];
  if (missed) {
    entries.push({colour: palette.missed[0], text: '1'},
                 {colour: palette.missed[palette.missed.length - 1], text: `${missed} that ${data.other_name} misses`});
  }
  if (excess) {
    entries.push({colour: palette.excess[0], text: '1'},
                 {colour: palette.excess[palette.excess.length - 1], text: `${excess} that only ${data.other_name} has`});
  }
  return {
    title: 'regions that see it in one run only', entries, ramp: 0,
    of: (p) => run.missed[p] ? along(palette.missed, rampPlace(run.missed[p], missed)) :
        run.excess[p] ? along(palette.excess, rampPlace(run.excess[p], excess)) : palette.quiet,
  };
}

function byGroup() {
  const areas = new Float64Array(run.groups.length);
  run.areas.forEach((area, e) => { areas[run.surfaceGroup[run.elementSurface[e]]] += area; });
  const order = [...areas.keys()].sort((a, b) => areas[b] - areas[a] || a - b);
  const own = palette.categories.length - 1;
  const colours = run.groups.map(() => palette.categories[own]);
  order.slice(0, own).forEach((group, rank) => { colours[group] = palette.categories[rank]; });
  const entries = order.slice(0, own).map((group) => ({colour: colours[group], text: run.groups[group] || '(no name)'}));
  if (order.length > own) entries.push({colour: palette.categories[own], text: `${order.length - own} others`});
  return {title: 'group', entries, ramp: 0, of: (p) => colours[run.surfaceGroup[run.pieceSurface[p]]]};
}

function byUnseen() {
  return {
    title: 'regions that see it', ramp: 0,
    entries: [{colour: palette.never, text: 'none'}, {colour: palette.hardly, text: '1'},
              {colour: palette.quiet, text: '2 or more'}],
    of: (p) => [palette.never, palette.hardly, palette.quiet][Math.min(2, run.timesVisible[run.pieceElement[p]])],
  };
}

/** What one region or viewpoint sees; what only the other run says it does not glows. */
function bySight(bits, row, what) {
  const glow = what === 'region' && run.otherSeen;
  const entries = [{colour: palette.lit, text: `seen by the ${what}`}, {colour: palette.dim, text: 'not seen'}];
  if (glow) {
    entries.push({colour: palette.missed[13], text: `missed by ${data.other_name}`},
                 {colour: palette.excess[13], text: `seen by ${data.other_name} only`});
  }
  return {
    title: `${what} ${row + 1}`, ramp: 0, entries,
    of: (p) => {
      const seen = bits.test(row, run.pieceElement[p]);
      if (glow) {
        const other = run.otherSeen.test(row, run.pieceOther[p]);
        if (seen && !other) return palette.missed[13];
        if (!seen && other) return palette.excess[13];
      }
      return seen ? palette.lit : palette.dim;
    },
  };
}

const colourings = {
  covered_by: {name: 'seen by chosen regions', make: (k) => byCount(run.seen.counts(k ? run.covers[k - 1].regions : []), 'chosen regions that see it')},
  times_visible: {name: 'seen by all regions', make: () => byCount(run.timesVisible, 'regions that see it')},
  viewpoints: run.viewpoints.length ? {name: 'seen by viewpoints', make: () => byCount(run.seenFrom.counts(run.viewpoints.keys()), 'viewpoints that see it')} : null,
  difference: run.missed ? {name: 'difference of the runs', make: byDifference} : null,
  unseen: {name: 'unseen and hardly seen', make: byUnseen},
  group: {name: 'group', make: byGroup},
};
for (const mode of Object.keys(colourings)) if (!colourings[mode]) delete colourings[mode];
