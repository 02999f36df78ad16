/* A formula in a line that is wider than a phone scrolls sideways: its cut edge fades, till its end is reached. */
(() => {
  "use strict";
  const WIDE = 200; // a short one sticks out of its box by a hair's breadth, and is not cut
  const mark = (formula) => {
    const hidden = formula.scrollWidth - formula.clientWidth - formula.scrollLeft;
    formula.classList.toggle("cx-cut", formula.clientWidth > WIDE && hidden > 4);
  };
  const sizes = new ResizeObserver((entries) => entries.forEach((entry) => mark(entry.target)));
  document.querySelectorAll(".bd-article :is(span, div):is(.math, .lg-tex)").forEach((formula) => {
    sizes.observe(formula);
    formula.addEventListener("scroll", () => mark(formula), { passive: true });
  });
})();
