/* Formulas are set when they come near the window, the text's others while the reader reads, and all that is open
   before the page is printed: to set all of a chapter takes seconds. What is folded waits until it is opened. */
(() => {
  "use strict";
  const MARGIN = 600; // pixels above and below the window
  const SLICE = 24; // formulas that are set at a time, in less than a tenth of a second
  const LATER = ["lg-tex"];
  const FORMULA = ["math", "notranslate", "nohighlight"];
  const waiting = new Map(); // the classes that MathJax looks for

  const wait = (element, now, then) => {
    element.classList.remove(...then);
    element.classList.add(...now);
    waiting.set(element, then);
  };
  document.querySelectorAll(".lg-tex").forEach((formula) => waiting.set(formula, FORMULA));
  const ofText = [...document.querySelectorAll(".math:not(.tex2jax_process *), .tex2jax_process")];
  ofText.forEach((element) => wait(element, LATER, element.matches(".math") ? FORMULA : ["tex2jax_process"]));

  const set = (elements) => {
    const found = elements.filter((element) => waiting.has(element));
    found.forEach((element) => {
      element.classList.remove(...LATER);
      element.classList.add(...waiting.get(element));
      waiting.delete(element);
    });
    if (found.length) window.MathJax.typeset(found);
  };
  /* A row of the ledger is set as a whole. */
  const home = (element) => element.closest(".lg-claim, .lg-item") ?? element;
  const observer = new IntersectionObserver((entries) => {
    const near = entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target);
    near.forEach((box) => observer.unobserve(box));
    set(near.flatMap((box) => [box, ...box.querySelectorAll(".lg-tex")]));
  }, { rootMargin: `${MARGIN}px` });
  const isNear = (element) => {
    const { top, bottom } = element.getBoundingClientRect();
    return bottom > -MARGIN && top < innerHeight + MARGIN;
  };
  const isShown = (element) => element.checkVisibility?.() ?? true; // browsers of before 2024 lack it
  const isOpen = (element) => !element.closest("details:not([open]) > :not(summary)");
  const idle = window.requestIdleCallback ?? ((work) => setTimeout(work, 100));
  const rest = () => {
    const next = [];
    while (ofText.length && next.length < SLICE) {
      const element = ofText.shift();
      if (waiting.has(element) && isShown(element)) next.push(element);
    }
    set(next);
    if (ofText.length) idle(rest);
  };
  window.MathJax?.startup?.promise?.then(() => {
    set(ofText.filter((element) => isShown(element) && isNear(element))); // to measure what is folded is slow
    new Set([...waiting.keys()].map(home)).forEach((box) => observer.observe(box));
    setTimeout(rest, 1000); // first the reader
    addEventListener("beforeprint", () => set([...waiting.keys()].filter(isOpen)));
  });
})();
