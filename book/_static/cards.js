/* A pointer that rests on a link inside the book, or the keyboard that reaches it, brings up a card with what it
   leads to. The cards stand in the page as JSON. Escape closes; a pointer may move onto the card. Without this
   script, and where nothing can hover, links are links. */
(() => {
  "use strict";
  const source = document.getElementById("cx-cards");
  if (!source || !matchMedia("(any-hover: hover)").matches) return;
  const cards = JSON.parse(source.textContent);
  const card = document.createElement("div");
  card.id = "cx-card";
  card.setAttribute("role", "tooltip");
  card.hidden = true;
  document.querySelector("article")?.append(card);
  let owner = null;
  let timer = 0;

  /* A claim whose row is in this page is told by its row. */
  const fromRow = (address) => {
    const row = address.startsWith("#claim-") && document.getElementById(decodeURIComponent(address.slice(1)));
    if (!row) return "";
    const head = `<p class="cx-card-head"><strong>${row.querySelector(".lg-id").textContent}</strong> ${row.querySelector(".lg-pill").outerHTML}</p>`;
    return (head + row.querySelector(".lg-said").outerHTML).replaceAll("lg-tex", "math notranslate nohighlight");
  };
  const content = (link) => {
    const address = link?.getAttribute("href") ?? "";
    if (!link || link.closest("#cx-card, .lg-id, .headerlink")) return "";
    const said = Object.hasOwn(cards, address) ? cards[address] : fromRow(address);
    const several = link.dataset.claims ? `<p class="lg-quiet">The gravest of ${link.dataset.claims}.</p>` : "";
    return said && said + several;
  };

  const place = () => {
    const boxes = [...owner.getClientRects()];
    const box = boxes.find((x) => x.width > 0) ?? owner.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = card;
    const below = box.bottom + 8 + height <= innerHeight || box.top < height + 8;
    card.style.left = `${Math.max(8, Math.min(box.left, document.documentElement.clientWidth - width - 8))}px`;
    card.style.top = `${Math.max(8, below ? Math.min(box.bottom + 8, innerHeight - height - 8) : box.top - height - 8)}px`;
  };
  /* The browser would show a title beside the card, with the same words. */
  const untitle = (link) => {
    const title = link.querySelector(":scope > title");
    if (title) {
      link.setAttribute("aria-label", title.textContent);
      title.remove();
    }
    link.removeAttribute("title");
  };
  const show = (link, said) => {
    hide();
    owner = link;
    untitle(link);
    card.innerHTML = said;
    card.hidden = false;
    link.setAttribute("aria-describedby", card.id);
    place();
    const formulas = [...card.querySelectorAll(".math:not(:has(mjx-container))")];
    const set = formulas.length && window.MathJax?.typesetPromise?.(formulas);
    if (set) set.then(() => { if (owner === link) place(); }).catch(console.error);
  };
  const hide = () => {
    clearTimeout(timer);
    owner?.removeAttribute("aria-describedby");
    owner = null;
    card.hidden = true;
  };
  const later = (action, wait) => { clearTimeout(timer); timer = setTimeout(action, wait); };

  const linkAt = (event) => event.target.closest?.("article a[href]");
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    const link = linkAt(event);
    if (event.target.closest?.("#cx-card") || (owner && link === owner)) return clearTimeout(timer);
    const said = content(link);
    if (said) {
      untitle(link);
      later(() => show(link, said), owner ? 80 : 300);
    } else if (owner) later(hide, 250);
    else clearTimeout(timer);
  });
  document.addEventListener("focusin", (event) => {
    const link = linkAt(event);
    const said = link?.matches(":focus-visible") && content(link);
    if (said) show(link, said);
    else if (!event.target.closest?.("#cx-card")) hide();
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  /* The keyboard brings what it reaches into view, and its card goes along; a pointer stays where it is. */
  const inView = (link) => { const { top, bottom } = link.getBoundingClientRect(); return bottom > 0 && top < innerHeight; };
  addEventListener("scroll", (event) => {
    if (!owner || card.contains(event.target)) return;
    if (owner === document.activeElement && inView(owner)) place();
    else hide();
  }, { capture: true, passive: true });
  document.addEventListener("click", hide);
})();
