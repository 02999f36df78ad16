/* Formulas in what is folded are set when it is opened: a chapter has many, and few readers open all. */
(() => {
  "use strict";
  document.addEventListener("toggle", (event) => {
    const found = event.target.open ? [...event.target.querySelectorAll(".lg-tex")] : [];
    found.forEach((formula) => { formula.className = "math notranslate nohighlight"; });
    if (found.length) window.MathJax?.startup?.promise?.then(() => window.MathJax.typesetPromise(found)).catch(console.error);
  }, true);
})();
