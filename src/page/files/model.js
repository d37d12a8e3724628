// The model of the page: unpacked, and shaped for drawing.
"use strict";
// Vectors and matrices, the latter a column after the other.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const plus = (...vectors) => vectors.reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));
const at = (list, k) => [list[3 * k], list[3 * k + 1], list[3 * k + 2]];
function times(a, b) {
  const c = new Float32Array(16);
  for (let k = 0; k < 16; ++k) for (let i = 0; i < 4; ++i) c[k] += a[k % 4 + 4 * i] * b[(k >> 2) * 4 + i];
  return c;
}
function moved(m, p) { return [0, 1, 2].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]); }

// The bytes in an element of the page, and numbers among them, seven bits a byte.
async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
function reader(data, at = 0) {
  const number = () => {
    for (let value = 0, scale = 1; ; scale *= 128) {
      const byte = data[at++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  };
  const difference = () => { const value = number(); return value % 2 ? -(value + 1) / 2 : value / 2; };
  // Corners of facets: new ones in order, others by how far back they are.
  const indices = (facets) => {
    const list = new Uint32Array(3 * facets);
    for (let k = 0, next = 0; k < list.length; ++k) {
      const back = number();
      list[k] = next - back;
      if (back === 0) ++next;
    }
    return list;
  };
  return {difference, indices};
}

async function unpacked(model) {
  const {difference, indices} = reader(await inflated(model.data));
  const points = (count, low, high) => {
    const list = new Float32Array(3 * count), last = [0, 0, 0];
    for (let k = 0; k < 3 * count; ++k) {
      last[k % 3] += difference();
      list[k] = (low[k % 3] + (high[k % 3] - low[k % 3]) * last[k % 3] / 65535) / model.diagonal;
    }
    return list;
  };
  for (const surface of model.surfaces) {
    surface.points = points(surface.corners, surface.low, surface.high);
    surface.indices = indices(surface.facets);
    surface.groups = new Uint16Array(surface.facets);
    for (let k = 0, last = 0; k < surface.facets; ++k) surface.groups[k] = last += difference();
  }
  // Lines share one box and one chain of differences.
  const total = model.lines.reduce((sum, line) => sum + line.points, 0);
  const all = total ? points(total, model.lines_low, model.lines_high) : [];
  let first = 0;
  for (const line of model.lines) line.place = all.subarray(3 * first, 3 * (first += line.points));
  return model;
}

// A surface's facets: vectors along their normals as long as twice their areas, unit normals, the half-edge across each
// (-1: none; half-edge e of facet f, 3 f + e, begins at its corner e), and which half-edges begin at a point: those of
// point v are fan[first[v]] to fan[first[v + 1]]. In double, by the program's own steps.
function meshed(points, indices) {
  const facets = indices.length / 3, count = points.length / 3;
  const vectors = new Float64Array(3 * facets), normals = new Float64Array(3 * facets);
  const first = new Uint32Array(count + 1), fan = new Uint32Array(3 * facets), across = new Int32Array(3 * facets).fill(-1);
  for (let f = 0; f < facets; ++f) {
    const a = 3 * indices[3 * f], b = 3 * indices[3 * f + 1], c = 3 * indices[3 * f + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    const x = uy * vz - vy * uz, y = uz * vx - vz * ux, z = ux * vy - vx * uy, long = Math.sqrt(x * x + y * y + z * z);
    for (let axis = 0; axis < 3; ++axis) {
      vectors[3 * f + axis] = axis === 0 ? x : axis === 1 ? y : z;
      if (long > 0) normals[3 * f + axis] = vectors[3 * f + axis] / long;
    }
  }
  for (const v of indices) ++first[v + 1];
  for (let v = 0; v < count; ++v) first[v + 1] += first[v];
  const fill = first.slice();
  for (let h = 0; h < indices.length; ++h) fan[fill[indices[h]]++] = h;
  const end = (h) => indices[h % 3 === 2 ? h - 2 : h + 1];
  const between = (v, w) => {
    let found = -1, many = 0;
    for (let k = first[v]; k < first[v + 1]; ++k) if (end(fan[k]) === w) { found = fan[k]; ++many; }
    return many === 1 ? found : -1;
  };
  for (let h = 0; h < indices.length; ++h) {
    if (across[h] >= 0) continue;
    const back = between(end(h), indices[h]);
    if (back < 0 || between(indices[h], end(h)) !== h) continue;
    across[h] = back;
    across[back] = h;
  }
  return {points, indices, facets, vectors, normals, first, fan, across, end};
}

// Position and normal of every corner of the facets, smooth where the surface bends by less than 30 degrees.
const sharp = Math.cos(Math.PI / 6);
function corners(mesh, centre = [0, 0, 0], diagonal = 1) {
  const {points, indices, facets, vectors, normals, first, fan} = mesh, list = new Float32Array(18 * facets);
  for (let h = 0; h < indices.length; ++h) {
    const f = 3 * Math.floor(h / 3), v = indices[h], sum = [0, 0, 0];
    for (let k = first[v]; k < first[v + 1]; ++k) {
      const g = 3 * Math.floor(fan[k] / 3);
      if (normals[f] * normals[g] + normals[f + 1] * normals[g + 1] + normals[f + 2] * normals[g + 2] <= sharp) continue;
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

// Calls use(half-edge, the one across) for every edge that bends by more.
function creases({indices, normals, across}, use) {
  for (let h = 0; h < indices.length; ++h) {
    if (across[h] <= h) continue;
    if (dot(at(normals, Math.floor(h / 3)), at(normals, Math.floor(across[h] / 3))) <= sharp) use(h, across[h]);
  }
}

// For every group its corners, its sharp edges, its lines and its box.
function shaped(model) {
  const groups = model.groups.map(() => ({filled: 0, edges: [], lines: [], low: [9, 9, 9], high: [-9, -9, -9]}));
  for (const surface of model.surfaces) for (const owner of surface.groups) groups[owner].filled += 18;
  for (const group of groups) { group.corners = new Float32Array(group.filled); group.filled = 0; }
  for (const {points, indices, groups: owner} of model.surfaces) {
    const mesh = meshed(points, indices), all = corners(mesh);
    for (let f = 0; f < mesh.facets; ++f) {
      const group = groups[owner[f]];
      group.corners.set(all.subarray(18 * f, 18 * f + 18), group.filled);
      group.filled += 18;
      for (let k = 0; k < 9; ++k) {
        const value = points[3 * indices[3 * f + Math.floor(k / 3)] + k % 3];
        group.low[k % 3] = Math.min(group.low[k % 3], value);
        group.high[k % 3] = Math.max(group.high[k % 3], value);
      }
    }
    creases(mesh, (h, back) => {
      for (const side of new Set([owner[Math.floor(h / 3)], owner[Math.floor(back / 3)]]))
        groups[side].edges.push(...at(points, indices[h]), ...at(points, mesh.end(h)));
    });
  }
  for (const line of model.lines) {
    for (let k = 0; k + (line.closed ? 0 : 1) < line.points; ++k)
      for (const i of [k, (k + 1) % line.points]) groups[line.group].lines.push(...line.place.subarray(3 * i, 3 * i + 3));
  }
  return groups;
}
