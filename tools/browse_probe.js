/* What tools/browse_page.py asks of a page. It is there before the page's own scripts, and changes nothing. */
window.probe = (() => {
  "use strict";
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];
  const squeeze = (text, size = 90) => text.replace(/\s+/g, " ").trim().slice(0, size);
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));

  /* An element, in words that find it again. */
  const name = (element) => {
    const classes = [...element.classList].slice(0, 3).map((x) => `.${x}`).join("");
    return `${element.tagName.toLowerCase()}${element.id ? `#${element.id}` : ""}${classes}`;
  };
  const place = (element) => {
    const box = element.parentElement?.closest("[id], section, article");
    return `${box ? `${name(box)} > ` : ""}${name(element)}`;
  };

  /* Milliseconds since the navigation began, once the formulas in view are set and the main thread has nothing to do. */
  const interactive = async () => {
    if (document.readyState !== "complete") await new Promise((done) => addEventListener("load", done));
    if (window.MathJax?.startup?.promise) await window.MathJax.startup.promise;
    await new Promise((done) => requestIdleCallback(done));
    return performance.now();
  };

  /* Formulas that a reader would see as source, or as an error. */
  const SOURCE = "code, pre, script, style, textarea, noscript, mjx-container, .lg-tex, .math, template";
  const RAW = /\\\(|\\\[|\$\$|\\begin\{|\$\\?[A-Za-z][^$]{0,80}\$/;
  const formulas = (root = document.body) => {
    const found = [];
    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const { data, parentElement } = walker.currentNode;
      if (RAW.test(data) && !parentElement.closest(SOURCE)) found.push(`not set: ${squeeze(data)}`);
    }
    for (const box of all(".math", root)) {
      if (box.textContent.trim() && !box.querySelector("mjx-container")) found.push(`not set: ${squeeze(box.textContent)}`);
    }
    for (const box of all("mjx-merror, [data-mjx-error]", root)) {
      found.push(`error: ${squeeze(box.dataset.mjxError ?? box.textContent)}`);
    }
    return found;
  };

  /* Where formulas are set only when they come into view: bring a sample into view. */
  const sampled = async (patience, size = 6) => {
    const waiting = all(".lg-tex").map((formula) => formula.closest(".lg-claim, .lg-item") ?? formula);
    const rows = [...new Set(waiting)];
    const step = Math.max(1, Math.floor(rows.length / size));
    const found = [];
    for (const row of rows.filter((_, index) => index % step === 0)) {
      for (let box = row; box; box = box.parentElement) if (box.tagName === "DETAILS") box.open = true;
      const begin = performance.now();
      const show = () => row.scrollIntoView({ block: "center", behavior: "instant" }); // rows above may grow, once seen
      for (show(); row.querySelector(".lg-tex, .math:not(:has(mjx-container))") && performance.now() - begin < patience; show()) await pause(20);
      if (row.querySelector(".lg-tex")) found.push(`not set when scrolled into view: ${squeeze(row.textContent)}`);
      found.push(...formulas(row));
    }
    scrollTo(0, 0);
    return found;
  };

  /* Open all that is folded, but not what waits to come into view. */
  const unfold = () => all("details:not(.lg-group, .lg-claim details)").forEach((box) => { box.open = true; });

  /* What sticks out of a narrow page, and the boxes that scroll sideways without being meant to. */
  const MARKED = "pre, .math, mjx-container, .lg-scroll, .table-box, .pst-scrollable-table-container, .cx-scroll";
  const scrolls = (element) => /auto|scroll|hidden|clip/.test(getComputedStyle(element).overflowX);
  const overflow = () => {
    const root = document.scrollingElement;
    const wide = innerWidth;
    const found = [];
    if (root.scrollWidth > wide) {
      const out = all("body *:not(svg *)").filter((element) => {
        if (!element.checkVisibility({ contentVisibilityAuto: true })) return false;
        const { left, right, width } = element.getBoundingClientRect();
        const words = getComputedStyle(element).overflowX === "visible" ? left + element.scrollWidth : right;
        if (Math.max(right, words) + scrollX <= wide + 1 || !width) return false;
        for (let box = element.parentElement; box && box !== document.body; box = box.parentElement) {
          if (scrolls(box) || getComputedStyle(box).position === "fixed") return false;
        }
        return true;
      });
      const deepest = out.filter((element) => !out.some((other) => other !== element && element.contains(other)));
      found.push(`the page is ${root.scrollWidth} px wide: ${deepest.slice(0, 4).map(place).join(", ")}`);
    }
    for (const box of all("main *:not(svg *, mjx-container *, pre *)")) {
      if (!box.checkVisibility({ contentVisibilityAuto: true })) continue; // its width is not known yet
      if (!/auto|scroll/.test(getComputedStyle(box).overflowX)) continue;
      if (box.scrollWidth <= box.clientWidth + 1 || !box.clientWidth) continue;
      const table = [...box.children].every((child) => child.matches("table") || child.querySelector("table, pre"));
      if (!box.closest(MARKED) && !table) found.push(`scrolls sideways: ${place(box)} (${box.scrollWidth} in ${box.clientWidth} px)`);
    }
    return found;
  };

  /* Pictures that say nothing to those who cannot see them. */
  const labelled = (element) => Boolean(element.getAttribute("aria-label")?.trim()
    || (element.getAttribute("aria-labelledby") ?? "").split(/\s+/).some((id) => id && document.getElementById(id)?.textContent.trim()));
  const hidden = (element) => element.closest("[aria-hidden=true], [role=presentation], [role=none], mjx-container, template");
  const alternatives = () => {
    const found = [];
    for (const picture of all("img, [role=img], canvas, svg, object, embed, input[type=image]")) {
      if (hidden(picture) || picture.parentElement?.closest("svg, [role=img]")) continue;
      if (!picture.checkVisibility() && !picture.closest("details")) continue;
      const own = picture.matches("img, input") ? picture.alt.trim() && !/\.(svg|png|jpe?g|gif|webp)$/.test(picture.alt) : false;
      const title = [...picture.children].some((child) => child.tagName.toLowerCase() === "title" && child.textContent.trim());
      const fallback = picture.matches("canvas, object") && picture.textContent.trim();
      if (!own && !title && !fallback && !labelled(picture) && !picture.closest("[role=figure][aria-label], [role=group][aria-label]")) {
        found.push(`says nothing: ${place(picture)}`);
      }
    }
    for (const figure of all("figure")) {
      if (!figure.querySelector("figcaption, img, svg, table, [role=img], pre")) found.push(`says nothing: ${place(figure)}`);
    }
    return found;
  };

  /* What the keyboard must reach, and whether it does and shows it. */
  const WORKS = "a[href], button, input:not([type=hidden]), select, textarea, summary, [role=button], [role=slider],"
    + " [role=tab], [role=link], [role=switch], [onclick], [contenteditable=true]";
  const inGroup = (element) => element.matches("[role=tab], [role=radio], [role=option], [role=menuitem], input[type=radio]");
  const seen = (element) => element.checkVisibility({ checkVisibilityCSS: true, checkOpacity: false })
    && !element.closest("[inert]") && !element.disabled && element.getClientRects().length > 0;
  const usable = () => all(WORKS).filter((element) => seen(element) && !element.closest("mjx-container"));
  const look = (element) => {
    const boxes = [element, element.parentElement, ...element.children].filter(Boolean).slice(0, 12);
    const styles = [...boxes.map((box) => getComputedStyle(box)), getComputedStyle(element, "::after"), getComputedStyle(element, "::before")];
    const looks = styles.map((style) => {
      const { outlineStyle, outlineWidth, outlineColor, boxShadow, borderColor, backgroundColor, color, textDecoration, stroke, strokeWidth, opacity } = style;
      const outline = outlineStyle === "none" || outlineWidth === "0px" ? "" : [outlineStyle, outlineWidth, outlineColor];
      return [outline, boxShadow, borderColor, backgroundColor, color, textDecoration, stroke, strokeWidth, opacity].join();
    });
    return looks.join("|");
  };
  const kind = (element) => `${name(element).replace(/#[^.]*/, "")} in ${element.parentElement?.className.baseVal ?? element.parentElement?.className}`;
  const keyboard = () => {
    const found = [];
    const kinds = new Map();
    for (const element of usable()) {
      if (element.tabIndex < 0 && !inGroup(element) && element.getAttribute("aria-hidden") !== "true") {
        found.push(`not reached: ${place(element)}`);
      } else if (element.tabIndex >= 0 && !kinds.has(kind(element))) kinds.set(kind(element), element);
    }
    document.activeElement?.blur();
    for (const element of kinds.values()) {
      const before = look(element);
      element.focus({ preventScroll: true, focusVisible: true });
      if (document.activeElement !== element) found.push(`takes no focus: ${place(element)}`);
      else {
        element.getAnimations({ subtree: true }).forEach((move) => { try { move.finish(); } catch { /* an endless one */ } });
        if (look(element) === before) found.push(`focus not visible: ${place(element)}`);
      }
      document.activeElement?.blur();
    }
    scrollTo(0, 0);
    return found;
  };
  const tabbable = () => {
    scrollTo(0, 0); // the walk begins at the page's beginning
    document.body.tabIndex = -1;
    document.body.focus({ preventScroll: true });
    document.body.removeAttribute("tabindex");
    return usable().filter((element) => element.tabIndex >= 0).length;
  };
  const marks = new WeakMap();
  const focused = () => {
    const element = document.activeElement;
    if (!element || element === document.body) return null;
    if (!marks.has(element)) marks.set(element, `${Math.random()}`);
    return [marks.get(element), place(element), seen(element)];
  };

  /* Axe takes a minute for ten thousand elements. Of what is there a thousand times, made by one template, some stay:
     of formulas the first ones and those in links, of coloured code two words of each colour, of the claims, the
     errata and the entries of an index some of each class, of a table the first rows; and of drawings the words. */
  const REPEATED = ".lg-claim, .lg-errata tbody, dl.py, table.indextable li";
  const thin = (each = 6) => {
    const formulas = all("mjx-container").slice(each).filter((box) => !box.closest("a"));
    formulas.forEach((box) => (box.closest("span.math") ?? box).replaceWith("x"));
    const count = new Map();
    const often = (element, most) => {
      const key = `${element.className} ${Object.values(element.dataset).slice(0, 2)}`;
      count.set(key, (count.get(key) ?? 0) + 1);
      return count.get(key) > most;
    };
    all(REPEATED).forEach((box) => { if (box.isConnected && often(box, each)) box.remove(); });
    all("pre span").forEach((word) => {
      if (word.isConnected && !word.querySelector("a") && often(word, 2)) word.replaceWith(word.textContent);
    });
    all("svg:not(mjx-container svg) :is(path, line, circle, ellipse, polygon, polyline, rect, use, defs)")
      .filter((shape) => !shape.querySelector("title")).forEach((shape) => shape.remove());
    all("tbody").forEach((body) => [...body.rows].slice(each).forEach((row) => row.remove()));
    document.normalize();
  };

  /* Colours come from classes: in the dark three of each kind of text stay, told by the classes around it. */
  const thinner = (each = 3) => {
    const count = new Map();
    for (const leaf of all("body *:not(:has(*))").filter((element) => element.textContent.trim())) {
      const around = [];
      for (let box = leaf; box && around.length < 4; box = box.parentElement) around.push(`${box.localName} ${box.className}`);
      const key = around.join("|");
      count.set(key, (count.get(key) ?? 0) + 1);
      if (count.get(key) > each) leaf.remove();
    }
  };

  /* As the theme's own button does. */
  const dark = () => { Object.assign(document.documentElement.dataset, { theme: "dark", mode: "dark" }); };

  /* What axe finds, as one line for each element. */
  const axe = async (rules) => {
    const choice = rules ? { runOnly: { type: "rule", values: rules } } : {};
    const options = { ...choice, resultTypes: ["violations"], preload: false }; // else axe loads all styles again
    const { violations } = await window.axe.run(document, options);
    return violations.filter(({ impact }) => impact === "serious" || impact === "critical").flatMap(({ id, nodes }) =>
      nodes.map(({ target, html, any }) => {
        const data = any?.[0]?.data;
        const why = data?.contrastRatio ? ` ${data.contrastRatio}:1, ${data.fgColor} on ${data.bgColor}` : "";
        return `${id}${why}: ${target.flat().join(" ")} ${squeeze(html, 110)}`;
      }));
  };
  return { interactive, formulas, sampled, overflow, alternatives, keyboard, tabbable, focused, thin, thinner, dark, axe, unfold };
})();
