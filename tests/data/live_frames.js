(view) => {  // milliseconds a picture of 800 x 600 while the direction moves: plain shading, and by maps
  const live = view.director, {gl} = view, pixel = new Uint8Array(4), times = [[], []];
  view.canvas.parentElement.getBoundingClientRect = () => ({left: 0, top: 0, bottom: 600, width: 800, height: 600});
  for (let k = 0; k < 160; ++k) {
    const angle = 0.02 * k, direction = unit([Math.sin(angle), 0.4 * Math.cos(1.3 * angle), Math.cos(angle)]);
    const byMaps = k >> 3 & 1, start = performance.now();
    if (byMaps) live.go(direction, false);
    else { view.aim(direction); view.byMaps = false; }
    view.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    if (k & 7) times[byMaps].push(performance.now() - start);
  }
  clearTimeout(live.resting);
  return times.map((list) => list.sort((a, b) => a - b)[list.length >> 1]);
}
