// A live page: the direction follows ball, arrow, buttons and keys, and regions and areas follow it.
const shortest = (value) => String(Number(value.toPrecision(4))).replace("-", "−");
const regionNames = ["Undercut", "Core", "Cavity", "Both"];  // by accessibility bits

class Live {
  // `sphere`: texels of the map on the ball; none for a bare one.
  constructor(view, live, mesh, sphere) {
    const {tools, figure} = view, size = live.sphere?.size ?? 1, ball = byId("ball");
    // Buttons, and what is named on the ball: axes, and the first of the listed directions by their numbers.
    const directed = (elements) => [...figure.querySelectorAll(elements)]
      .map((element) => ({element, direction: unit(element.dataset.direction.split(",").map(Number))}));
    Object.assign(this, {view, live, ball, goals: directed("button[data-direction]"), places: directed("#ball span"),
      rays: new Rays(mesh), maps: new LiveMaps(tools, live, mesh), moving: 512,
      sphere: tools.texture("RGBA8", size, size, sphere ?? new Uint8Array(4))});
    Object.assign(view, {live: this.maps, before: () => this.redraw(), over: (...picture) => this.drawBall(...picture),
      pick: (x, y) => this.pick(x, y), grab: (x, y) => this.grab(x, y)});
    this.listen();
    ball.hidden = figure.querySelector(".direct").hidden = false;
    this.go(view.up, true);
  }
  // What is asked, by direction and controls: tau in degrees, edge thickness and resolution in texels, the lateral
  // tolerance in the unit frame and, as `beside`, in the part's unit. Maps are smaller while it moves.
  settings(rest) {
    const {live, view: {direction}} = this, [tau, kernel, wanted, thickness] =
      ["tau", "kernel", "resolution", "thickness"].map((name) => Number(byId(name).value));
    const lateral = kernel ? 0.5 * (kernel - 1) / wanted : live.lateral, reported = tau === live.tau && !kernel;
    return {direction, tau, thickness, lateral, beside: lateral * live.diagonal, reported,
      resolution: rest ? wanted : Math.min(wanted, this.moving), measured: reported && thickness === live.thickness};
  }
  go(direction, rest) {
    this.view.aim(direction);
    this.change(rest);
  }
  // Something that the maps depend on has changed; while it goes on changing, they are drawn small.
  change(rest) {
    this.stale = rest ? "rest" : "move";
    if (this.marked) this.mark("", []);
    clearTimeout(this.resting);
    if (!rest) this.resting = setTimeout(() => { this.stale = "rest"; this.view.ask(); }, 180);
  }
  // Before every picture: the maps, where they are not those of the direction.
  redraw() {
    if (!this.stale) return;
    const {view, live} = this, rest = this.stale === "rest", settings = this.settings(rest), now = performance.now();
    const found = settings.reported && !byId("bymaps").checked
      ? live.known.find(({direction}) => dot(direction, view.direction) > 1 - 1e-12) : null;
    view.byMaps = found !== live.known[0];
    if (view.byMaps) this.maps.draw(settings);
    // While it moves, maps as fine as keep up.
    const took = now - this.last;
    if (!rest && took < 300) this.moving = between(this.moving * (took < 14 ? 2 : took > 40 ? 0.5 : 1), 512, 2048);
    if (rest || !(now - this.shownAt < 250)) this.tell(found, settings, rest);
    Object.assign(this, {last: now, stale: ""});
  }
  // The direction, and areas: the exact ones where the page has them, else those by maps with their error.
  tell(found, settings, rest) {
    const {live, view, rays} = this, {direction} = view, field = byId("direction");
    if (document.activeElement !== field || rest)
      field.value = direction.map((value) => Number(value.toFixed(4)) || 0).join(", ");
    for (const goal of this.goals)
      goal.element.setAttribute("aria-pressed", dot(goal.direction, direction) > 1 - 1e-9);
    const settle = rest && ((facet, place) => rays.bits(rays.blockers(facet, inPart(live, place), settings)));
    const areas = found?.areas ?? this.maps.areas(settle);
    [...view.figure.querySelectorAll(".legend li i")].slice(0, 4).forEach((legend, k) => {
      legend.textContent = `${(100 * areas[k] / live.area).toFixed(2)} %  ·  ${shortest(areas[k])} ${live.area_unit}`;
    });
    const measured = live.errors.find(([size]) => settings.measured && size === settings.resolution);
    const error = measured && `± ${(100 * measured[rest ? 2 : 1]).toFixed(2)} % of the surface`;
    byId("standing").textContent = found ? "Exact areas." + (view.byMaps ? " The picture is by shadow maps." : "")
      : `Areas by shadow maps, ${error ?? "± not measured for these settings"}.`;
    Object.assign(this, {areas, exact: Boolean(found), shownAt: performance.now()});
  }
  // Turns the direction by a way on the screen.
  turn(x, y, angle) {
    const {direction, seen: {right, above}} = this.view, about = unit(plus(scaled(right, -y), scaled(above, x)));
    this.go(unit(moved(turning(about, angle), direction)), false);
  }
  listen() {
    const {view, ball, places} = this, named = places.flatMap(({direction}) => [direction, scaled(direction, -1)]);
    ball.onpointerdown = ball.onpointermove = (event) => {
      if (event.type === "pointerdown") ball.setPointerCapture(event.pointerId);
      else if (!ball.hasPointerCapture(event.pointerId)) return;
      const box = ball.getBoundingClientRect(), {right, above, toward} = view.seen;
      const x = 2 * (event.clientX - box.left) / box.width - 1, y = 1 - 2 * (event.clientY - box.top) / box.height;
      const high = scaled(toward, Math.sqrt(Math.max(0, 1 - x * x - y * y)));
      const pointed = unit(plus(scaled(right, x), scaled(above, y), high));
      // A named place nearby is met.
      this.go(named.find((place) => dot(place, pointed) > Math.cos(0.07)) ?? pointed, false);
    };
    onArrowKeys(ball, (x, y, event) => this.turn(x, y, event.shiftKey ? 0.005 : 0.05));
    addEventListener("beforeprint", () => { this.go(view.up, true); view.draw(); });
    for (const {element, direction} of this.goals) element.onclick = () => this.go(direction, true);
    byId("direction").onchange = ({target}) => {
      const numbers = target.value.replaceAll("−", "-").split(/[\s,;]+/).filter((word) => word).map(Number);
      const good = numbers.length === 3 && numbers.every(Number.isFinite) && Math.hypot(...numbers) > 0;
      target.setAttribute("aria-invalid", !good);
      if (good) this.go(unit(numbers), true);
    };
    for (const name of ["tau", "kernel", "thickness", "resolution", "bymaps"]) byId(name).oninput = ({target}) => {
      if (target.type === "range") byId(name + "-is").textContent = target.value;
      this.change(target.type !== "range");
    };
  }
  // What follows a pointer that takes hold of an arrow there, by its ways in pixels.
  grab(x, y) {
    const {view, view: {seen: {box, toward}}} = this, reach = 0.4 * Math.min(box.width, box.height);
    const held = view.tips.find((tip) => {
      const [left, top] = view.onScreen(scaled(tip, 0.9));
      return Math.hypot(left - x, top - y) < 30;
    });
    const side = held && dot(held, toward) < 0 ? -1 : 1;
    return held && ((dx, dy) => { if (dx || dy) this.turn(side * dx, -side * dy, Math.hypot(dx, dy) / reach); });
  }
  // The ball in its corner of the picture, and the names on it.
  drawBall({right, above, toward, box}, {ratio, dark}) {
    const {tools, direction} = this.view, {left, bottom, width} = this.ball.getBoundingClientRect();
    const [side, ...place] = [width, left - box.left, box.bottom - bottom].map((way) => Math.round(way * ratio));
    tools.begin({place, size: [side, side], depth: "", blend: true});
    tools.draw("ball", {u_right: right, u_above: above, u_toward: toward, u_direction: direction,
      u_plain: dark ? [0.42, 0.44, 0.48] : [0.86, 0.87, 0.89], u_ink: dark ? [0.9, 0.9, 0.92] : [0.1, 0.11, 0.13],
      u_pixel: 2 / side, t_sphere: this.sphere}, {vertices: null, count: 4}, "TRIANGLE_STRIP");
    for (const {element, direction} of this.places) {
      const isAxis = element.className === "axis", spread = isAxis ? 60 : 50;
      const near = isAxis || dot(direction, toward) >= 0 ? direction : scaled(direction, -1);
      element.hidden = dot(near, toward) < -0.05;
      element.style.left = 50 + spread * dot(near, right) + "%";
      element.style.top = 50 - spread * dot(near, above) + "%";
    }
  }
  // Says what was clicked, and marks places of the part, corners of triangles or ends of lines: [places, kind, ink].
  mark(text, marks) {
    const {view, live} = this, within = (place) => inUnit(live, place);
    for (const {buffer} of view.marks) view.tools.drop(buffer);
    view.marks = marks.map(([places, kind, ink]) =>
      ({buffer: view.tools.buffer(places.flatMap(within), [3]), kind, ink}));
    byId("picked").textContent = text;
    this.marked = text !== "";
    view.ask();
  }
  // What is at a place of the picture: of an undercut how deep it is, and what blocks it there.
  pick(x, y) {
    const {view, rays, live, rays: {mesh}} = this, {eye, way} = view.sightAt(x, y), settings = this.settings(true);
    this.mark("", []);
    const from = inPart(live, eye), seen = view.opened > 0 || view.plane ? null : rays.hit(from, way, true);
    if (!seen) return null;
    const point = plus(from, scaled(way, seen.way)), blockers = rays.blockers(seen.facet, point, settings);
    const bits = rays.bits(blockers), region = regionNames[bits];
    if (bits) {
      const draft = Math.asin(between(dot(at(mesh.normals, seen.facet), view.direction), -1, 1)) * 180 / Math.PI;
      this.mark(`${region} here, draft ${shortest(draft)}°.`, []);
      return {region, blockers};
    }
    const {facets, area, depth, all} = rays.undercutAround(seen.facet, settings), start = blockers.beside ?? point;
    const hits = [["+d", blockers.plus, 1], ["−d", blockers.minus, -1]].filter(([, hit]) => hit);
    const blocked = hits.map(([name, {way}]) =>
      ` Along ${name}, surface ${shortest(Math.max(0, way))} ${live.length_unit} away blocks it.`);
    const lines = hits.flatMap(([, {way}, side]) => [start, plus(start, scaled(view.direction, side * way))]);
    const count = `${all ? "" : "more than "}${facets.length} facet${facets.length > 1 ? "s" : ""}`;
    const deep = `${shortest(depth)} ${live.length_unit} deep along the direction.`;
    this.mark(`Undercut of ${count}, about ${shortest(area)} ${live.area_unit}, ${deep}${blocked.join("")}`,
      [[facets.flatMap(mesh.cornersOf), "TRIANGLES", [0.5, 0.42, 0, 0.5]], [lines, "LINES", [0, 0, 0, 1]],
       [hits.flatMap(([, hit]) => mesh.cornersOf(hit.facet)), "TRIANGLES", [0, 0, 0, 0.6]]]);
    return {region, blockers, facets, area, depth};
  }
}
