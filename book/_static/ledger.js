/* The pages made from the ledger: formulas are set when they come into view, claims can be searched, a link to
   something folded opens it, and the graph shows the arrows of one item. Without this script everything is there
   all the same. */
(() => {
  "use strict";
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const rows = all(".lg-claim");
  const groups = all(".lg-group");

  /* Formulas: the ledger has thousands. Each row's are set once it is near the window. */
  let queue = Promise.resolve();
  const typeset = (boxes) => {
    const found = boxes.flatMap((box) => all(".lg-tex", box));
    found.forEach((formula) => { formula.className = "math notranslate nohighlight"; });
    if (found.length) queue = queue.then(() => window.MathJax.typesetPromise(found)).catch(console.error);
  };
  const watch = () => {
    const observer = new IntersectionObserver((entries) => {
      const near = entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target);
      near.forEach((box) => observer.unobserve(box));
      typeset(near);
    }, { rootMargin: "300px" });
    all(".lg-claim, .lg-item").forEach((box) => observer.observe(box));
  };
  addEventListener("load", () => window.MathJax?.startup?.promise.then(watch));

  /* Search. */
  const form = document.querySelector(".lg-controls");
  const texts = new Map();
  const text = (row) => texts.get(row) ?? texts.set(row, row.textContent.toLowerCase().replace(/\s+/g, " ")).get(row);
  const filter = () => {
    const asked = new FormData(form);
    const phrase = asked.get("text").toLowerCase().trim().replace(/\s+/g, " ");
    const whole = phrase && rows.some((row) => text(row).includes(phrase));
    const words = whole ? [phrase] : phrase.split(" ").filter(Boolean);
    const kinds = ["verdict", "strength", "weight"].filter((kind) => asked.get(kind));
    const active = words.length + kinds.length > 0;
    let shown = 0;
    rows.forEach((row) => {
      const fits = kinds.every((kind) => row.dataset[kind] === asked.get(kind)) && words.every((word) => text(row).includes(word));
      row.hidden = !fits;
      shown += fits;
    });
    groups.forEach((group) => {
      const any = group.querySelector(".lg-claim:not([hidden])");
      group.hidden = !any;
      group.open = active && Boolean(any);
    });
    all(".lg-item").forEach((head) => {
      let next = head.nextElementSibling;
      while (next && next.hidden) next = next.nextElementSibling;
      head.hidden = !next || next.classList.contains("lg-item");
    });
    form.querySelector("output").textContent = active ? `${shown} of ${rows.length} claims` : `${rows.length} claims`;
  };
  if (form) {
    let timer;
    const later = () => { clearTimeout(timer); timer = setTimeout(filter, 150); };
    form.hidden = false;
    form.addEventListener("input", later);
    form.addEventListener("reset", later);
    form.addEventListener("submit", (event) => event.preventDefault());
    filter();
  }

  /* A link to something folded opens it. */
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (form && target.closest(".lg-group")) {
      if (target.hidden) { form.reset(); filter(); }
    }
    for (let box = target; box; box = box.parentElement) if (box.tagName === "DETAILS") box.open = true;
    const inside = target.matches("tbody[id^=erratum]") && target.querySelector("details");
    if (inside) inside.open = true;
    target.scrollIntoView({ block: "start" });
  };
  addEventListener("hashchange", reveal);
  if (location.hash) reveal();

  /* The graph: an item that has the pointer or the focus shows its own arrows. */
  const graph = document.querySelector(".lg-graph");
  if (graph) {
    const edges = all(".lg-edge", graph).map((edge) => [edge, `${edge.dataset.from} ${edge.dataset.to}`.split(" ")]);
    const nodes = all(".lg-node", graph);
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
      node.addEventListener("pointerenter", () => show(node));
      node.addEventListener("focus", () => show(node));
      node.addEventListener("pointerleave", forget);
      node.addEventListener("blur", forget);
    });
  }
})();
