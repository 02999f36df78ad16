/* The dependency graph: zoom, drag, filter, find, and the arrows of one item alone. Moving is scrolling, so fingers
   and arrow keys do it by themselves. Without this script the drawing is there, with its links. */
(() => {
  "use strict";
  const graph = document.querySelector("svg.lg-graph");
  const box = graph?.parentElement;
  const form = document.querySelector(".lg-graph-controls");
  if (!form || !box) return;
  const nodes = [...graph.querySelectorAll(".lg-node")];
  const edges = [...graph.querySelectorAll(".lg-edge")].map((edge) => [edge, `${edge.dataset.from} ${edge.dataset.to}`.split(" ")]);
  const { width, height } = graph.viewBox.baseVal;
  const MOST = 4;
  let scale = 1;

  /* Zoom, so that what is at a place of the box stays there. */
  const least = () => Math.min(box.clientWidth / width, box.clientHeight / height);
  const zoom = (wanted, x = box.clientWidth / 2, y = box.clientHeight / 2) => {
    const now = Math.min(MOST, Math.max(Math.min(least(), 1), wanted));
    const left = (box.scrollLeft + x) * (now / scale) - x;
    const top = (box.scrollTop + y) * (now / scale) - y;
    scale = now;
    graph.style.width = `${width * scale}px`;
    box.scrollTo({ left, top, behavior: "instant" });
  };
  const zooms = { in: () => zoom(scale * 1.3), out: () => zoom(scale / 1.3), fit: () => zoom(least()) };
  form.addEventListener("click", (event) => zooms[event.target.dataset.zoom]?.());
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const kind = { "+": "in", "=": "in", "-": "out", 0: "fit" }[event.key];
    if (!kind) return;
    event.preventDefault();
    zooms[kind]();
  });
  const at = (event) => {
    const place = box.getBoundingClientRect();
    return [event.clientX - place.left, event.clientY - place.top];
  };
  box.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    zoom(scale * Math.exp(-Math.max(-60, Math.min(60, event.deltaY)) / 200), ...at(event));
  }, { passive: false });

  /* Drag with a mouse; pinch with two fingers. One finger scrolls, as everywhere. */
  const fingers = new Map();
  let drag = null;
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return [Math.hypot(a[0] - b[0], a[1] - b[1]), (a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  };
  box.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") fingers.set(event.pointerId, at(event));
    else if (event.button === 0) drag = { x: event.clientX, y: event.clientY, left: box.scrollLeft, top: box.scrollTop, moved: false };
  });
  addEventListener("pointermove", (event) => {
    if (fingers.has(event.pointerId)) {
      const before = fingers.size === 2 && spread();
      fingers.set(event.pointerId, at(event));
      if (before) {
        const [now, x, y] = spread();
        zoom(scale * (now / Math.max(before[0], 1)), x, y);
      }
    } else if (drag) {
      const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
      drag.moved ||= Math.hypot(dx, dy) > 4;
      if (!drag.moved) return;
      box.classList.add("lg-dragging");
      box.scrollTo({ left: drag.left - dx, top: drag.top - dy, behavior: "instant" });
    }
  });
  const release = (event) => {
    fingers.delete(event.pointerId);
    box.classList.remove("lg-dragging");
    if (drag) setTimeout(() => { drag = null; });
  };
  addEventListener("pointerup", release);
  addEventListener("pointercancel", release);
  box.addEventListener("click", (event) => { if (drag?.moved) event.preventDefault(); }, true);
  box.addEventListener("dragstart", (event) => event.preventDefault());

  /* Filter and find: what is not asked for fades. */
  const asked = () => Object.fromEntries([...new FormData(form)].map(([name, value]) => [name, value.trim().toLowerCase()]));
  const filter = () => {
    const { find, verdict, strength } = asked();
    const fits = nodes.filter((node) => (!verdict || node.dataset.verdict === verdict) && (!strength || node.dataset.strength === strength)
      && (!find || node.dataset.name.toLowerCase().includes(find)));
    const exact = fits.filter((node) => node.dataset.name.toLowerCase().startsWith(`${find} `));
    const found = find && exact.length ? exact : fits;
    const names = new Set(found.map((node) => node.dataset.node));
    nodes.forEach((node) => node.classList.toggle("lg-faded", !names.has(node.dataset.node)));
    edges.forEach(([edge, ends]) => edge.classList.toggle("lg-faded", !ends.every((end) => names.has(end))));
    form.querySelector("output").textContent = found.length < nodes.length ? `${found.length} of ${nodes.length} items` : `${nodes.length} items`;
    return found;
  };
  const go = (node) => {
    if (scale < 0.8) zoom(1);
    const [from, to] = [box.getBoundingClientRect(), node.getBoundingClientRect()];
    box.scrollBy({ left: to.left + to.width / 2 - from.left - from.width / 2, top: to.top + to.height / 2 - from.top - from.height / 2 });
  };
  form.hidden = false;
  form.addEventListener("input", () => {
    const found = filter();
    if (found.length && found.length < nodes.length) go(found[0]);
  });
  form.addEventListener("reset", () => setTimeout(filter));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    filter()[0]?.focus();
  });

  /* An item that has the pointer or the focus shows its own arrows. */
  const show = (node) => {
    const near = new Set([node.dataset.node]);
    edges.forEach(([edge, ends]) => {
      const own = ends.includes(node.dataset.node);
      edge.classList.toggle("lg-near", own);
      if (own) ends.forEach((end) => near.add(end));
    });
    nodes.forEach((other) => other.classList.toggle("lg-near", near.has(other.dataset.node)));
    graph.classList.add("lg-chosen");
  };
  const forget = () => graph.classList.remove("lg-chosen");
  nodes.forEach((node) => {
    for (const name of ["pointerenter", "focus"]) node.addEventListener(name, () => show(node));
    for (const name of ["pointerleave", "blur"]) node.addEventListener(name, forget);
  });

  box.classList.add("lg-zooming");
  zoom(Math.max(box.clientWidth / width, 0.85));
  box.scrollTo(0, 0);
  filter();
})();
