// What stands in the way of a point, by rays through a tree of boxes over the facets, and the undercut around a point.
class Rays {
  // Coordinates are in the part's unit. Facets lie in the order of their first corners along a curve that fills space
  // (Morton), four a leaf of a full tree. A box is its least coordinates, and its greatest with the other sign.
  constructor(mesh) {
    const {points, indices, facets} = mesh, [low, high] = boxed(points, 3), codes = new Float64Array(facets);
    const spread = (v) => [[16, 0x030000ff], [8, 0x0300f00f], [4, 0x030c30c3], [2, 0x09249249]]
      .reduce((bits, [shift, mask]) => (bits | bits << shift) & mask, v);
    for (let f = 0; f < facets; ++f) {
      const steps = at(points, indices[3 * f]).map((value, k) => 1023 * (value - low[k]) / (high[k] - low[k] || 1));
      const [x, y, z] = steps.map(spread);
      codes[f] = (x + 2 * y + 4 * z) * 0x100000 + f;
    }
    const order = Uint32Array.from(codes.sort(), (code) => code % 0x100000);
    const leaves = 2 ** Math.ceil(Math.log2(facets / 4 + 1)), size = Math.hypot(...plus(high, scaled(low, -1)));
    const boxes = new Float64Array(12 * leaves).fill(Infinity);
    for (let k = 0; k < facets; ++k) for (let i = 0; i < 9; ++i) {
      const box = 6 * (leaves - 1 + (k >> 2)) + i % 3, corner = indices[3 * order[k] + Math.floor(i / 3)];
      const value = points[3 * corner + i % 3];
      boxes[box] = Math.min(boxes[box], value);
      boxes[box + 3] = Math.min(boxes[box + 3], -value);
    }
    for (let node = leaves - 2; node >= 0; --node)
      for (let k = 0; k < 6; ++k) boxes[6 * node + k] = Math.min(boxes[12 * node + 6 + k], boxes[12 * node + 12 + k]);
    Object.assign(this, {mesh, order, leaves, boxes, size, stack: new Uint32Array(64)});
  }
  // The nearest facet that a ray meets beyond `from`, of those alone that face it if `facing`: {facet, way}, or null.
  hit(origin, direction, facing, from = -1e-7 * this.size) {
    const {boxes, stack, leaves, order, size, mesh: {points, indices, vectors, facets}} = this, [ox, oy, oz] = origin;
    const [dx, dy, dz] = direction, [ix, iy, iz] = direction.map((d) => 1 / (d || 1e-300)), slack = 1e-9 * size;
    let best = Infinity, found = -1, top = 1;
    for (stack[0] = 0; top;) {
      const node = stack[--top], b = 6 * node;
      const ax = (boxes[b] - ox) * ix, ay = (boxes[b + 1] - oy) * iy, az = (boxes[b + 2] - oz) * iz;
      const bx = (-boxes[b + 3] - ox) * ix, by = (-boxes[b + 4] - oy) * iy, bz = (-boxes[b + 5] - oz) * iz;
      const near = Math.max(Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz)) - slack;
      const far = Math.min(Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz)) + slack;
      if (near > far || far < from || near > best || boxes[b] === Infinity) continue;
      if (node < leaves - 1) { stack[top++] = 2 * node + 2; stack[top++] = 2 * node + 1; continue; }
      for (let k = 4 * (node - leaves + 1), end = Math.min(facets, k + 4); k < end; ++k) {
        const f = 3 * order[k], nx = vectors[f], ny = vectors[f + 1], nz = vectors[f + 2], a = 3 * indices[f];
        const along = nx * dx + ny * dy + nz * dz;
        if (along === 0 || facing && along > 0) continue;
        const way = (nx * (points[a] - ox) + ny * (points[a + 1] - oy) + nz * (points[a + 2] - oz)) / along;
        let inside = way > from && way < best;  // where the ray passes all edges on one side
        for (let i = 0; i < 3 && inside; ++i) {
          const p = 3 * indices[f + i], q = 3 * indices[f + (i + 1) % 3];
          const px = points[p] - ox, py = points[p + 1] - oy, pz = points[p + 2] - oz;
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
    const normal = at(this.mesh.normals, facet), sine = dot(normal, direction), limit = Math.sin(tau * Math.PI / 180);
    const back = scaled(direction, -1);
    if (sine >= limit) return {plus: this.hit(point, direction, true)};
    if (sine <= -limit) return {minus: this.hit(point, back, true)};
    const beside = plus(point, scaled(unit(plus(normal, scaled(direction, -sine))), lateral));
    return {plus: this.hit(beside, direction, false, 0), minus: this.hit(beside, back, false, 0), beside};
  }
  // As accessibility bits, as in the shaders.
  bits({plus, minus}) { return (plus === null ? 1 : 0) | (minus === null ? 2 : 0); }
  // Whether at least half of a facet is undercut, by four of its points.
  mostlyUndercut(facet, query) {
    const sixths = this.mesh.cornersOf(facet).map((corner) => scaled(corner, 1 / 6)), third = plus(...sixths);
    const places = [scaled(third, 2), ...sixths.map((sixth) => plus(third, scaled(sixth, 3)))];
    return places.filter((place) => !this.bits(this.blockers(facet, place, query))).length >= 2;
  }
  // The mostly undercut facets that hang together with this one, their area, and how far they reach along the
  // direction. `all` unless it took too long.
  undercutAround(facet, query) {
    const {across, vectors, cornersOf} = this.mesh, known = new Set([facet]), facets = [facet];
    const end = performance.now() + 80;
    for (let k = 0; k < 3 * facets.length && performance.now() < end; ++k) {
      const other = Math.floor(across[3 * facets[Math.floor(k / 3)] + k % 3] / 3);
      if (other < 0 || known.has(other)) continue;
      known.add(other);
      if (this.mostlyUndercut(other, query)) facets.push(other);
    }
    let low = Infinity, high = -Infinity, area = 0;
    for (const f of facets) {
      const heights = cornersOf(f).map((corner) => dot(corner, query.direction));
      low = Math.min(low, ...heights);
      high = Math.max(high, ...heights);
      area += 0.5 * Math.hypot(...at(vectors, f));
    }
    return {facets, area, depth: high - low, all: performance.now() < end};
  }
}
