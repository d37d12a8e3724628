// Draws the model with WebGL 2, as it is turned, opened, cut and looked through.
const still = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

class View {
  constructor(figure, model) {
    this.figure = figure;
    this.model = model;
    this.canvas = figure.querySelector("canvas");
    this.tools = new Tools(this.canvas, JSON.parse(document.getElementById("shaders").textContent), Boolean(document.getElementById("live")));
    this.gl = this.tools.gl;
    this.shapes = shaped(model);
    this.surface = this.tools.program("surface");
    this.line = this.tools.program("line");
    for (const shape of this.shapes) {
      shape.surface = this.tools.buffer(shape.corners, 6);
      shape.edge = this.tools.buffer(shape.edges, 3);
      shape.thick = this.tools.buffer(shape.lines, 3);
      shape.corners = shape.edges = shape.lines = null;
    }
    this.up = unit(model.direction);
    this.aside = unit(cross(this.up, Math.abs(this.up[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
    this.front = cross(this.up, this.aside);
    this.arrows = this.tools.buffer([], 3);
    this.live = null;  // shadow maps of any direction (live_maps.js), which draw in place of the groups once it is `byMaps`
    this.byMaps = false;
    this.marks = [];   // over the surface: {buffer, kind, ink}
    this.aim(this.up);
    this.shown = model.groups.map((group) => !group.hidden);
    this.opened = model.opened;
    this.clear = 0;
    this.plane = "";
    this.cut = 0.5;
    this.home();
  }
  corner(shape, k) { return [0, 1, 2].map((axis) => (k >> axis & 1 ? shape.high : shape.low)[axis]); }
  home() {
    this.pitch = Math.asin(Math.max(-1, Math.min(1, dot(this.model.to_viewer, this.up))));
    this.tilt = this.pitch;
    this.yaw = Math.atan2(dot(this.model.to_viewer, this.front), dot(this.model.to_viewer, this.aside));
    this.zoom = 1;
    this.pan = [0, 0];
  }
  // The direction and its arrows, along it and against it.
  aim(direction) {
    this.direction = direction;
    let reach = 0;
    for (const shape of this.shapes)
      if (shape.surface.count) for (let k = 0; k < 8; ++k) reach = Math.max(reach, Math.abs(dot(direction, this.corner(shape, k))));
    const x = unit(cross(direction, Math.abs(direction[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0])), y = cross(direction, x), lines = [];
    for (const sign of [1, -1]) {
      const along = (at, aside, front) => plus(scaled(direction, sign * (reach + at)), scaled(x, aside), scaled(y, front));
      lines.push(along(0.04, 0, 0), along(0.18, 0, 0));
      for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) lines.push(along(0.18, 0, 0), along(0.14, 0.014 * a, 0.014 * b));
    }
    this.tools.refill(this.arrows, lines.flat(), 3);
    this.tips = [1, -1].map((sign) => scaled(direction, sign * (reach + 0.22)));
    this.ask();
  }
  motion(group) {
    const angle = (group.turn || 0) * this.opened, [x, y, z] = group.axis || [0, 0, 1], c = Math.cos(angle), s = Math.sin(angle), t = 1 - c;
    const turn = [t * x * x + c, t * x * y + s * z, t * x * z - s * y, 0, t * x * y - s * z, t * y * y + c, t * y * z + s * x, 0,
      t * x * z + s * y, t * y * z - s * x, t * z * z + c, 0, 0, 0, 0, 1];
    const point = scaled(group.point || [0, 0, 0], 1 / this.model.diagonal), kept = moved(turn, point);
    const way = this.byMaps ? scaled(this.direction, dot(group.shift, this.up)) : group.shift;
    const shift = plus(scaled(way, this.opened / this.model.diagonal), point, scaled(kept, -1));
    turn.splice(12, 3, ...shift);
    return turn;
  }
  // How far everything reaches from the axis through the centre, and along it, as it stands now.
  reaches(motions) {
    let around = 0.2, along = 0.1;
    this.shapes.forEach((shape, k) => {
      if (shape.surface.count && this.shown[k]) for (let c = 0; c < 8; ++c) {
        const place = moved(motions[k], this.corner(shape, c)), height = dot(place, this.up);
        along = Math.max(along, Math.abs(height));
        around = Math.max(around, Math.sqrt(Math.max(0, dot(place, place) - height * height)));
      }
    });
    return {around, along};
  }
  camera(motions) {
    const field = 0.38, aspect = this.canvas.width / this.canvas.height;
    const toward = plus(scaled(this.aside, Math.cos(this.pitch) * Math.cos(this.yaw)), scaled(this.front, Math.cos(this.pitch) * Math.sin(this.yaw)),
      scaled(this.up, Math.sin(this.pitch)));
    const right = plus(scaled(this.aside, -Math.sin(this.yaw)), scaled(this.front, Math.cos(this.yaw))), above = cross(toward, right);
    // For the height from which it is seen at first, so that turning does not zoom.
    const {around, along} = this.reaches(motions), high = along * Math.cos(this.tilt) + around * Math.abs(Math.sin(this.tilt));
    const away = (1.12 * Math.max(high, around / aspect) / Math.tan(field / 2) + 0.6 * around) / this.zoom;
    this.pixel = 2 * away * Math.tan(field / 2) / this.canvas.height;
    const target = plus(scaled(right, -this.pan[0]), scaled(above, -this.pan[1])), eye = plus(target, scaled(toward, away));
    const look = [0, 1, 2].flatMap((k) => [right[k], above[k], toward[k], 0]).concat([-dot(right, eye), -dot(above, eye), -dot(toward, eye), 1]);
    const near = Math.max(0.05 * away, away - 4), far = away + 4, f = 1 / Math.tan(field / 2);
    const clip = times([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0], look);
    return {clip, eye, right, above, toward, aspect, f};
  }
  // The plane across one of the axes: what lies beyond is cut away.
  section(motions) {
    if (!this.plane) return [0, 0, 0, 1];
    const normal = this.plane === "d" ? this.direction : ["x", "y", "z"].map((axis) => axis === this.plane ? 1 : 0);
    let low = 9, high = -9;
    this.shapes.forEach((shape, k) => {
      if (shape.surface.count && this.shown[k]) for (let c = 0; c < 8; ++c) {
        const at = dot(normal, moved(motions[k], this.corner(shape, c)));
        low = Math.min(low, at);
        high = Math.max(high, at);
      }
    });
    return [...normal, low + (high - low) * this.cut];
  }
  draw() {
    this.before?.();
    const gl = this.gl, {canvas, model} = this, box = canvas.parentElement.getBoundingClientRect(), ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(box.width * ratio)), height = Math.max(1, Math.round(box.height * ratio));
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    const motions = model.groups.map((group) => this.motion(group)), camera = this.camera(motions), cut = this.section(motions);
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.depthMask(true);
    gl.colorMask(true, true, true, true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const each = (act) => this.shapes.forEach((shape, k) => { if (this.shown[k]) act(shape, model.groups[k], motions[k]); });
    const take = (program, motion) => {
      gl.uniformMatrix4fv(program.u_clip, false, camera.clip);
      gl.uniformMatrix4fv(program.u_motion, false, motion);
      gl.uniform4fv(program.u_cut, cut);
      gl.uniform3fv(program.u_eye, camera.eye);
    };
    const lit = (program, alpha, motion) => {
      take(program, motion);
      gl.uniform3fv(program.u_up, this.up);
      gl.uniform1f(program.u_alpha, alpha);
      gl.uniform1f(program.u_lift, 0);
    };
    const surfaces = (wanted, alpha) => {
      if (this.byMaps) {
        const all = this.shown.every((shown) => shown), whole = Boolean(this.opened || this.plane || this.clear || !all);
        this.live.surfaces(model.groups, motions, (k) => this.shown[k] && (whole ? model.groups[k].opaque === wanted : !wanted), {ratio, eye: camera.eye, whole},
          (program, motion) => lit(program, alpha, motion));
        return;
      }
      gl.useProgram(this.surface.program);
      each((shape, group, motion) => {
        if (group.opaque !== wanted || !shape.surface.count) return;
        lit(this.surface, alpha, motion);
        gl.uniform3fv(this.surface.u_colour, scaled(group.colour, 1 / 255));
        gl.uniform1f(this.surface.u_hatch, group.hatched ? ratio : 0);
        gl.bindVertexArray(shape.surface.vertices);
        gl.drawArrays(gl.TRIANGLES, 0, shape.surface.count);
      });
    };
    const lines = (buffer, motion, ink, thick, kind = gl.LINES) => {
      if (!buffer.count) return;
      gl.useProgram(this.line.program);
      take(this.line, motion);
      gl.uniform4fv(this.line.u_ink, ink);
      gl.uniform1f(this.line.u_lift, 0.0015);
      gl.bindVertexArray(buffer.vertices);
      for (let x = -thick; x <= thick; ++x) for (let y = -thick; y <= thick; ++y) {
        if (x * x + y * y > thick * thick + 0.5) continue;
        gl.uniform2f(this.line.u_nudge, 2 * x / width, 2 * y / height);
        gl.drawArrays(kind, 0, buffer.count);
      }
    };
    surfaces(true, 1);
    const alpha = 1 - this.clear;
    if (alpha < 1) {
      // The nearest surface alone shows: its depth goes first.
      gl.colorMask(false, false, false, false);
      surfaces(false, 1);
      gl.colorMask(true, true, true, true);
      gl.enable(gl.BLEND);
      gl.depthFunc(gl.LEQUAL);
    }
    surfaces(false, alpha);
    gl.depthFunc(gl.LEQUAL);
    gl.enable(gl.BLEND);
    if (this.byMaps) lines(this.opened > 0 ? {} : this.live.edges, still, [0.07, 0.08, 0.1, 0.55 * alpha], 0);
    else each((shape, group, motion) => group.plain || lines(shape.edge, motion, [0.07, 0.08, 0.1, 0.55 * (group.opaque ? 1 : alpha)], 0));
    each((shape, group, motion) => lines(shape.thick, motion, [...scaled(group.colour, 1 / 255), 1], Math.round(1.5 * ratio)));
    const grey = dark ? 0.78 : 0.3;
    cut.splice(0, 4, 0, 0, 0, 1);
    for (const {buffer, kind, ink} of this.marks) lines(buffer, still, ink, kind === "LINES" ? Math.round(ratio) : 0, gl[kind]);
    lines(this.arrows, still, [grey, grey, grey, 1], Math.round(ratio));
    gl.disable(gl.DEPTH_TEST);
    this.over?.(camera, {width, height, ratio, dark});
    gl.disable(gl.BLEND);
    gl.depthFunc(gl.LESS);
    this.place(camera, box);
  }
  // The words at the arrows' ends.
  place(camera, box) {
    const tags = this.figure.querySelector(".tags");
    while (tags.children.length < 2) tags.append(Object.assign(document.createElement("span"), {textContent: tags.children.length ? "−d · cavity" : "+d · core"}));
    this.tips.forEach((tip, k) => {
      const m = camera.clip, w = m[3] * tip[0] + m[7] * tip[1] + m[11] * tip[2] + m[15], [x, y] = moved(m, tip);
      const left = box.width * (0.5 + 0.5 * x / w), top = box.height * (0.5 - 0.5 * y / w);
      Object.assign(tags.children[k].style, {left: left + "px", top: top + "px"});
      tags.children[k].hidden = left < 20 || top < 8 || left > box.width - 20 || top > box.height - 8;
    });
    this.seen = {...camera, box};
  }
  ask() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.draw(); });
  }
  turn(x, y) {
    this.yaw -= x;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + y));
    this.ask();
  }
  scale(factor) {
    this.zoom = Math.max(0.3, Math.min(20, this.zoom * factor));
    this.ask();
  }
}
