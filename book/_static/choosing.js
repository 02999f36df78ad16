/* Which triangulation to use: answers from the data in the page, where the order of the types is decided exactly.
   Without this script the tables of the page answer. */
(() => {
  "use strict";
  const chooser = document.querySelector(".cx-chooser");
  if (!chooser) return;
  const data = JSON.parse(chooser.querySelector(".cx-data").textContent);
  const form = chooser.querySelector("form");
  const answer = chooser.querySelector(".cx-answer");
  const list = (names) => names.join(", ").replace(/, ([^,]*)$/, " and $1");
  const link = (address, words) => `<a href="${address}">${words}</a>`;

  /* The orders of a dimension with the types that offer all that is needed; ties stay together. */
  const fitting = (measure, d, needed) => data.orders[measure][d]
    .map(([types, exact, decimal]) => [types.filter((type) => needed.every((name) => data.types[d][type].includes(name))), exact, decimal])
    .filter(([types]) => types.length);

  const told = (measure, d, needed) => {
    const words = data.measures[measure];
    const [first, second] = fitting(measure, d, needed);
    if (!first) {
      const asked = list(needed.map((name) => data.offers[name][0]));
      return `<p class="cx-chosen">None</p><p>No Coxeter triangulation of dimension ${d} offers all of this: ${asked}.</p>`;
    }
    const [top] = data.orders[measure][d];
    const offered = Object.keys(data.offers).filter((name) => first[0].every((type) => data.types[d][type].includes(name)));
    const lines = [
      `<p class="cx-chosen"><strong>${list(first[0])}</strong></p>`,
      `<p>Normalised ${words}: ${first[2]}, exactly ${first[1]}.</p>`,
      offered.length ? `<p>It offers: ${offered.map((name) => link(data.offers[name][1], data.offers[name][0])).join(", ")}.</p>` : "",
      first[2] === top[2]
        ? `<p>No Coxeter triangulation of dimension ${d} has a greater ${words}; ${link(data.best[measure], "that is so in every dimension")}.</p>`
        : `<p>Without these needs it would be ${list(top[0])}, with ${top[2]}.</p>`,
      second ? `<p>Next: ${list(second[0])}, with ${second[2]}.</p>` : "",
    ];
    return lines.join("");
  };

  let timer;
  const show = () => {
    const asked = new FormData(form);
    const d = Number(asked.get("d"));
    clearTimeout(timer);
    timer = setTimeout(() => {
      answer.innerHTML = Number.isInteger(d) && d >= 2 && d <= data.max
        ? told(asked.get("measure"), d, asked.getAll("need"))
        : `<p>Give a dimension from 2 to ${data.max}.</p>`;
    }, 150);
  };
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", show);
  form.hidden = false;
  answer.hidden = false;
  chooser.querySelector(".cx-otherwise").hidden = true;
  show();
})();
