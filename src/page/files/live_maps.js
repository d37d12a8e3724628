// The two second-depth maps of any direction, drawn by the program's own shaders, the part's surface by them, and areas:
// surface samples that are looked up in them.
const rowLength = 2048;  // of facets in a texture, as shaders/common/facets.glsl has it
const regionBits = [1, 2, 3, 0];  // accessible along +d, -d: core, cavity, both, undercut

// Axes of the maps, twisted so that walls do not fall on whole rows of texels (mold/map_frame.cpp).
function mapFrame(d) {
  const [x, y, z] = d.map(Math.abs), least = [0, 0, 0];
  least[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
  const aside = unit(cross(least, d)), turned = plus(scaled(aside, Math.cos(0.3217)), scaled(cross(d, aside), Math.sin(0.3217)));
  return [turned, cross(d, turned)];
}

async function unpackedPart(live) {
  const bytes = await inflated(live.data), wide = live.bytes, count = 3 * live.corners, whole = new Uint8Array(count * wide);
  // The first byte of all coordinates, then the second …
  for (let b = 0, from = 0; b < wide; ++b) for (let k = 0; k < count; ++k) whole[k * wide + b] = bytes[from++];
  const points = wide === 8 ? new Float64Array(whole.buffer) : Float64Array.from(new Float32Array(whole.buffer));
  return meshed(points, reader(bytes, count * wide).indices(live.facets));
}

class LiveMaps {
  constructor(tools, live, mesh) {
    Object.assign(this, {tools, gl: tools.gl, live, mesh, resolution: 0, corners: corners(mesh, live.centre, live.diagonal)});
    const {gl} = this, {facets, points, indices, normals, across} = mesh, rows = Math.ceil(facets / rowLength);
    const place = (v) => [0, 1, 2].map((axis) => (points[3 * v + axis] - live.centre[axis]) / live.diagonal);
    this.surface = tools.buffer(this.corners, 6);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    this.drawn = new Uint32Array(3 * facets);
    this.half = [0, 0, 0];  // the part's box, from its middle
    for (let h = 0; h < indices.length; ++h) for (let axis = 0; axis < 3; ++axis) this.half[axis] = Math.max(this.half[axis], Math.abs(this.corners[6 * h + axis]));
    this.closed = !across.includes(-1);
    this.planes = new Float32Array(4 * rows * rowLength);
    for (let f = 0; f < facets; ++f) this.planes.set([...at(normals, f), dot(at(normals, f), place(indices[3 * f]))], 4 * f);
    this.planeTexels = tools.texture(["RGBA32F", "RGBA", "FLOAT"], rowLength, rows, this.planes);
    this.classes = new Uint8Array(rows * rowLength);
    this.classTexels = tools.texture(["R8UI", "RED_INTEGER", "UNSIGNED_BYTE"], rowLength, rows, this.classes);
    // Sharp edges, which are drawn, and those at which the solid fills more than a half space, which get strips.
    const edges = [], concave = [];
    for (let h = 0; h < indices.length; ++h) {
      if (across[h] <= h) continue;
      const left = Math.floor(h / 3), right = Math.floor(across[h] / 3), a = at(normals, left), b = at(normals, right);
      const along = plus(at(points, mesh.end(h)), scaled(at(points, indices[h]), -1));
      if (dot(a, b) <= sharp) edges.push(...place(indices[h]), ...place(mesh.end(h)));
      if (dot(cross(a, b), along) < -1e-4 * Math.hypot(...along)) concave.push({ends: [...place(indices[h]), ...place(mesh.end(h))], sides: [left, right]});
    }
    this.edges = tools.buffer(edges, 3);
    this.addStrips(concave);
    this.addSamples();
    this.programs = Object.fromEntries(["facet_map", "strip_map", "counts", "live_surface"].map((name) => [name, tools.program(name)]));
  }
  // Four corners each, as maps/contour_edge.vert has them; those that are contour edges are picked for each direction.
  addStrips(concave) {
    const {gl} = this, floats = new Float32Array(32 * concave.length), numbers = new Uint32Array(floats.buffer);
    concave.forEach(({ends, sides}, k) => {
      for (let corner = 32 * k; corner < 32 * k + 32; corner += 8) { floats.set(ends, corner); numbers.set(sides, corner + 6); }
    });
    this.sides = Uint32Array.from(concave.flatMap(({sides}) => sides));
    this.picked = new Uint32Array(6 * concave.length);
    this.strips = gl.createVertexArray();
    gl.bindVertexArray(this.strips);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, floats, gl.STATIC_DRAW);
    for (const k of [0, 1, 2]) gl.enableVertexAttribArray(k);
    for (const k of [0, 1]) gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 32, 12 * k);
    gl.vertexAttribIPointer(2, 2, gl.UNSIGNED_INT, 32, 24);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bindVertexArray(null);
  }
  // Of equal weight, where the program has them (mold/surface_samples.cpp).
  addSamples() {
    const {live, mesh, tools, corners, blocks = this.blocks = 512} = this, count = live.samples, side = 1024, format = ["RGBA32UI", "RGBA_INTEGER", "UNSIGNED_INT"];
    const floats = new Float32Array(4 * side * Math.ceil(count / side)), numbers = new Uint32Array(floats.buffer);
    const area = (f) => 0.5 * Math.sqrt(mesh.vectors[3 * f] ** 2 + mesh.vectors[3 * f + 1] ** 2 + mesh.vectors[3 * f + 2] ** 2);
    this.total = 0;
    for (let f = 0; f < mesh.facets; ++f) this.total += area(f);
    for (let f = 0, k = 0, u = 0, v = 0, covered = 0; f < mesh.facets; ++f) {
      covered += area(f) * count / this.total;
      for (; k < count && k + 0.5 < covered; ++k, u = (u + 0.7548776662466927) % 1, v = (v + 0.5698402909980532) % 1) {
        const [s, t] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
        for (let axis = 0, a = 18 * f; axis < 3; ++axis, ++a) floats[4 * k + axis] = corners[a] + s * (corners[a + 6] - corners[a]) + t * (corners[a + 12] - corners[a]);
        numbers[4 * k + 3] = f;
      }
    }
    this.samples = tools.texture(format, side, floats.length / 4 / side, numbers);
    this.counts = tools.target(tools.texture(format, blocks, 1, null));
    this.read = new Uint32Array(4 * blocks);
  }
  allocate(resolution) {
    const {gl, tools} = this;
    gl.deleteTexture(this.maps ?? null);
    gl.deleteRenderbuffer(this.depth ?? null);
    this.targets?.forEach((target) => gl.deleteFramebuffer(target));
    this.maps = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.maps);
    gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.R32UI, resolution, resolution, 2);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D_ARRAY, filter, gl.NEAREST);
    this.depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, resolution, resolution);
    this.targets = [0, 1].map((layer) => tools.target(this.maps, layer, this.depth));
    this.resolution = resolution;
  }
  // What the shaders ask about direction, facets and maps; the maps themselves only where they are not drawn.
  take(program, maps) {
    const {gl, tools} = this, [x, y] = this.frame;
    gl.useProgram(program.program);
    gl.uniform3fv(program.u_direction, this.direction);
    gl.uniform3fv(program.u_map_x, x);
    gl.uniform3fv(program.u_map_y, y);
    gl.uniform1f(program.u_map_size, this.resolution);
    gl.uniform1f(program.u_map_scale, this.scale);
    gl.uniform1f(program.u_lateral, this.lateral);
    tools.bind(0, program.t_facet_class, this.classTexels);
    tools.bind(1, program.t_planes, this.planeTexels);
    if (maps) tools.bind(2, program.t_maps, this.maps, gl.TEXTURE_2D_ARRAY);
  }
  // Draws both. Of settings: tau in degrees, lateral tolerance in the unit frame, edge thickness and resolution in texels.
  draw(direction, {tau, lateral, thickness, resolution}) {
    const {gl, mesh, programs, classes} = this, {normals, facets} = mesh, limit = Math.sin(tau * Math.PI / 180), [dx, dy, dz] = direction;
    this.direction = direction;
    this.frame = mapFrame(direction);
    // The maps are as wide as the part is across; edges may reach beyond it by two texels.
    const across = this.frame.map((axis) => dot(axis.map(Math.abs), this.half));
    this.scale = (1 - 8 / resolution) / (2 * Math.max(...across));
    // Half a texel's diagonal at least, so that the texel beside a wall is beside it, too.
    this.lateral = Math.max(lateral, 0.71 / resolution / this.scale);
    if (resolution !== this.resolution) this.allocate(resolution);
    for (let f = 0; f < facets; ++f) {
      const sine = normals[3 * f] * dx + normals[3 * f + 1] * dy + normals[3 * f + 2] * dz;
      classes[f] = sine >= limit ? 0 : sine <= -limit ? 1 : 2;
    }
    gl.bindTexture(gl.TEXTURE_2D, this.classTexels);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rowLength, classes.length / rowLength, gl.RED_INTEGER, gl.UNSIGNED_BYTE, classes);
    gl.viewport(0, 0, resolution, resolution);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    for (const [layer, side] of [[0, 1], [1, -1]]) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.targets[layer]);
      gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
      gl.clearBufferfv(gl.DEPTH, 0, [1]);
      gl.enable(gl.CULL_FACE);
      gl.cullFace(side > 0 ? gl.FRONT : gl.BACK);
      this.take(programs.facet_map, false);
      gl.uniform1f(programs.facet_map.u_side, side);
      gl.bindVertexArray(this.surface.vertices);
      gl.drawArrays(gl.TRIANGLES, 0, this.surface.count);
      gl.disable(gl.CULL_FACE);
      if (thickness > 0) this.drawStrips(side, 0.5 * thickness / resolution / this.scale);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
  drawStrips(side, half) {
    const {gl, classes, sides, picked, programs} = this, away = side > 0 ? 1 : 0;
    let count = 0;
    for (let k = 0; k < sides.length / 2; ++k) {
      if ((classes[sides[2 * k]] === away) === (classes[sides[2 * k + 1]] === away)) continue;
      for (const corner of [0, 1, 2, 2, 1, 3]) picked[count++] = 4 * k + corner;
    }
    if (!count) return;
    this.take(programs.strip_map, false);
    gl.uniform1f(programs.strip_map.u_side, side);
    gl.uniform1f(programs.strip_map.u_half_width, half);
    gl.bindVertexArray(this.strips);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, picked.subarray(0, count), gl.DYNAMIC_DRAW);
    gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
  }
  // Areas of core, cavity, both and undercut.
  areas() {
    const {gl, tools, programs, blocks, read, live} = this;
    this.take(programs.counts, true);
    tools.bind(3, programs.counts.t_samples, this.samples);
    gl.uniform1i(programs.counts.u_samples, live.samples);
    gl.uniform1i(programs.counts.u_block, Math.ceil(live.samples / blocks));
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.counts);
    gl.viewport(0, 0, blocks, 1);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.readPixels(0, 0, blocks, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, read);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const sums = [0, 0, 0, 0];
    read.forEach((count, k) => { sums[k % 4] += count; });
    return regionBits.map((bits) => this.total * sums[bits] / live.samples);
  }
  // Facets from near to far, so that what is hidden is not shaded; without those that face away, where none can be seen.
  sort(eye, whole) {
    const key = [...eye, whole].join(), {gl, planes, corners, drawn, mesh: {facets}} = this, steps = 1024, first = new Uint32Array(steps + 2), at = new Int16Array(facets);
    if (key === this.sorted) return;
    this.sorted = key;
    const [ex, ey, ez] = eye, near = Math.hypot(ex, ey, ez) - 0.55;
    for (let f = 0; f < facets; ++f) {
      const x = corners[18 * f] - ex, y = corners[18 * f + 1] - ey, z = corners[18 * f + 2] - ez;
      const seen = whole || planes[4 * f] * ex + planes[4 * f + 1] * ey + planes[4 * f + 2] * ez > planes[4 * f + 3];
      at[f] = seen ? Math.max(0, Math.min(steps - 1, (Math.sqrt(x * x + y * y + z * z) - near) / 1.1 * steps)) : steps;
      ++first[at[f] + 1];
    }
    for (let k = 0; k < steps; ++k) first[k + 1] += first[k];
    this.seen = 3 * first[steps];
    for (let f = 0; f < facets; ++f) for (let i = 0, k = 3 * first[at[f]]++; at[f] < steps && i < 3; ++i) drawn[k + i] = 3 * f + i;
    gl.bindVertexArray(this.surface.vertices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, drawn.subarray(0, this.seen), gl.DYNAMIC_DRAW);
  }
  // The part, each region in its colour and where it stands; regions that move alike at once.
  surfaces(groups, motions, wanted, {ratio, eye, whole}, lit) {
    const {gl} = this, program = this.programs.live_surface, passes = new Map();
    groups.forEach((group, k) => {
      if (!wanted(k)) return;
      const key = motions[k].join(), pass = passes.get(key) ?? {motion: motions[k], regions: 0};
      pass.regions |= 1 << regionBits[k];
      passes.set(key, pass);
    });
    if (!passes.size) return;
    this.sort(eye, whole || !this.closed);
    this.take(program, true);
    const colours = [0, 0, 0, 0];
    groups.forEach((group, k) => { colours[regionBits[k]] = scaled(group.colour, 1 / 255); });
    gl.uniform3fv(program.u_colours, colours.flat());
    gl.uniform1f(program.u_hatch, ratio);
    gl.bindVertexArray(this.surface.vertices);
    for (const {motion, regions} of passes.values()) {
      lit(program, motion);
      gl.uniform1ui(program.u_regions, regions);
      gl.drawElements(gl.TRIANGLES, this.seen, gl.UNSIGNED_INT, 0);
    }
  }
}
