// The two second-depth maps of any direction, drawn by the program's own shaders, the part's surface by them, and
// areas: surface samples that are looked up in them.
const rowLength = 2048;  // of facets in a texture, as shaders/common/facets.glsl has it
const sampleRow = 1024;  // of samples
const regionBits = [1, 2, 3, 0];  // accessible along +d, -d: core, cavity, both, undercut

async function unpackedPart({data, bytes: wide, corners, facets}) {
  const bytes = await inflated(data), count = 3 * corners, whole = new Uint8Array(count * wide);
  // The first byte of all coordinates, then the second …
  for (let k = 0; k < whole.length; ++k) whole[k % count * wide + Math.floor(k / count)] = bytes[k];
  const points = Float64Array.from(wide === 8 ? new Float64Array(whole.buffer) : new Float32Array(whole.buffer));
  return meshed(points, reader(bytes, whole.length).indices(facets));
}

class LiveMaps {
  constructor(tools, live, mesh) {
    const {facets, points, indices, normals, end, opposite} = mesh;
    const places = corners(mesh, live), place = (v) => inUnit(live, at(points, v));
    const rows = Math.ceil(facets / rowLength), planes = new Float32Array(4 * rows * rowLength);
    const ends = [], sides = [];
    for (let f = 0; f < facets; ++f)
      planes.set([...at(normals, f), dot(at(normals, f), place(indices[3 * f]))], 4 * f);
    // Strips are along edges at which the solid fills more than a half space.
    eachEdge(mesh, (h, left, right) => {
      const start = place(indices[h]), stop = place(end(h)), along = minus(stop, start);
      if (dot(cross(at(normals, left), at(normals, right)), along) >= -1e-4 * Math.hypot(...along)) return;
      ends.push([...start, ...stop]);
      sides.push(left, right);
    });
    // Four corners each, as maps/contour_edge.vert has them; contour edges are picked for each direction.
    const floats = new Float32Array(32 * ends.length), numbers = new Uint32Array(floats.buffer);
    for (let k = 0; k < 4 * ends.length; ++k) {
      floats.set(ends[k >> 2], 8 * k);
      numbers.set(sides.slice(2 * (k >> 2), 2 * (k >> 2) + 2), 8 * k + 6);
    }
    Object.assign(this, {tools, gl: tools.gl, live, mesh, sides, sizes: {}, closed: !opposite.includes(-1), planes,
      half: boxed(places, 6)[1], surface: tools.buffer(places, [3, 3]), strips: tools.buffer(floats, [3, 3, -2]),
      list: new Uint32Array(3 * facets), picked: new Uint32Array(3 * sides.length),
      classes: new Uint8Array(rows * rowLength), classTexels: tools.texture("R8UI", rowLength, rows, null),
      planeTexels: tools.texture("RGBA32F", rowLength, rows, planes)});
    this.addSamples(places);
  }
  // Of equal weight, where the program has them (mold/surface_samples.cpp).
  addSamples(places) {
    const {tools, mesh: {facets, areas}, live: {samples: count}} = this, rows = Math.ceil(count / sampleRow);
    const floats = new Float32Array(4 * sampleRow * rows), numbers = new Uint32Array(floats.buffer);
    this.total = areas.reduce((sum, area) => sum + area, 0);
    for (let f = 0, k = 0, u = 0, v = 0, covered = 0; f < facets; ++f) {
      covered += areas[f] * count / this.total;
      for (; k < count && k + 0.5 < covered; ++k) {
        const [s, t] = u + v > 1 ? [1 - u, 1 - v] : [u, v];
        const shares = [1 - s - t, s, t].map((share, i) => scaled(at(places, 6 * f + 2 * i), share));
        floats.set(plus(...shares), 4 * k);
        numbers[4 * k + 3] = f;
        u = (u + 0.7548776662466927) % 1;
        v = (v + 0.5698402909980532) % 1;
      }
    }
    Object.assign(this, {floats, numbers, sampleRows: rows, verdicts: new Uint32Array(4 * sampleRow * rows),
      sampleTexels: tools.texture("RGBA32UI", sampleRow, rows, numbers),
      verdictTarget: tools.target(tools.texture("R8UI", sampleRow, rows, null, 1), 0)});
  }
  made(resolution) {
    const {gl, tools} = this, depth = gl.createRenderbuffer();
    const maps = tools.texture("R32UI", resolution, resolution, null, 2);
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, resolution, resolution);
    return {maps, targets: [0, 1].map((layer) => tools.target(maps, layer, depth))};
  }
  // Draws both (Live.settings).
  draw({direction, tau, lateral, thickness, resolution}) {
    const {gl, tools, mesh: {normals, facets}, classes} = this, limit = Math.sin(tau * Math.PI / 180);
    const {maps, targets} = this.sizes[resolution] ??= this.made(resolution);
    // Axes of the maps, twisted so that walls do not fall on whole rows of texels (mold/map_frame.cpp). The maps are as
    // wide as the part is across; edges may reach beyond it by two texels.
    const x = moved(turning(direction, 0.3217), across(direction)), y = cross(direction, x);
    const wide = 2 * Math.max(...[x, y].map((along) => dot(along.map(Math.abs), this.half)));
    const scale = (1 - 8 / resolution) / wide, texel = 1 / resolution / scale;
    for (let f = 0, k = 0; f < facets; ++f, k += 3) {
      const sine = normals[k] * direction[0] + normals[k + 1] * direction[1] + normals[k + 2] * direction[2];
      classes[f] = sine >= limit ? 0 : sine <= -limit ? 1 : 2;
    }
    gl.bindTexture(gl.TEXTURE_2D, this.classTexels);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rowLength, classes.length / rowLength, gl.RED_INTEGER, gl.UNSIGNED_BYTE,
      classes);
    // What the shaders ask about direction, facets and maps. Half a texel's diagonal is the least lateral tolerance, so
    // that the texel beside a wall is beside it, too.
    this.asked = {u_direction: direction, u_map_x: x, u_map_y: y, u_map_size: resolution,
      u_map_scale: scale, u_lateral: Math.max(lateral, 0.71 * texel), t_facet_class: this.classTexels,
      t_planes: this.planeTexels};
    for (const [layer, u_side] of [[0, 1], [1, -1]]) {
      tools.begin({target: targets[layer], size: [resolution, resolution]});
      gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
      gl.clearBufferfv(gl.DEPTH, 0, [1]);
      // Each map has the facets that face away from its light.
      const away = this.facing(scaled(direction, -u_side), 0);
      tools.draw("facet_map", {...this.asked, u_side}, this.surface, "TRIANGLES", away);
      const uniforms = {...this.asked, u_side, u_half_width: 0.5 * thickness * texel};
      if (thickness > 0) tools.draw("strip_map", uniforms, this.strips, "TRIANGLES", this.contour(1 - layer));
    }
    this.asked.t_maps = maps;
  }
  // Corners of the facets that face a point, or, where `near` is 0, a direction.
  facing([x, y, z], near) {
    const {planes, list, mesh: {facets}} = this;
    let count = 0;
    for (let f = 0; f < facets; ++f) {
      if (planes[4 * f] * x + planes[4 * f + 1] * y + planes[4 * f + 2] * z <= near * planes[4 * f + 3]) continue;
      for (let k = 3 * f; k < 3 * f + 3; ++k) list[count++] = k;
    }
    return list.subarray(0, count);
  }
  // Corners of the strips that have a facet of this class on one side alone.
  contour(away) {
    const {classes, sides, picked} = this;
    let count = 0;
    for (let k = 0; k < sides.length; k += 2) {
      if ((classes[sides[k]] === away) === (classes[sides[k + 1]] === away)) continue;
      for (const corner of [0, 1, 2, 2, 1, 3]) picked[count++] = 2 * k + corner;
    }
    return picked.subarray(0, count);
  }
  // Areas of core, cavity, both and undercut. Where the verdict on a sample depends on the texel, `settle` may give the
  // accessibility bits of its facet and place in the unit frame.
  areas(settle) {
    const {gl, tools, verdicts, floats, numbers, sampleRows, live: {samples}} = this, sums = [0, 0, 0, 0];
    tools.begin({target: this.verdictTarget, size: [sampleRow, sampleRows], depth: ""});
    tools.draw("samples", {...this.asked, t_samples: this.sampleTexels}, {vertices: null, count: 3});
    gl.readPixels(0, 0, sampleRow, sampleRows, gl.RGBA_INTEGER, gl.UNSIGNED_INT, verdicts);
    for (let k = 0; k < 4 * samples; k += 4)
      ++sums[settle && verdicts[k] > 3 ? settle(numbers[k + 3], floats.subarray(k, k + 3)) : verdicts[k] & 3];
    return regionBits.map((bits) => this.total * sums[bits] / samples);
  }
  // The part, each region that is wanted in its colour: where it stands, or all of it where the first one does. With
  // nothing in `partly` all of it is drawn, and of a closed one what faces the eye.
  surfaces(groups, motions, lit, wanted, partly) {
    const {tools, surface, closed} = this, seen = closed && !partly ? this.facing(lit.u_eye, 1) : null;
    const bits = regionBits.map((bit, k) => wanted(groups[k], k) ? 1 << bit : 0);
    const u_colours = [3, 0, 1, 2].flatMap((k) => scaled(groups[k].colour, 1 / 255));  // by accessibility bits
    (motions.length > 1 ? bits : [bits.reduce((all, bit) => all | bit)]).forEach((u_regions, k) => {
      const uniforms = {...lit, ...this.asked, u_motion: motions[k], u_regions, u_colours};
      if (u_regions) tools.draw("live_surface" + partly, uniforms, surface, "TRIANGLES", seen);
    });
  }
}
