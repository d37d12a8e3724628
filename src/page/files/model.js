// The model of the page: unpacked, and shaped for drawing.
"use strict";
// Vectors and matrices, the latter a column after the other.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const plus = (...vectors) => vectors.reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));
const at = (list, k) => [list[3 * k], list[3 * k + 1], list[3 * k + 2]];
const between = (value, least, most) => Math.max(least, Math.min(most, value));
const moved = (m, p) => [0, 1, 2].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
const times = (a, b) => new DOMMatrix(a).multiply(new DOMMatrix(b)).toFloat32Array();
// By an angle about an axis through the origin.
const turning = (axis, angle) => [...new DOMMatrix().rotateAxisAngle(...axis, angle * 180 / Math.PI).toFloat64Array()];
// Least and greatest coordinates of places that begin so many numbers after each other.
function boxed(list, step) {
  const low = [Infinity, Infinity, Infinity], high = scaled(low, -1);
  for (let k = 0; k < list.length; k += step) for (let axis = 0; axis < 3; ++axis) {
    low[axis] = Math.min(low[axis], list[k + axis]);
    high[axis] = Math.max(high[axis], list[k + axis]);
  }
  return [low, high];
}

const pageData = (id) => JSON.parse(document.getElementById(id)?.textContent ?? null);
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
    const last = [0, 0, 0], scale = [0, 1, 2].map((axis) => (high[axis] - low[axis]) / 65535);
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

// A surface's facets: vectors along their normals as long as twice their areas, unit normals, the half-edge across each
// (-1: none; half-edge e of facet f, 3 f + e, begins at its corner e), and which half-edges begin at a point (those of
// point v are fan[first[v]] to fan[first[v + 1]]). In double, by the program's own steps.
function meshed(points, indices) {
  const facets = indices.length / 3, count = points.length / 3;
  const vectors = new Float64Array(3 * facets), normals = new Float64Array(3 * facets);
  const first = new Uint32Array(count + 1), fan = new Uint32Array(3 * facets);
  const across = new Int32Array(3 * facets).fill(-1);
  for (let f = 0; f < 3 * facets; f += 3) {
    const a = 3 * indices[f], b = 3 * indices[f + 1], c = 3 * indices[f + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    vectors[f] = uy * vz - vy * uz;
    vectors[f + 1] = uz * vx - vz * ux;
    vectors[f + 2] = ux * vy - vx * uy;
    const long = Math.sqrt(vectors[f] ** 2 + vectors[f + 1] ** 2 + vectors[f + 2] ** 2);
    for (let k = f; k < f + 3 && long > 0; ++k) normals[k] = vectors[k] / long;
  }
  for (const v of indices) ++first[v + 1];
  for (let v = 0; v < count; ++v) first[v + 1] += first[v];
  const fill = first.slice(), end = (h) => indices[h % 3 === 2 ? h - 2 : h + 1];
  for (let h = 0; h < indices.length; ++h) fan[fill[indices[h]]++] = h;
  const only = (v, w) => {
    let found = -1;
    for (let k = first[v]; k < first[v + 1]; ++k)
      if (end(fan[k]) === w) { if (found >= 0) return -1; found = fan[k]; }
    return found;
  };
  for (let h = 0; h < indices.length; ++h) {
    if (across[h] >= 0) continue;
    const back = only(end(h), indices[h]);
    if (back < 0 || only(indices[h], end(h)) !== h) continue;
    across[h] = back;
    across[back] = h;
  }
  const cornersOf = (facet) => [0, 1, 2].map((i) => at(points, indices[3 * facet + i]));
  return {points, indices, facets, vectors, normals, first, fan, across, end, cornersOf};
}

const sharp = Math.cos(Math.PI / 6);
// Position and normal of every corner of the facets, smooth where the surface bends by less than 30 degrees.
function corners({points, indices, facets, vectors, normals, first, fan}, centre = [0, 0, 0], diagonal = 1) {
  const list = new Float32Array(18 * facets);
  for (let h = 0; h < indices.length; ++h) {
    const f = 3 * Math.floor(h / 3), v = indices[h], sum = [0, 0, 0];
    for (let k = first[v]; k < first[v + 1]; ++k) {
      const g = 3 * Math.floor(fan[k] / 3);
      if (normals[f] * normals[g] + normals[f + 1] * normals[g + 1] + normals[f + 2] * normals[g + 2] <= sharp)
        continue;
      for (let axis = 0; axis < 3; ++axis) sum[axis] += vectors[g + axis];
    }
    const long = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) || 1;
    for (let axis = 0; axis < 3; ++axis) {
      list[6 * h + axis] = (points[3 * v + axis] - centre[axis]) / diagonal;
      list[6 * h + 3 + axis] = sum[axis] / long;
    }
  }
  return list;
}
// Calls use(half-edge, its facet, the facet across, whether it bends by more) for every edge between two facets.
function eachEdge({indices, normals, across}, use) {
  for (let h = 0; h < indices.length; ++h) {
    if (across[h] <= h) continue;
    const left = Math.floor(h / 3), right = Math.floor(across[h] / 3);
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
    return {box: eight.map((k) => [0, 1, 2].map((axis) => box[k >> axis & 1][axis])),
      surface: tools.buffer(corners, [3, 3]), edge: tools.buffer(edges, [3]), thick: tools.buffer(lines, [3])};
  });
}
