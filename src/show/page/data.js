// The data of the page: typed arrays from base64, bit rows, counts.

const data = JSON.parse(document.getElementById('data').textContent);

function bytes(text) {
  const raw = atob(text);
  const result = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) result[i] = raw.charCodeAt(i);
  return result;
}
const floats = (text) => new Float32Array(bytes(text).buffer);
const numbers = (text) => new Uint32Array(bytes(text).buffer);

/** #rows x #columns bits; a row takes whole bytes, the lowest bit comes first. */
class BitRows {
  constructor({rows, columns, bits}) {
    this.rows = rows;
    this.columns = columns;
    this.stride = Math.ceil(columns / 8);
    this.bits = bytes(bits);
  }
  test(row, column) {
    return (this.bits[row * this.stride + (column >> 3)] >> (column & 7)) & 1;
  }
  rowsWith(column) {
    const result = [];
    for (let row = 0; row < this.rows; ++row) if (this.test(row, column)) result.push(row);
    return result;
  }
  /** How many of the rows have each column. */
  counts(rows) {
    const result = new Uint32Array(this.columns);
    for (const row of rows) {
      for (let column = 0; column < this.columns; ++column) result[column] += this.test(row, column);
    }
    return result;
  }
}

/** Polygons one after the other: corner i of polygon p at 3 * (first[p] + i). */
function polygons({counts, corners}) {
  const sizes = bytes(counts);
  const first = new Uint32Array(sizes.length + 1);
  for (let p = 0; p < sizes.length; ++p) first[p + 1] = first[p] + sizes[p];
  return {count: sizes.length, first, corners: floats(corners)};
}

/** All numbers of the page count from 0, those it shows from 1. `pieces` are what is drawn: the
 *  elements of the run, or the common refinement with those of the run it is compared with. */
const run = {
  name: data.name,
  groups: data.groups,
  pieces: polygons(data.pieces),
  pieceSurface: numbers(data.piece_surface),
  pieceElement: numbers(data.piece_element),
  pieceOther: data.piece_other ? numbers(data.piece_other) : null,
  missed: data.missed ? numbers(data.missed) : null,
  excess: data.excess ? numbers(data.excess) : null,
  surfaces: polygons(data.surfaces),
  surfaceGroup: numbers(data.surface_group),
  cutPlanes: floats(data.cut_planes),
  areas: floats(data.areas),
  timesVisible: numbers(data.times_visible),
  regions: polygons(data.regions),
  seen: new BitRows(data.seen),
  otherSeen: data.other_seen ? new BitRows(data.other_seen) : null,
  covers: data.covers,
  viewpoints: data.viewpoints,
  seenFrom: new BitRows(data.seen_from_viewpoints),
  upAxis: data.up_axis,
};
run.elementSurface = new Uint32Array(run.areas.length);
run.elementPiece = new Uint32Array(run.areas.length);
for (let p = run.pieces.count; p-- > 0;) {
  run.elementSurface[run.pieceElement[p]] = run.pieceSurface[p];
  run.elementPiece[run.pieceElement[p]] = p;
}

const groupOf = (surface) => run.groups[run.surfaceGroup[surface]];

/** A number for people: four significant digits, no exponent where it can be helped. */
function short(x) {
  if (x === null || x === undefined) return '–';
  if (!Number.isFinite(x)) return String(x);
  if (Number.isInteger(x)) return x.toLocaleString('en').replace(/,/g, ' ');
  return String(Number(x.toPrecision(4)));
}
const percent = (x) => `${x.toFixed(x > 99.9 && x < 100 ? 4 : 2)} %`;
