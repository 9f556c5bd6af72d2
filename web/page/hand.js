// The hand by mouse and by keys.

/** Moves the hand as the canvas is dragged or its keys pressed; the function that is returned tells its place. */
export function hands({ canvas, tip, again }, stage, loops) {
  let held = null;
  const place = () => {
    const mm = (loops.hand - loops.surface) * 1e3;
    const text = loops.hasWall ? `${Math.abs(mm).toFixed(1)} mm ${mm > 0 ? "into" : "before"} the wall` : `${mm.toFixed(1)} mm`;
    for (const [key, to] of [["aria-valuenow", mm.toFixed(1)], ["aria-valuetext", text]]) canvas.setAttribute(key, to);
  };
  const reach = (to) => {
    loops.reach(to);
    tip.hidden = loops.held;
    place();
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    reach(loops.hand);
    held = { x: event.clientX, hand: loops.hand };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => held && reach(held.hand + stage.way(event.clientX - held.x)));
  // Comes after every end of a drag, also where the pointer is taken away.
  canvas.addEventListener("lostpointercapture", () => (held = null));
  canvas.addEventListener("keydown", (event) => {
    const by = event.shiftKey ? 0.002 : 0.0005;
    const to = { ArrowRight: loops.hand + by, ArrowUp: loops.hand + by, ArrowLeft: loops.hand - by, ArrowDown: loops.hand - by, Home: loops.surface - 1, End: loops.surface + 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    reach(to);
  });
  again.addEventListener("click", () => {
    loops.letGo();
    place();
  });
  return place;
}
