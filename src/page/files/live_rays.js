// What stands in the way of a point, by rays through a tree of boxes over the facets, and the undercut around a point.
class Rays {
  // Coordinates are in the part's unit. The part's facets come in an order by place (mesh/place_order): four each are a
  // leaf of a full tree. A box is its least coordinates, and its greatest with the other sign.
  constructor(mesh) {
    const {points, indices, facets} = mesh, leaves = 2 ** Math.ceil(Math.log2(facets / 4 + 1));
    const boxes = new Float64Array(12 * leaves).fill(Infinity), size = Math.hypot(...minus(...boxed(points, 3)));
    for (let h = 0; h < 3 * facets; ++h) for (let i = 0; i < 3; ++i) {
      const box = 6 * (leaves - 1 + Math.floor(h / 12)) + i, value = points[3 * indices[h] + i];
      boxes[box] = Math.min(boxes[box], value);
      boxes[box + 3] = Math.min(boxes[box + 3], -value);
    }
    for (let node = leaves - 2; node >= 0; --node)
      for (let k = 0; k < 6; ++k) boxes[6 * node + k] = Math.min(boxes[12 * node + 6 + k], boxes[12 * node + 12 + k]);
    Object.assign(this, {mesh, leaves, boxes, size, stack: new Uint32Array(64)});
  }
  // The nearest facet that a ray meets beyond `from`, of those alone that face it if `facing`: {facet, way}, or null.
  hit(origin, direction, facing, from = -1e-7 * this.size) {
    const {boxes, stack, leaves, size, mesh: {points, indices, vectors, facets}} = this, slack = 1e-9 * size;
    const inverse = direction.map((d) => 1 / (d || 1e-300));
    let best = Infinity, found = -1, top = 1;
    for (stack[0] = 0; top;) {
      const node = stack[--top];
      let near = from - slack, far = best + slack;
      for (let i = 0, b = 6 * node; i < 3; ++i, ++b) {
        const low = (boxes[b] - origin[i]) * inverse[i], high = (-boxes[b + 3] - origin[i]) * inverse[i];
        near = Math.max(near, Math.min(low, high) - slack);
        far = Math.min(far, Math.max(low, high) + slack);
      }
      if (near > far || boxes[6 * node] === Infinity) continue;
      if (node < leaves - 1) { stack[top++] = 2 * node + 2; stack[top++] = 2 * node + 1; continue; }
      for (let k = 4 * (node - leaves + 1), end = Math.min(facets, k + 4); k < end; ++k) {
        const normal = at(vectors, k), along = dot(normal, direction);
        if (along === 0 || facing && along > 0) continue;
        const way = dot(normal, minus(at(points, indices[3 * k]), origin)) / along;
        let inside = way > from && way < best;  // where the ray passes all edges on one side
        for (let i = 0; i < 3 && inside; ++i) {
          const start = minus(at(points, indices[3 * k + i]), origin);
          const stop = minus(at(points, indices[3 * k + (i + 1) % 3]), origin);
          inside = dot(direction, cross(start, stop)) * along >= 0;
        }
        if (inside) { best = way; found = k; }
      }
    }
    return found < 0 ? null : {facet: found, way: best};
  }
  // What blocks a point of a facet along +d and along -d: null where nothing does, undefined where it is not asked.
  blockers(facet, point, {direction, tau, beside: reach}) {
    const normal = at(this.mesh.normals, facet), sine = dot(normal, direction), limit = Math.sin(tau * Math.PI / 180);
    const back = scaled(direction, -1);
    if (sine >= limit) return {plus: this.hit(point, direction, true)};
    if (sine <= -limit) return {minus: this.hit(point, back, true)};
    const beside = plus(point, scaled(unit(plus(normal, scaled(direction, -sine))), reach));
    return {plus: this.hit(beside, direction, false, 0), minus: this.hit(beside, back, false, 0), beside};
  }
  // As accessibility bits, as in the shaders.
  bits({plus, minus}) { return (plus === null ? 1 : 0) | (minus === null ? 2 : 0); }
  // Whether at least half of a facet is undercut, by four of its points.
  mostlyUndercut(facet, settings) {
    const sixths = this.mesh.cornersOf(facet).map((corner) => scaled(corner, 1 / 6)), third = plus(...sixths);
    const places = [scaled(third, 2), ...sixths.map((sixth) => plus(third, scaled(sixth, 3)))];
    return places.filter((place) => !this.bits(this.blockers(facet, place, settings))).length >= 2;
  }
  // The mostly undercut facets that hang together with this one, their area, and how far they reach along the
  // direction. `all` unless it took too long.
  undercutAround(facet, settings) {
    const {opposite, areas, cornersOf} = this.mesh, known = new Set([facet]), facets = [facet];
    const end = performance.now() + 80;
    for (let k = 0; k < 3 * facets.length && performance.now() < end; ++k) {
      const other = Math.floor(opposite[3 * facets[Math.floor(k / 3)] + k % 3] / 3);
      if (other < 0 || known.has(other)) continue;
      known.add(other);
      if (this.mostlyUndercut(other, settings)) facets.push(other);
    }
    const heights = facets.flatMap((f) => cornersOf(f).map((corner) => dot(corner, settings.direction)));
    heights.sort((a, b) => a - b);
    const area = facets.reduce((sum, f) => sum + areas[f], 0);
    return {facets, area, depth: heights.at(-1) - heights[0], all: performance.now() < end};
  }
}
