/* Run by tools/make_pdf.py in the document to be printed, once formulas are set: what is wider than the paper is
   made smaller, and the numbers of the contents are filled in. */
(() => {
  "use strict";
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const WIDE = ".bd-article table, .bd-article mjx-container, .bd-article pre, .bd-article svg, .bd-article img";
  const room = (box) => {
    const outer = box.parentElement.closest("td, li, div, p, figure, article, details, dd") ?? box.parentElement;
    const style = getComputedStyle(outer);
    return outer.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  };
  const page = () => document.querySelector("main").getBoundingClientRect();

  /* A table that sticks out of the page breaks its lines; if that is not enough, it is set smaller, as a whole. */
  for (const table of all(".bd-article table").filter((box) => !box.parentElement.closest("table"))) {
    const { left } = table.getBoundingClientRect();
    const free = page().right - left;
    const measure = () => Math.max(table.scrollWidth, table.getBoundingClientRect().width);
    if (free / measure() < 0.7) table.classList.add("cx-narrow");
    const wide = measure();
    if (wide > free + 0.5) table.style.zoom = (free / wide) * 0.995;
  }
  /* So is a formula. */
  for (const formula of all(".bd-article mjx-container")) {
    const { right, left, width } = formula.firstElementChild?.getBoundingClientRect() ?? formula.getBoundingClientRect();
    const free = Math.min(page().right - left, formula.getAttribute("display") ? room(formula) || 1e9 : 1e9);
    if (right > page().right + 0.5 || (formula.getAttribute("display") && width > free + 0.5)) {
      const zoom = (free / width) * 0.99;
      if (zoom > 0.3 && zoom < 1) formula.style.zoom = zoom;
    }
  }

  /* What still sticks out. */
  window.clipped = () => {
    const { right } = page();
    const out = all(".bd-article *, .cx-contents *, .cx-title *").filter((box) => {
      const rect = box.getBoundingClientRect();
      return rect.width > 0 && rect.right > right + 2 && box.checkVisibility() && !box.closest("mjx-assistive-mml, defs");
    });
    const set = new Set(out);
    return out.filter((box) => !set.has(box.parentElement)).map((box) => {
      const chapter = box.closest("article")?.id ?? "front";
      return `${chapter}: ${box.outerHTML.replace(/\s+/g, " ").slice(0, 110)} by ${Math.round(box.getBoundingClientRect().right - right)} px`;
    });
  };
  /* The lines of the contents as plain text, for the bookmarks. */
  const SMALL = { 0: "₀", 1: "₁", 2: "₂", 3: "₃", 4: "₄", 5: "₅", 6: "₆", 7: "₇", 8: "₈", 9: "₉" };
  const words = (node) => {
    const inner = () => [...node.childNodes].map(words).join("");
    if (node.nodeType === Node.TEXT_NODE) return node.data;
    const name = node.localName;
    if (name === "mjx-container") return words(node.querySelector("mjx-assistive-mml") ?? node.lastChild);
    if (name === "mover" && node.lastChild.textContent === "~") return `${words(node.firstChild)}\u0303`.normalize("NFC");
    if (name === "msub") return `${words(node.firstChild)}${[...words(node.lastChild)].map((x) => SMALL[x] ?? x).join("")}`;
    if (name === "msup") return `${words(node.firstChild)}^${words(node.lastChild)}`;
    if (name === "mfrac") return `${words(node.firstChild)}/${words(node.lastChild)}`;
    if (name === "msqrt") return `√${inner()}`;
    return inner();
  };
  window.smallest = () => all("[style*=zoom]").map((box) => [Number(box.style.zoom), box.closest("article").id, box.localName])
    .sort(([a], [b]) => a - b).slice(0, 5).map(([zoom, ...where]) => `${where.join(" ")} at ${Math.round(100 * zoom)} %`);
  window.lines = () => all(".cx-contents p").map((line) => {
    const place = line.querySelector(".cx-number").dataset.place;
    return [line.className.replace("cx-", ""), place, words(line.querySelector("a")).replace(/\s+/g, " ").trim()];
  });
  window.fill = (numbers) => all(".cx-number").filter((box) => {
    const number = numbers[box.dataset.place] ?? numbers[encodeURIComponent(box.dataset.place)];
    box.textContent = number ?? "";
    return number === undefined;
  }).map((box) => box.dataset.place);
})();
