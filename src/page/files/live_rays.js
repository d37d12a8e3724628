// What stands in the way of a point, by rays through a tree of boxes over the facets, and the undercut around a point.
class Rays {
  // Coordinates are in the part's unit. Facets lie in the order of their centres along a curve that fills space (Morton),
  // four a leaf of a full tree.
  constructor(mesh) {
    const {points, indices, facets} = mesh, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < points.length; ++k) {
      low[k % 3] = Math.min(low[k % 3], points[k]);
      high[k % 3] = Math.max(high[k % 3], points[k]);
    }
    const spread = (v) => {
      v = (v | v << 16) & 0x030000ff; v = (v | v << 8) & 0x0300f00f; v = (v | v << 4) & 0x030c30c3;
      return (v | v << 2) & 0x09249249;
    };
    const codes = new Float64Array(facets), scale = low.map((least, axis) => 1023 / (3 * (high[axis] - least) || 1));
    const place = (f, axis) => points[3 * indices[3 * f] + axis] + points[3 * indices[3 * f + 1] + axis] + points[3 * indices[3 * f + 2] + axis] - 3 * low[axis];
    for (let f = 0; f < facets; ++f)
      codes[f] = (spread(place(f, 0) * scale[0]) + 2 * spread(place(f, 1) * scale[1]) + 4 * spread(place(f, 2) * scale[2])) * 0x100000 + f;
    const order = Uint32Array.from(codes.sort(), (code) => code % 0x100000);
    let leaves = 1;
    while (4 * leaves < facets) leaves *= 2;
    const boxes = new Float64Array(12 * leaves);
    for (let node = 2 * leaves - 2; node >= 0; --node) {
      const box = 6 * node, first = 4 * (node - leaves + 1);
      boxes.fill(Infinity, box, box + 3).fill(-Infinity, box + 3, box + 6);
      const add = (axis, least, most) => {
        boxes[box + axis] = Math.min(boxes[box + axis], least);
        boxes[box + 3 + axis] = Math.max(boxes[box + 3 + axis], most);
      };
      for (let axis = 0; axis < 3; ++axis) {
        if (first < 0) for (const child of [12 * node + 6, 12 * node + 12]) add(axis, boxes[child + axis], boxes[child + 3 + axis]);
        for (let k = first; k >= 0 && k < Math.min(facets, first + 4); ++k)
          for (let h = 3 * order[k]; h < 3 * order[k] + 3; ++h) add(axis, points[3 * indices[h] + axis], points[3 * indices[h] + axis]);
      }
    }
    Object.assign(this, {mesh, order, leaves, boxes, stack: new Uint32Array(64), size: Math.hypot(...high.map((most, axis) => most - low[axis]))});
  }
  // The nearest facet that a ray meets beyond `from`, of those alone that face it if `facing`: {facet, way}, or null.
  hit(origin, direction, facing, from = -1e-7 * this.size) {
    const {boxes, stack, leaves, order, size, mesh: {points, indices, vectors, facets}} = this, [ox, oy, oz] = origin, [dx, dy, dz] = direction;
    const [ix, iy, iz] = direction.map((d) => 1 / (d || 1e-300)), slack = 1e-9 * size;
    let best = Infinity, found = -1, top = 1;
    for (stack[0] = 0; top;) {
      const node = stack[--top], b = 6 * node;
      const ax = (boxes[b] - ox) * ix, bx = (boxes[b + 3] - ox) * ix, ay = (boxes[b + 1] - oy) * iy, by = (boxes[b + 4] - oy) * iy;
      const az = (boxes[b + 2] - oz) * iz, bz = (boxes[b + 5] - oz) * iz;
      const near = Math.max(Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz)), far = Math.min(Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz)) + slack;
      if (near - slack > far || far < from || near - slack > best || boxes[b] > boxes[b + 3]) continue;
      if (node < leaves - 1) { stack[top++] = 2 * node + 2; stack[top++] = 2 * node + 1; continue; }
      for (let k = 4 * (node - leaves + 1), end = Math.min(facets, k + 4); k < end; ++k) {
        const f = 3 * order[k], nx = vectors[f], ny = vectors[f + 1], nz = vectors[f + 2], along = nx * dx + ny * dy + nz * dz, a = 3 * indices[f];
        if (along === 0 || facing && along > 0) continue;
        const way = (nx * (points[a] - ox) + ny * (points[a + 1] - oy) + nz * (points[a + 2] - oz)) / along;
        let inside = way > from && way < best;  // where the ray passes all edges on one side
        for (let i = 0; i < 3 && inside; ++i) {
          const p = 3 * indices[f + i], q = 3 * indices[f + (i + 1) % 3], px = points[p] - ox, py = points[p + 1] - oy, pz = points[p + 2] - oz;
          const qx = points[q] - ox, qy = points[q + 1] - oy, qz = points[q + 2] - oz;
          inside = (dx * (py * qz - pz * qy) + dy * (pz * qx - px * qz) + dz * (px * qy - py * qx)) * along >= 0;
        }
        if (inside) { best = way; found = order[k]; }
      }
    }
    return found < 0 ? null : {facet: found, way: best};
  }
  // What blocks a point of a facet along +d and along -d: null where nothing does, undefined where it is not asked.
  blockers(facet, point, {direction, tau, lateral}) {
    const normal = at(this.mesh.normals, facet), sine = dot(normal, direction), limit = Math.sin(tau * Math.PI / 180), back = scaled(direction, -1);
    if (sine >= limit) return {plus: this.hit(point, direction, true)};
    if (sine <= -limit) return {minus: this.hit(point, back, true)};
    const beside = plus(point, scaled(unit(plus(normal, scaled(direction, -sine))), lateral));
    return {plus: this.hit(beside, direction, false, 0), minus: this.hit(beside, back, false, 0), beside};
  }
  // As accessibility bits, as in the shaders.
  bits({plus, minus}) { return (plus === null ? 1 : 0) | (minus === null ? 2 : 0); }
  // Whether at least half of a facet is undercut, by four of its points.
  mostlyUndercut(facet, query) {
    const [a, b, c] = [0, 1, 2].map((i) => scaled(at(this.mesh.points, this.mesh.indices[3 * facet + i]), 1 / 6)), third = plus(a, b, c);
    return [third, a, b, c].filter((more) => this.bits(this.blockers(facet, plus(third, more === third ? third : scaled(more, 3)), query)) === 0).length >= 2;
  }
  // The mostly undercut facets that hang together with this one, their area, and how far they reach along the direction.
  // `all` unless it took too long.
  undercutAround(facet, query) {
    const {across, vectors, points, indices} = this.mesh, known = new Set([facet]), list = [facet], end = performance.now() + 80;
    for (let k = 0; k < list.length && performance.now() < end; ++k) for (let h = 3 * list[k]; h < 3 * list[k] + 3; ++h) {
      const other = Math.floor(across[h] / 3);
      if (other < 0 || known.has(other)) continue;
      known.add(other);
      if (this.mostlyUndercut(other, query)) list.push(other);
    }
    const area = list.reduce((sum, f) => sum + 0.5 * Math.hypot(...at(vectors, f)), 0);
    const heights = list.flatMap((f) => [0, 1, 2].map((i) => dot(at(points, indices[3 * f + i]), query.direction)));
    const [low, high] = heights.reduce(([least, most], height) => [Math.min(least, height), Math.max(most, height)], [Infinity, -Infinity]);
    return {facets: list, area, depth: high - low, all: performance.now() < end};
  }
}
