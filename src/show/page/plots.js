// Plots as SVG.

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

/** Round numbers between the ends, about five. */
function ticks(least, most) {
  const step = 10 ** Math.floor(Math.log10((most - least) / 4 || 1));
  const wide = [1, 2, 5, 10].map((m) => m * step).find((s) => (most - least) / s <= 6);
  const result = [];
  for (let t = Math.ceil(least / wide - 1e-9) * wide; t <= most + 1e-9 * wide; t += wide) result.push(Number(t.toPrecision(12)));
  return result;
}

/** Covered area against k: found, and what is proved to be the most. */
function coveragePlot(covers, k, choose) {
  const width = 360, height = 220, left = 46, right = 12, top = 10, bottom = 34;
  const least = Math.floor(Math.min(...covers.map((c) => c.covered)) / 2) * 2, span = Math.max(100 - least, 1e-3);
  const last = Math.max(covers.length, 2);
  const x = (n) => left + (n - 1) / (last - 1) * (width - left - right);
  const y = (p) => top + (100 - p) / span * (height - top - bottom);
  const root = svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
    'aria-label': `covered area for 1 to ${covers.length} regions`});
  for (const t of ticks(least, 100)) {
    root.append(svg('line', {class: 'grid', x1: left, x2: width - right, y1: y(t), y2: y(t)}),
                svg('text', {x: left - 6, y: y(t) + 4, 'text-anchor': 'end'}, `${t} %`));
  }
  for (const t of ticks(1, last).filter(Number.isInteger)) root.append(svg('text', {x: x(t), y: height - bottom + 16, 'text-anchor': 'middle'}, String(t)));
  root.append(svg('text', {x: (left + width - right) / 2, y: height - 3, 'text-anchor': 'middle'}, 'number of regions'));
  const path = (of) => covers.map((c, i) => `${i ? 'L' : 'M'}${x(i + 1)} ${y(Math.min(of(c), 100))}`).join('');
  const back = covers.slice().reverse().map((c, i) => `L${x(covers.length - i)} ${y(c.covered)}`).join('');
  root.append(svg('path', {class: 'gap', d: `${path((c) => c.bound)}${back}Z`}),
              svg('path', {class: 'bound', d: path((c) => c.bound)}), svg('path', {class: 'found', d: path((c) => c.covered)}));
  covers.forEach((c, i) => {
    const dot = svg('circle', {class: `dot${i + 1 === k ? ' now' : ''}`, cx: x(i + 1), cy: y(c.covered), r: 4});
    dot.append(svg('title', {}, `${i + 1}: ${percent(c.covered)}, at most ${percent(Math.min(c.bound, 100))}`));
    dot.addEventListener('click', () => choose(i + 1));
    root.append(dot);
  });
  return root;
}

/** Lower and upper bounds on numbers: [name, lower or null, upper]. */
function bracketPlot(brackets) {
  const width = 360, line = 30, left = 80, right = 30;
  const end = Math.max(...brackets.map((b) => b[2])) + 1;
  const x = (n) => left + n / end * (width - left - right);
  const root = svg('svg', {viewBox: `0 0 ${width} ${brackets.length * line + 26}`, role: 'img', 'aria-label': 'proved least and found numbers'});
  brackets.forEach(([name, lower, upper], i) => {
    const y = i * line + 18;
    root.append(svg('text', {x: 0, y: y + 4}, name), svg('line', {class: 'grid', x1: x(0), x2: x(end), y1: y, y2: y}));
    if (lower !== null) {
      root.append(svg('rect', {class: 'gap', x: x(lower) - 3, y: y - 7, width: x(upper) - x(lower) + 6, height: 14}),
                  svg('line', {class: 'bound', x1: x(lower), x2: x(lower), y1: y - 9, y2: y + 9}));
    }
    root.append(svg('circle', {class: 'dot', cx: x(upper), cy: y, r: 5}));
  });
  for (const t of ticks(0, end).filter(Number.isInteger)) root.append(svg('text', {x: x(t), y: brackets.length * line + 20, 'text-anchor': 'middle'}, String(t)));
  return root;
}

/** Counts by name, for one run or two: [name, [counts]]. */
function barPlot(rows) {
  const width = 360, bar = 11, left = 150, runs = rows.length ? rows[0][1].length : 0;
  const line = runs * (bar + 2) + 8;
  const end = Math.max(1, ...rows.flatMap((r) => r[1]));
  const root = svg('svg', {viewBox: `0 0 ${width} ${rows.length * line + 4}`, role: 'img', 'aria-label': 'counts'});
  rows.forEach(([name, counts], i) => {
    root.append(svg('text', {x: 0, y: i * line + (runs * (bar + 2)) / 2 + 6}, name));
    counts.forEach((count, r) => {
      const y = i * line + 3 + r * (bar + 2), long = count / end * (width - left - 56);
      root.append(svg('rect', {class: r ? 'bar second' : 'bar', x: left, y, width: count ? Math.max(long, 1) : 0, height: bar}),
                  svg('text', {x: left + long + 4, y: y + bar - 1}, short(count)));
    });
  });
  return root;
}
