// The model of the page: unpacked, and shaped for drawing.
"use strict";
// Vectors and matrices, the latter a column after the other.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const plus = (...vectors) => vectors.reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
const unit = (a) => scaled(a, 1 / (Math.hypot(...a) || 1));
function times(a, b) {
  const c = new Float32Array(16);
  for (let k = 0; k < 16; ++k) for (let i = 0; i < 4; ++i) c[k] += a[k % 4 + 4 * i] * b[(k >> 2) * 4 + i];
  return c;
}
function moved(m, p) { return [0, 1, 2].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]); }

async function unpacked(model) {
  const bytes = Uint8Array.from(atob(model.data), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const data = new Uint8Array(await new Response(stream).arrayBuffer());
  let at = 0;
  const number = () => {
    for (let value = 0, scale = 1; ; scale *= 128) {
      const byte = data[at++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  };
  const difference = () => { const value = number(); return value % 2 ? -(value + 1) / 2 : value / 2; };
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
    surface.indices = new Uint32Array(3 * surface.facets);
    for (let k = 0, next = 0; k < surface.indices.length; ++k) {
      const back = number();
      surface.indices[k] = next - back;
      if (back === 0) ++next;
    }
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

// For every group its corners with normals (smooth where the surface bends by less than 30 degrees), its sharp
// edges, and its box.
function shaped(model) {
  const groups = model.groups.map(() => ({corners: [], edges: [], lines: [], low: [9, 9, 9], high: [-9, -9, -9]}));
  const sharp = Math.cos(Math.PI / 6);
  for (const {points, indices, groups: owner, corners} of model.surfaces) {
    const place = (v) => [points[3 * v], points[3 * v + 1], points[3 * v + 2]];
    const normals = [], areas = [], first = new Uint32Array(corners + 1);
    for (let f = 0; f < owner.length; ++f) {
      const [a, b, c] = [0, 1, 2].map((i) => place(indices[3 * f + i]));
      const normal = cross(plus(b, scaled(a, -1)), plus(c, scaled(a, -1)));
      areas.push(normal);
      normals.push(unit(normal));
      for (let i = 0; i < 3; ++i) ++first[indices[3 * f + i] + 1];
    }
    for (let v = 0; v < corners; ++v) first[v + 1] += first[v];
    const facets = new Uint32Array(indices.length), fill = first.slice();
    for (let k = 0; k < indices.length; ++k) facets[fill[indices[k]]++] = Math.floor(k / 3);
    const beside = new Map();
    for (let f = 0; f < owner.length; ++f) {
      const group = groups[owner[f]];
      for (let i = 0; i < 3; ++i) {
        const v = indices[3 * f + i], p = place(v);
        let sum = [0, 0, 0];
        for (let k = first[v]; k < first[v + 1]; ++k) if (dot(normals[facets[k]], normals[f]) > sharp) sum = plus(sum, areas[facets[k]]);
        group.corners.push(...p, ...unit(sum));
        for (let axis = 0; axis < 3; ++axis) {
          group.low[axis] = Math.min(group.low[axis], p[axis]);
          group.high[axis] = Math.max(group.high[axis], p[axis]);
        }
        const w = indices[3 * f + (i + 1) % 3], key = Math.min(v, w) * corners + Math.max(v, w), other = beside.get(key);
        if (other === undefined) { beside.set(key, f); continue; }
        if (dot(normals[f], normals[other]) > sharp) continue;
        for (const side of new Set([owner[f], owner[other]])) groups[side].edges.push(...p, ...place(w));
      }
    }
  }
  for (const line of model.lines) {
    for (let k = 0; k + (line.closed ? 0 : 1) < line.points; ++k)
      for (const i of [k, (k + 1) % line.points]) groups[line.group].lines.push(...line.place.subarray(3 * i, 3 * i + 3));
  }
  return groups;
}
