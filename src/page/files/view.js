// Draws the model with WebGL 2, as it is turned, opened, cut and looked through.
const still = turning([0, 0, 1], 0), uncut = [0, 0, 0, 1], edgeInk = [0.07, 0.08, 0.1];
// From the part's surface along z, a line after the other.
const arrow = [0, 0, 0.04, 0, 0, 0.18].concat(
  ...[[1, 0], [-1, 0], [0, 1], [0, -1]].map(([x, y]) => [0, 0, 0.18, 0.014 * x, 0.014 * y, 0.14]));

class View {
  constructor(figure, model, live) {
    const canvas = figure.querySelector("canvas"), tools = new Tools(canvas, live);
    const up = unit(model.direction), aside = across(up);
    // `live`: shadow maps of any direction (live_maps.js), which draw in place of the groups once it is `byMaps`.
    // `marks`: over the surface, {buffer, kind, ink}.
    Object.assign(this, {figure, model, canvas, tools, gl: tools.gl, up, aside, front: cross(up, aside),
      tags: figure.querySelector(".tags"), opened: model.opened, clear: 0, plane: "", cut: 0.5,
      live: null, byMaps: false, marks: [],
      shapes: shaped(model, tools), arrow: tools.buffer(arrow, [3]),
      shown: model.groups.map((group) => !group.hidden)});
    this.aim(up);
    this.home();
  }
  home() {
    const {model: {to_viewer: way}, up, aside, front} = this;
    this.tilt = this.pitch = Math.asin(between(dot(way, up), -1, 1));
    this.yaw = Math.atan2(dot(way, front), dot(way, aside));
    this.zoom = 1;
    this.pan = [0, 0];
    this.ask();
  }
  // The direction and its arrows, along it and against it.
  aim(direction) {
    const reach = Math.max(...this.shapes.flatMap(({box}) => box.map((p) => Math.abs(dot(direction, p)))));
    const x = across(direction), y = cross(direction, x), ways = [direction, scaled(direction, -1)];
    Object.assign(this, {direction, tips: ways.map((way) => scaled(way, reach + 0.22)),
      arrows: ways.map((way) => [...x, 0, ...y, 0, ...way, 0, ...scaled(way, reach), 1])});
    this.ask();
  }
  motion({turn, axis, point, shift}) {
    const matrix = turning(axis ?? [0, 0, 1], (turn ?? 0) * this.opened), centre = point ?? [0, 0, 0];
    const way = scaled(this.byMaps ? scaled(this.direction, dot(shift, this.up)) : shift, this.opened);
    matrix.splice(12, 3, ...scaled(minus(plus(way, centre), moved(matrix, centre)), 1 / this.model.diagonal));
    return matrix;
  }
  camera(motions, stood) {
    const {up, aside, front, pitch, yaw, tilt, pan, canvas} = this, field = 0.38, aspect = canvas.width / canvas.height;
    const level = plus(scaled(aside, Math.cos(yaw)), scaled(front, Math.sin(yaw)));
    const toward = plus(scaled(level, Math.cos(pitch)), scaled(up, Math.sin(pitch)));
    const right = plus(scaled(aside, -Math.sin(yaw)), scaled(front, Math.cos(yaw))), above = cross(toward, right);
    // How far all reaches along the axis and around it: for the height from which it is seen at first, so that turning
    // does not zoom.
    const along = Math.max(0.1, ...stood.map((p) => Math.abs(dot(p, up))));
    const around = Math.max(0.2, ...stood.map((p) => Math.hypot(...cross(p, up))));
    const high = along * Math.cos(tilt) + around * Math.abs(Math.sin(tilt)), f = 1 / Math.tan(field / 2);
    const away = (1.12 * Math.max(high, around / aspect) * f + 0.6 * around) / this.zoom;
    this.pixel = 2 * away / f / canvas.height;
    const eye = plus(scaled(right, -pan[0]), scaled(above, -pan[1]), scaled(toward, away));
    const look = new DOMMatrix([...right, 0, ...above, 0, ...toward, 0, ...eye, 1]).inverse();
    const near = Math.max(0.05 * away, away - 4), far = away + 4, depth = near - far;
    const lens = [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / depth, -1, 0, 0, 2 * far * near / depth, 0];
    return {clip: new DOMMatrix(lens).multiply(look).toFloat32Array(), eye, right, above, toward, aspect, f};
  }
  // The plane across one of the axes: what lies beyond is cut away.
  section(stood) {
    if (!this.plane) return uncut;
    const normal = this.plane === "d" ? this.direction : axis("xyz".indexOf(this.plane));
    const heights = stood.map((p) => dot(normal, p)), low = Math.min(9, ...heights), high = Math.max(-9, ...heights);
    return [...normal, low + (high - low) * this.cut];
  }
  draw() {
    this.before?.();
    const {gl, tools, canvas, model, shapes, shown} = this, box = canvas.parentElement.getBoundingClientRect();
    const ratio = Math.min(2, devicePixelRatio || 1), dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const size = [box.width, box.height].map((side) => Math.max(1, Math.round(side * ratio))), [width, height] = size;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const motions = model.groups.map((group) => this.motion(group));
    const stood = shapes.flatMap((shape, k) => shown[k] ? shape.box.map((corner) => moved(motions[k], corner)) : []);
    const camera = this.seen = {...this.camera(motions, stood), box}, opaque = 1 - this.clear;
    const {eye, toward} = camera, key = unit(plus(toward, scaled(this.up, 0.55), scaled(camera.right, -0.45)));
    const common = {u_clip: camera.clip, u_eye: eye, u_up: this.up, u_key: key, u_shine: unit(plus(key, toward)),
      u_cut: this.section(stood), u_nudge: [0, 0]};
    const partly = this.opened || this.plane || this.clear || shown.includes(false) ? " CUT" : "";
    tools.begin({size});
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const each = (act) => shapes.forEach((shape, k) => { if (shown[k]) act(shape, model.groups[k], motions[k]); });
    const surfaces = (wanted, u_alpha) => {
      const lit = {...common, u_alpha, u_lift: 0};
      if (this.byMaps) {
        this.live.surfaces(model.groups, this.opened > 0 ? motions : motions.slice(0, 1), {...lit, u_hatch: ratio},
          (group, k) => shown[k] && (partly ? group.opaque === wanted : !wanted), partly);
      } else each((shape, group, u_motion) => {
        if (group.opaque !== wanted) return;
        const u_colour = scaled(group.colour, 1 / 255), u_hatch = group.hatched ? ratio : 0;
        tools.draw("surface" + partly, {...lit, u_motion, u_colour, u_hatch}, shape.surface);
      });
    };
    const lines = (buffer, u_motion, u_ink, thick, kind = "LINES") => {
      for (let x = -thick; x <= thick; ++x) for (let y = -thick; y <= thick; ++y) {
        const uniforms = {...common, u_motion, u_ink, u_lift: 0.0015, u_nudge: [2 * x / width, 2 * y / height]};
        if (buffer.count && x * x + y * y <= thick * thick + 0.5) tools.draw("line", uniforms, buffer, kind);
      }
    };
    surfaces(true, 1);
    if (opaque < 1) {
      // The nearest surface alone shows: its depth goes first.
      gl.colorMask(false, false, false, false);
      surfaces(false, 1);
      gl.colorMask(true, true, true, true);
    }
    tools.begin({size, depth: opaque < 1 ? "LEQUAL" : "LESS", blend: opaque < 1});
    surfaces(false, opaque);
    tools.begin({size, depth: "LEQUAL", blend: true});
    shapes.forEach((shape, k) => {
      const {plain, opaque: whole} = model.groups[k], drawn = this.byMaps ? !this.opened : shown[k];
      if (drawn && !plain) lines(shape.edge, motions[k], [...edgeInk, 0.55 * (whole ? 1 : opaque)], 0);
    });
    each((shape, group, motion) =>
      lines(shape.thick, motion, [...scaled(group.colour, 1 / 255), 1], Math.round(1.5 * ratio)));
    const grey = dark ? 0.78 : 0.3;
    common.u_cut = uncut;
    for (const {buffer, kind, ink} of this.marks)
      lines(buffer, still, ink, kind === "LINES" ? Math.round(ratio) : 0, kind);
    for (const motion of this.arrows) lines(this.arrow, motion, [grey, grey, grey, 1], Math.round(ratio));
    this.over?.(camera, {ratio, dark});
    // Names of the arrows, and numbers of what tables list, on surface that faces here.
    [...this.tips.map((place) => ({place})), ...model.callouts].forEach(({place, normal}, k) => {
      const [left, top] = this.onScreen(place), tag = this.tags.children[k];
      Object.assign(tag.style, {left: left + "px", top: top + "px"});
      tag.hidden = left < 20 || top < 8 || left > box.width - 20 || top > box.height - 8
        || Boolean(normal && (this.byMaps || dot(normal, minus(eye, place)) < 0));
    });
  }
  // From the eye through a place of the picture, which is given from its upper left corner.
  sightAt(x, y) {
    const {eye, right, above, toward, aspect, f, box} = this.seen;
    const aside = scaled(right, (2 * x / box.width - 1) * aspect / f);
    return {eye, way: unit(minus(plus(aside, scaled(above, (1 - 2 * y / box.height) / f)), toward))};
  }
  // Where in the picture a point is.
  onScreen(point) {
    const {clip, box} = this.seen, [x, y] = moved(clip, point), w = dot([clip[3], clip[7], clip[11]], point) + clip[15];
    return [box.width * (0.5 + 0.5 * x / w), box.height * (0.5 - 0.5 * y / w)];
  }
  ask() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.draw(); });
  }
  turn(x, y) {
    this.yaw -= x;
    this.pitch = between(this.pitch + y, -1.55, 1.55);
    this.ask();
  }
  scale(factor) {
    this.zoom = between(this.zoom * factor, 0.3, 20);
    this.ask();
  }
}
