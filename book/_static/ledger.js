/* The pages made from the ledger: claims can be searched, filtered and sorted, a link to something
   folded opens it. Without this script everything is there all the same. */
(() => {
  "use strict";
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const rows = all(".lg-claim");
  const groups = all(".lg-group");

  /* Search, filter, sort. What is asked stands in the address, after the #: such a view can be linked. */
  const form = document.querySelector(".lg-controls");
  const KINDS = ["verdict", "strength", "weight", "section", "family"];
  const sections = new Map(groups.flatMap((group) => all(".lg-claim", group).map((row) => [row, group.querySelector(".lg-group-name").textContent])));
  const homes = groups.map((group) => [group, [...group.children].slice(1)]);
  const flat = Object.assign(document.createElement("div"), { className: "lg-sorted", hidden: true });
  /* B~3, B̃3, B̃₃ and \tilde B_3 are the same to those who search. */
  const plain = (words) => words.normalize("NFD").toLowerCase().replace(/\\tilde\s*\{?([a-z])\}?/g, "$1~").replace(/\u0303/g, "~")
    .replace(/[₀-₉]/g, (digit) => digit.charCodeAt(0) - 0x2080).replace(/~_\{?(\w)\}?/g, "~$1").replace(/\\[()]/g, "").replace(/\s+/g, " ").trim();
  const texts = new Map();
  const text = (row) => texts.get(row) ?? texts.set(row, plain(row.textContent)).get(row);
  const has = {
    section: (row, value) => sections.get(row) === value,
    family: (row, value) => row.dataset.family?.split(" ").includes(value),
  };
  let order = "";
  const arrange = (kind) => {
    if (kind === order) return;
    order = kind;
    flat.hidden = !kind;
    if (!kind) return homes.forEach(([group, inside]) => group.append(...inside));
    const ranks = new Map([...form.elements[kind].options].map((option, n) => [option.value, n]));
    flat.append(...[...rows].sort((a, b) => ranks.get(a.dataset[kind]) - ranks.get(b.dataset[kind])));
  };
  const filter = () => {
    const asked = new FormData(form);
    const phrase = plain(asked.get("words"));
    const whole = phrase && rows.some((row) => text(row).includes(phrase));
    const words = whole ? [phrase] : phrase.split(" ").filter(Boolean);
    const kinds = KINDS.filter((kind) => asked.get(kind));
    const fits = (row, kind) => (has[kind] ?? ((x, value) => x.dataset[kind] === value))(row, asked.get(kind));
    const active = words.length + kinds.length > 0;
    let shown = 0;
    rows.forEach((row) => {
      row.hidden = !(kinds.every((kind) => fits(row, kind)) && words.every((word) => text(row).includes(word)));
      shown += !row.hidden;
    });
    arrange(asked.get("sort"));
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
  const tell = () => {
    const asked = new URLSearchParams([...new FormData(form)].filter(([, value]) => value));
    history.replaceState(null, "", asked.size ? `#${asked}` : location.pathname + location.search);
  };
  const ask = (asked = location.hash.slice(1)) => {
    const values = new URLSearchParams(asked.replace(/^q=|&q=/, (start) => start.replace("q", "words")));
    [...form.elements].filter((field) => field.name).forEach((field) => { field.value = values.get(field.name) ?? ""; });
    filter();
  };
  if (form && rows.length) {
    let timer;
    const later = () => { clearTimeout(timer); timer = setTimeout(() => { filter(); tell(); }, 150); };
    form.after(flat);
    form.hidden = false;
    form.addEventListener("input", later);
    form.addEventListener("reset", later);
    form.addEventListener("submit", (event) => event.preventDefault());
    ask();
  }

  /* A link to something folded opens it. */
  const reveal = () => {
    if (form && rows.length && location.hash.includes("=")) return ask();
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (target.hidden && rows.includes(target)) ask("");
    for (let box = target; box; box = box.parentElement) if (box.tagName === "DETAILS") box.open = true;
    const inside = target.matches("tbody[id^=erratum]") && target.querySelector("details");
    if (inside) inside.open = true;
    target.scrollIntoView({ block: "start" });
  };
  addEventListener("hashchange", reveal);
  if (location.hash) reveal();
})();
