/* A formula in a line that is wider than a phone scrolls sideways: its cut edge fades, till its end is reached. */
(() => {
  "use strict";
  const mark = (formula) => formula.classList.toggle("cx-cut", formula.scrollWidth - formula.clientWidth - formula.scrollLeft > 2);
  const sizes = new ResizeObserver((entries) => entries.forEach((entry) => mark(entry.target)));
  document.querySelectorAll(".bd-article span.math").forEach((formula) => {
    sizes.observe(formula);
    formula.addEventListener("scroll", () => mark(formula), { passive: true });
  });
  window.MathJax?.startup?.promise?.then(() => document.querySelectorAll(".bd-article span.math").forEach(mark));
})();
