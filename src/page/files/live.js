// A live page: the direction follows ball, arrow, buttons and keys, and regions and areas follow it.
const shortest = (value) => String(Number(value.toPrecision(4))).replace("-", "−");

class Live {
  constructor(view, live, mesh) {
    Object.assign(this, {view, live, moving: 512, maps: new LiveMaps(view.tools, live, mesh), rays: new Rays(mesh)});
    this.find = (name) => view.figure.querySelector(name);
    this.ball = this.find("#ball");
    this.ballProgram = view.tools.program("ball");
    this.goals = [...view.figure.querySelectorAll("[data-direction]")].map((button) => ({button, direction: unit(button.dataset.direction.split(",").map(Number))}));
    // What is named on the ball: axes, and the first of the listed directions by their numbers.
    this.places = [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]], ...live.known.filter((known) => known.verdict).slice(0, 5).map((known, k) => [k + 1, known.direction])]
      .map(([textContent, place]) => ({place, axis: typeof textContent === "string", label: this.ball.appendChild(Object.assign(document.createElement("span"), {textContent}))}));
    Object.assign(view, {live: this.maps, over: (camera, picture) => this.drawBall(camera, picture), before: () => this.redraw(),
      pick: (x, y) => this.pick(x, y), grab: (x, y) => this.grab(x, y)});
    this.listen();
    this.ball.hidden = this.find(".direct").hidden = false;
    this.go(view.up, true);
  }
  async loadSphere() {
    const {gl, tools} = this.view, {size, data} = this.live.sphere ?? {size: 1};
    this.sphere = tools.texture(["RGBA8", "RGBA", "UNSIGNED_BYTE"], size, size, data ? await inflated(data) : new Uint8Array(4));
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.LINEAR);
  }
  // What the controls say; `moving` maps are smaller.
  settings(moving) {
    const [kernel, wanted, tau, thick] = ["kernel", "resolution", "tau", "thickness"].map((name) => Number(this.find("#" + name).value));
    const resolution = moving ? Math.min(wanted, this.moving) : wanted, reported = tau === this.live.tau && !kernel;
    return {tau, lateral: kernel ? 0.5 * (kernel - 1) / wanted : this.live.lateral, resolution, thickness: thick,
      reported, measured: reported && thick === this.live.thickness};
  }
  go(direction, rest) {
    this.view.aim(direction);
    this.change(rest);
    const field = this.find("#direction");
    if (document.activeElement !== field || rest) field.value = direction.map((value) => Number(value.toFixed(4)) || 0).join(", ");
    for (const goal of this.goals) goal.button.setAttribute("aria-pressed", dot(goal.direction, direction) > 1 - 1e-9);
  }
  // Something that the maps depend on has changed; while it goes on changing, they are drawn small.
  change(rest) {
    this.stale = rest ? "rest" : "move";
    this.clearPicked();
    clearTimeout(this.resting);
    if (!rest) this.resting = setTimeout(() => { this.stale = "rest"; this.view.ask(); }, 180);
    this.view.ask();
  }
  // Before every picture: the maps, where they are not those of the direction.
  redraw() {
    if (!this.stale) return;
    const {view, maps, live} = this, moving = this.stale === "move", settings = this.settings(moving), now = performance.now(), byMaps = this.find("#bymaps").checked;
    // Exact areas are known of a direction, and then of its opposite, as they were asked for.
    const found = settings.reported && !byMaps ? live.known.find((known) => 1 - Math.abs(dot(known.direction, view.direction)) < 1e-12) : null;
    view.byMaps = found !== live.known[0] || dot(found.direction, view.direction) < 0;
    if (view.byMaps) maps.draw(view.direction, settings);
    this.pace = moving && now - this.last < 300 ? 0.7 * (this.pace ?? 30) + 0.3 * (now - this.last) : null;
    // As fine as keeps up.
    if (this.pace && (this.pace < 22 && this.moving < 2048 || this.pace > 55 && this.moving > 512)) {
      this.moving *= this.pace < 22 ? 2 : 0.5;
      this.pace = null;
    }
    this.last = now;
    if (!moving || !(now - this.told < 120)) { this.tell(found, settings); this.told = now; }
    this.stale = null;
  }
  // Areas: the exact ones where the page has them, else those by maps with their error.
  tell(found, {resolution, measured}) {
    const {live, view} = this, areas = found ? [...found.areas] : this.maps.areas(), error = live.errors.find(([size]) => size === resolution);
    if (found && dot(found.direction, view.direction) < 0) [areas[0], areas[1]] = [areas[1], areas[0]];
    [...view.figure.querySelectorAll(".legend li i")].slice(0, 4).forEach((legend, k) => {
      legend.textContent = (100 * areas[k] / live.area).toFixed(2) + " %  ·  " + shortest(areas[k]) + " " + live.area_unit;
    });
    this.find("#standing").textContent = found ? "Exact areas." + (view.byMaps ? " The picture is by shadow maps." : "")
      : "Areas by shadow maps, " + (measured && error ? "± " + (100 * error[1]).toFixed(2) + " % of the surface." : "± not measured for these settings.");
    Object.assign(this, {areas, exact: Boolean(found)});
  }
  // The direction turned by a way on the screen.
  turned(x, y, angle) {
    const {direction: d, seen: {right, above}} = this.view, axis = unit(plus(scaled(right, -y), scaled(above, x))), c = Math.cos(angle);
    return unit(plus(scaled(d, c), scaled(cross(axis, d), Math.sin(angle)), scaled(axis, dot(axis, d) * (1 - c))));
  }
  listen() {
    const {view, ball} = this;
    ball.onpointerdown = ball.onpointermove = (event) => {
      if (event.type === "pointerdown") ball.setPointerCapture(event.pointerId);
      else if (!ball.hasPointerCapture(event.pointerId)) return;
      const box = ball.getBoundingClientRect(), radius = box.width / 2, {right, above, toward} = view.seen;
      let x = (event.clientX - box.left) / radius - 1, y = 1 - (event.clientY - box.top) / radius, reach = Math.max(1, Math.hypot(x, y));
      const pointed = unit(plus(scaled(right, x / reach), scaled(above, y / reach), scaled(toward, Math.sqrt(Math.max(0, 1 - x * x - y * y)))));
      // A named place nearby is met.
      const near = this.places.flatMap(({place}) => [place, scaled(place, -1)]).find((place) => dot(place, pointed) > Math.cos(0.07));
      this.go(near ?? pointed, false);
    };
    ball.onkeydown = (event) => {
      const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (way) this.go(this.turned(...way, event.shiftKey ? 0.005 : 0.05), false);
      if (way) event.preventDefault();
    };
    addEventListener("beforeprint", () => { this.go(view.up, true); view.draw(); });
    for (const {button, direction} of this.goals) button.onclick = () => this.go(direction, true);
    this.find("#direction").onchange = ({target}) => {
      const numbers = target.value.replaceAll("−", "-").split(/[\s,;]+/).filter((word) => word).map(Number);
      const good = numbers.length === 3 && numbers.every(Number.isFinite) && Math.hypot(...numbers) > 0;
      target.setAttribute("aria-invalid", !good);
      if (good) this.go(unit(numbers), true);
    };
    const label = () => [["#tau", "°"], ["#thickness", " texels"]].forEach(([name, of]) => { this.find(name + "-is").textContent = this.find(name).value + of; });
    for (const name of ["#tau", "#kernel", "#thickness", "#resolution", "#bymaps"])
      this.find(name).oninput = (event) => { label(); this.change(event.target.type !== "range"); };
    label();
  }
  // What follows a pointer that takes hold of an arrow there, by its ways in pixels.
  grab(x, y) {
    const {clip, box, toward} = this.view.seen, reach = 0.4 * Math.min(box.width, box.height);
    const held = this.view.tips.find((tip) => {
      const p = scaled(tip, 0.9), w = clip[3] * p[0] + clip[7] * p[1] + clip[11] * p[2] + clip[15], place = moved(clip, p);
      return Math.hypot(box.width * (0.5 + 0.5 * place[0] / w) - x, box.height * (0.5 - 0.5 * place[1] / w) - y) < 30;
    });
    const side = held && dot(held, toward) < 0 ? -1 : 1;
    return held && ((dx, dy) => { if (dx || dy) this.go(this.turned(side * dx, -side * dy, Math.hypot(dx, dy) / reach), false); });
  }
  // The ball in its corner of the picture, and the names on it.
  drawBall(camera, {ratio, dark}) {
    if (!this.sphere) return;
    const {gl, tools, canvas, direction} = this.view, program = this.ballProgram, box = this.ball.getBoundingClientRect(), stage = canvas.getBoundingClientRect();
    const side = Math.round(box.width * ratio);
    gl.viewport(Math.round((box.left - stage.left) * ratio), Math.round((stage.bottom - box.bottom) * ratio), side, side);
    gl.useProgram(program.program);
    for (const name of ["right", "above", "toward"]) gl.uniform3fv(program["u_" + name], camera[name]);
    gl.uniform3fv(program.u_direction, direction);
    gl.uniform3fv(program.u_plain, dark ? [0.42, 0.44, 0.48] : [0.86, 0.87, 0.89]);
    gl.uniform3fv(program.u_ink, dark ? [0.9, 0.9, 0.92] : [0.1, 0.11, 0.13]);
    gl.uniform1f(program.u_pixel, 2 / side);
    tools.bind(0, program.t_sphere, this.sphere);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    for (const {place, axis, label} of this.places) {
      const near = axis || dot(place, camera.toward) >= 0 ? place : scaled(place, -1), spread = axis ? 60 : 50;
      label.hidden = dot(near, camera.toward) < -0.05;
      Object.assign(label.style, {left: 50 + spread * dot(near, camera.right) + "%", top: 50 - spread * dot(near, camera.above) + "%"});
    }
  }
  clearPicked() {
    this.view.marks.forEach((mark) => this.view.tools.drop(mark.buffer));
    this.view.marks = [];
    this.find("#picked").textContent = "";
  }
  // The undercut at a place of the picture, and what blocks it there.
  pick(x, y) {
    const {view, rays, live} = this, {eye, right, above, toward, aspect, f, box} = view.seen, {mesh} = rays;
    this.clearPicked();
    view.ask();
    if (view.opened > 0 || view.plane) return null;
    const from = plus(scaled(eye, live.diagonal), live.centre), across = (2 * x / box.width - 1) * aspect / f, up = (1 - 2 * y / box.height) / f;
    const sight = unit(plus(scaled(right, across), scaled(above, up), scaled(toward, -1))), seen = rays.hit(from, sight, true);
    if (!seen) return null;
    const settings = this.settings(false), query = {...settings, lateral: settings.lateral * live.diagonal, direction: view.direction};
    const point = plus(from, scaled(sight, seen.way)), blockers = rays.blockers(seen.facet, point, query), bits = rays.bits(blockers);
    const draft = Math.asin(Math.max(-1, Math.min(1, dot(at(mesh.normals, seen.facet), view.direction)))) * 180 / Math.PI;
    const found = {region: ["undercut", "core", "cavity", "both"][bits], blockers, ...(bits ? {} : rays.undercutAround(seen.facet, query))};
    let text = `${["Undercut", "Core", "Cavity", "Both"][bits]} here, draft ${draft.toFixed(2).replace("-", "−")}°.`;
    if (!bits) {
      text = `Undercut of ${found.all ? "" : "more than "}${found.facets.length} facet${found.facets.length > 1 ? "s" : ""}, about ${shortest(found.area)} ${live.area_unit}, ` +
        `${shortest(found.depth)} ${live.length_unit} deep along the direction.`;
      const corners = (list) => list.flatMap((facet) => [0, 1, 2].map((i) => at(mesh.points, mesh.indices[3 * facet + i]))), lines = [], walls = [];
      for (const [name, side, hit] of [["+d", 1, blockers.plus], ["−d", -1, blockers.minus]]) {
        if (!hit) continue;
        text += ` Along ${name}, surface ${shortest(Math.max(0, hit.way))} ${live.length_unit} away blocks it.`;
        lines.push(blockers.beside ?? point, plus(blockers.beside ?? point, scaled(view.direction, side * hit.way)));
        walls.push(hit.facet);
      }
      for (const [places, kind, ink] of [[corners(found.facets), "TRIANGLES", [0.5, 0.42, 0, 0.5]], [corners(walls), "TRIANGLES", [0, 0, 0, 0.6]], [lines, "LINES", [0, 0, 0, 1]]]) {
        const numbers = places.flatMap((place) => scaled(plus(place, scaled(live.centre, -1)), 1 / live.diagonal));
        view.marks.push({buffer: view.tools.buffer(numbers, 3), kind, ink});
      }
    }
    this.find("#picked").textContent = text;
    return found;
  }
}

async function beginLive(view) {
  const live = JSON.parse(document.getElementById("live").textContent), made = new Live(view, live, await unpackedPart(live));
  await made.loadSphere();
  view.ask();
  return made;
}
