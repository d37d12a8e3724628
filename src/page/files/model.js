// The model of the page: unpacked, and shaped for drawing.
// Vectors and matrices, the latter a column after the other.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (...vectors) => vectors.reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));
const axis = (k) => [0, 1, 2].map((other) => other === k ? 1 : 0);
// Across a direction and the axis that is farthest from it.
function across(direction) {
  const sizes = direction.map(Math.abs);
  return unit(cross(axis(sizes.indexOf(Math.min(...sizes))), direction));
}
const at = (list, k) => [list[3 * k], list[3 * k + 1], list[3 * k + 2]];
const between = (value, least, most) => Math.max(least, Math.min(most, value));
const moved = (m, p) => [0, 1, 2].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
// By an angle about an axis through the origin.
const turning = (axis, angle) => [...new DOMMatrix().rotateAxisAngle(...axis, angle * 180 / Math.PI).toFloat64Array()];
// Least and greatest coordinates of places that begin so many numbers after each other.
function boxed(list, step) {
  const low = [Infinity, Infinity, Infinity], high = scaled(low, -1);
  for (let k = 0; k < list.length; k += step) for (let i = 0; i < 3; ++i) {
    low[i] = Math.min(low[i], list[k + i]);
    high[i] = Math.max(high[i], list[k + i]);
  }
  return [low, high];
}

// The bytes in a text of the page, and numbers among them, seven bits a byte.
async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
function reader(data, place = 0) {
  const number = () => {
    for (let value = 0, scale = 1; ; scale *= 128) {
      const byte = data[place++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  };
  const difference = () => { const value = number(); return value % 2 ? -(value + 1) / 2 : value / 2; };
  // Corners of facets: new ones in order, others by how far back they are.
  const indices = (facets) => {
    let next = 0;
    return Uint32Array.from({length: 3 * facets}, () => { const back = number(); return back ? next - back : next++; });
  };
  return {difference, indices};
}

async function unpacked(model) {
  const {difference, indices} = reader(await inflated(model.data));
  const points = (count, low, high) => {
    const last = [0, 0, 0], scale = scaled(minus(high, low), 1 / 65535);
    return Float32Array.from({length: 3 * count},
      (_, k) => (low[k % 3] + scale[k % 3] * (last[k % 3] += difference())) / model.diagonal);
  };
  for (const surface of model.surfaces) {
    surface.points = points(surface.corners, surface.low, surface.high);
    surface.indices = indices(surface.facets);
    let last = 0;
    surface.groups = Uint16Array.from({length: surface.facets}, () => last += difference());
  }
  // Lines share one box and one chain of differences.
  const total = model.lines.reduce((sum, line) => sum + line.points, 0);
  const all = total ? points(total, model.lines_low, model.lines_high) : [];
  let first = 0;
  for (const line of model.lines) line.place = all.subarray(3 * first, 3 * (first += line.points));
  return model;
}

// A surface's facets: vectors along their normals as long as twice their areas, unit normals, areas, the half-edge
// opposite to each (-1: none; half-edge e of facet f, 3 f + e, begins at its corner e), and which half-edges begin at a
// point (those of point v are fan[first[v]] to fan[first[v + 1]]). In double, by the program's own steps.
function meshed(points, indices) {
  const facets = indices.length / 3, cornersOf = (facet) => [0, 1, 2].map((i) => at(points, indices[3 * facet + i]));
  const [vectors, normals, areas] = [3, 3, 1].map((each) => new Float64Array(each * facets));
  for (let f = 0; f < facets; ++f) {
    const [a, b, c] = cornersOf(f), vector = cross(minus(b, a), minus(c, a)), long = Math.sqrt(dot(vector, vector));
    vectors.set(vector, 3 * f);
    areas[f] = 0.5 * long;
    if (long > 0) normals.set(vector.map((value) => value / long), 3 * f);
  }
  const first = new Uint32Array(points.length / 3 + 1), fan = new Uint32Array(3 * facets);
  for (const v of indices) ++first[v + 1];
  for (let v = 1; v < first.length; ++v) first[v] += first[v - 1];
  const fill = first.slice(), end = (h) => indices[h % 3 === 2 ? h - 2 : h + 1];
  indices.forEach((v, h) => { fan[fill[v]++] = h; });
  // The half-edge from one point to another; -1 where there is none, or more than one.
  const only = (v, w) => {
    let found = -1;
    for (let k = first[v]; k < first[v + 1]; ++k)
      if (end(fan[k]) === w) { if (found >= 0) return -1; found = fan[k]; }
    return found;
  };
  const opposite = Int32Array.from(indices, (v, h) => only(v, end(h)) < 0 ? -1 : only(end(h), v));
  return {points, indices, facets, vectors, normals, areas, first, fan, opposite, end, cornersOf};
}

// A place of the part in the unit frame, and back.
const inUnit = ({centre, diagonal}, place) => scaled(minus(place, centre), 1 / diagonal);
const inPart = ({centre, diagonal}, place) => plus(scaled(place, diagonal), centre);
const sharp = Math.cos(Math.PI / 6);
// Position and normal of every corner of the facets, smooth where the surface bends by less than 30 degrees.
function corners({points, indices, vectors, normals, first, fan}, frame = {centre: [0, 0, 0], diagonal: 1}) {
  const list = new Float32Array(6 * indices.length);
  indices.forEach((v, h) => {
    const normal = at(normals, Math.floor(h / 3)), sum = [0, 0, 0];
    for (let k = first[v]; k < first[v + 1]; ++k) {
      const g = Math.floor(fan[k] / 3);
      if (dot(normal, at(normals, g)) > sharp) for (let i = 0; i < 3; ++i) sum[i] += vectors[3 * g + i];
    }
    list.set(inUnit(frame, at(points, v)), 6 * h);
    list.set(unit(sum), 6 * h + 3);
  });
  return list;
}
// Calls use(half-edge, its facet, the facet across, whether it bends by more) for every edge between two facets.
function eachEdge({indices, normals, opposite}, use) {
  for (let h = 0; h < indices.length; ++h) {
    if (opposite[h] <= h) continue;
    const left = Math.floor(h / 3), right = Math.floor(opposite[h] / 3);
    use(h, left, right, dot(at(normals, left), at(normals, right)) <= sharp);
  }
}

// For every group its surface, sharp edges and lines as `tools` draw them, and the corners of its box.
function shaped(model, tools) {
  const groups = model.groups.map(() => ({filled: 0, edges: [], lines: []}));
  for (const surface of model.surfaces) for (const owner of surface.groups) groups[owner].filled += 18;
  for (const group of groups) group.corners = new Float32Array(group.filled);
  for (const {points, indices, groups: owner} of model.surfaces) {
    const mesh = meshed(points, indices), all = corners(mesh);
    for (let f = mesh.facets - 1; f >= 0; --f) {
      const group = groups[owner[f]];
      group.corners.set(all.subarray(18 * f, 18 * f + 18), group.filled -= 18);
    }
    eachEdge(mesh, (h, left, right, bent) => {
      for (const side of new Set(bent ? [owner[left], owner[right]] : []))
        groups[side].edges.push(...at(points, indices[h]), ...at(points, mesh.end(h)));
    });
  }
  for (const {place, points, closed, group} of model.lines)
    for (let k = closed ? 0 : 1; k < points; ++k)
      groups[group].lines.push(...at(place, (k || points) - 1), ...at(place, k));
  return groups.map(({corners, edges, lines}) => {
    const box = boxed(corners, 6), eight = corners.length ? [0, 1, 2, 3, 4, 5, 6, 7] : [];
    return {box: eight.map((k) => [0, 1, 2].map((i) => box[k >> i & 1][i])),
      surface: tools.buffer(corners, [3, 3]), edge: tools.buffer(edges, [3]), thick: tools.buffer(lines, [3])};
  });
}
