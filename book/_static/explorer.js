/* The quality explorer: draws what the controls ask for. All numbers come from the data in the page, where they are
   exact texts and decimals rounded once; floats only place points. Without this script the page shows curves drawn
   beforehand, the sentences, and the tables. */
(() => {
  "use strict";
  const figure = document.querySelector(".cx-explorer");
  if (!figure || !window.Plotly) return;
  const one = (selector, root = figure) => root.querySelector(selector);
  const all = (selector, root = figure) => [...root.querySelectorAll(selector)];
  const data = JSON.parse(one(".cx-data").textContent);
  const form = one(".cx-controls");
  const reader = one(".cx-reader");
  const plot = one(".cx-plot");
  const LETTERS = Object.keys(data.families);
  const SINGLE = Object.keys(data.single);
  const FLAGS = ["limits", "printed", "scaled", "log", "raw"];
  const START = { measure: "radius_ratio", families: [...LETTERS, "X"], max: 16, d: 6, limits: true, printed: true };
  const SYMBOLS = { A: "circle", B: "square", C: "diamond", D: "triangle-up", X: "x-thin-open" };
  const DASHES = { A: "solid", B: "solid", C: "9px,6px", D: "1px,6px" };

  /* -- the state: in the controls, and in the address so that a view can be linked -- */

  const clamp = (text, low, high, otherwise) => {
    const n = Number.parseInt(text, 10);
    return Number.isNaN(n) ? otherwise : Math.min(high, Math.max(low, n));
  };
  const fromAddress = () => {
    const asked = new URLSearchParams(location.hash.slice(1));
    const families = (asked.get("families") ?? "").split(",").filter((x) => START.families.includes(x));
    const state = {
      measure: asked.get("measure") in data.measures ? asked.get("measure") : START.measure,
      families: families.length ? families : START.families,
      max: clamp(asked.get("max"), 3, data.max, START.max),
    };
    state.d = clamp(asked.get("d"), 2, state.max, Math.min(START.d, state.max));
    FLAGS.forEach((flag) => { state[flag] = asked.has(flag) ? asked.get(flag) === "1" : Boolean(START[flag]); });
    return state;
  };
  const toControls = (state) => {
    form.elements.measure.value = state.measure;
    form.elements.max.value = state.max;
    all("[name=family]", form).forEach((box) => { box.checked = state.families.includes(box.value); });
    FLAGS.forEach((flag) => { form.elements[flag].checked = state[flag]; });
    one("[name=d]").max = state.max;
    one("[name=d]").value = state.d;
  };
  const fromControls = () => {
    const state = { measure: form.elements.measure.value, max: Number(form.elements.max.value) };
    state.families = all("[name=family]:checked", form).map((box) => box.value);
    state.d = Math.min(Number(one("[name=d]").value), state.max);
    FLAGS.forEach((flag) => { state[flag] = form.elements[flag].checked; });
    return state;
  };
  const toAddress = (state) => {
    const asked = [`measure=${state.measure}`, `families=${state.families.join(",")}`, `max=${state.max}`, `d=${state.d}`];
    FLAGS.forEach((flag) => { if (state[flag] !== Boolean(START[flag])) asked.push(`${flag}=${state[flag] ? 1 : 0}`); });
    history.replaceState(null, "", `#${asked.join("&")}`);
  };

  /* -- the data of a view -- */

  const measure = (state) => data.measures[state.measure];
  const scale = (state) => measure(state)[state.raw ? "raw" : "normalised"];
  const first = (family) => data.families[family]?.first ?? data.single[family].d;
  const name = (family) => (data.families[family] ?? data.single[family]).name;
  const typed = (family, d) => (family in data.families ? `${name(family)}<sub>${d}</sub>` : name(family));
  const shown = (family, state) => state.families.includes(family in data.families ? family : "X");
  const entry = (family, d, state) => scale(state).values[family]?.[d - first(family)];
  const isScaled = (state) => state.scaled && Object.keys(scale(state).limits).length > 0;
  const isLog = (state) => state.log || (state.raw && !Object.keys(scale(state).limits).length);
  const power = (state) => {
    const limits = Object.values(scale(state).limits);
    return limits.length ? { "1/2": "√d", "1": "d" }[limits[0][2]] ?? `d^(${limits[0][2]})` : "";
  };
  const exponent = (text) => { const [a, b = 1] = text.split("/").map(Number); return a / b; };
  const height = (value, state) => Number(isScaled(state) ? value[2] : value[1]);
  const wrong = (family, d, state) => data.printed.filter((x) =>
    x[0] === state.measure && x[1] === (state.raw ? "raw" : "normalised") && x[2] === family && x[3] === d);
  const range = (a, b) => Array.from({ length: Math.max(0, b - a + 1) }, (_, i) => a + i);
  const points = (family, state) => (family in data.families ? range(first(family), state.max) : [first(family)].filter((d) => d <= state.max));
  /* The exact order of the shown types of a dimension: a list of lists of equal ones. */
  const order = (d, state) => measure(state).rank[d].split(">")
    .map((equal) => equal.split("=").filter((family) => shown(family, state))).filter((equal) => equal.length);

  /* -- the drawing -- */

  const colour = (variable) => getComputedStyle(figure).getPropertyValue(variable).trim();
  const hover = (family, d, state) => {
    const value = entry(family, d, state);
    const told = [`<b>${typed(family, d)}</b> ${value[0]}`, `≈ ${value[1]}`];
    if (isScaled(state)) told.push(`times ${power(state)} ≈ ${value[2]}`);
    wrong(family, d, state).forEach((x) => told.push(`printed ${x[4]} (${x[6]})`));
    return told.join("<br>");
  };
  const curve = (family, state) => {
    const ds = points(family, state);
    const single = family in data.single;
    const tone = colour(single ? "--cx-X" : `--cx-${family}`);
    return {
      x: ds, y: ds.map((d) => height(entry(family, d, state), state)), name: name(family),
      text: ds.map((d) => hover(family, d, state)), customdata: ds.map((d) => [family, d]), hovertemplate: "%{text}<extra></extra>",
      type: "scatter", mode: single ? "markers+text" : ds.length > 1 ? "lines+markers" : "markers",
      line: { color: tone, width: 2.2, dash: DASHES[family] },
      marker: { color: tone, symbol: SYMBOLS[single ? "X" : family], size: single ? 11 : ds.length > 32 ? 6 : 8, line: { color: tone, width: single ? 2.5 : 0 } },
      cliponaxis: !single,
      ...(single && { texttemplate: name(family), textposition: plot.clientWidth < 500 ? "bottom center" : "middle right", textfont: { color: tone } }),
    };
  };
  const limits = (state) => {
    const found = new Map();
    LETTERS.filter((x) => shown(x, state) && scale(state).limits[x]).forEach((x) => {
      const key = scale(state).limits[x].join(" ");
      found.set(key, [...(found.get(key) ?? []), x]);
    });
    return [...found].map(([, families]) => {
      const [exact, decimal, q] = scale(state).limits[families[0]];
      const xs = range(0, 120).map((i) => 2 * (state.max / 2) ** (i / 120));
      const label = isScaled(state) ? exact : `${exact.includes("/") ? `(${exact})` : exact}/${power(state)}`;
      return {
        x: xs, y: xs.map((d) => (isScaled(state) ? Number(decimal) : Number(decimal) * d ** -exponent(q))), name: `limit ${label}`,
        mode: "lines+text", text: xs.map((_, i) => (i === 120 ? `  ${label}` : "")), textposition: "middle right", hoverinfo: "skip", cliponaxis: false,
        textfont: { color: colour("--cx-ink") }, line: { color: colour("--cx-ink"), width: 1.3, dash: "dash" },
      };
    });
  };
  const misprints = (state) => {
    const found = data.printed.filter((x) => x[0] === state.measure && x[1] === (state.raw ? "raw" : "normalised") && x[3] <= state.max && shown(x[2], state));
    const factor = (x) => (isScaled(state) ? x[3] ** exponent(Object.values(scale(state).limits)[0][2]) : 1);
    const gaps = {
      x: found.flatMap((x) => [x[3], x[3], null]), mode: "lines", hoverinfo: "skip", line: { color: colour("--cx-ink"), width: 1.3, dash: "1px,3px" },
      y: found.flatMap((x) => [height(entry(x[2], x[3], state), state), Number(x[5]) * factor(x), null]),
    };
    return [gaps, {
      x: found.map((x) => x[3]), y: found.map((x) => Number(x[5]) * factor(x)), customdata: found.map((x) => [x[2], x[3]]),
      text: found.map((x) => hover(x[2], x[3], state)), hovertemplate: "%{text}<extra></extra>", name: "wrong printed values", mode: "markers",
      marker: { symbol: "circle-open", size: 15, color: colour("--cx-ink"), line: { width: 1.8 } },
    }];
  };
  const crossing = (state) => measure(state).cross.filter(([pair, d]) => d <= state.max && [...pair].every((x) => shown(x, state)));
  const crossings = (state) => crossing(state).map(([pair, d]) => {
    const [p, q] = [...pair].map((x) => [d - 1, d].map((n) => height(entry(x, n, state), state)));
    const t = (p[0] - q[0]) / (p[0] - q[0] - p[1] + q[1]);
    const at = p[0] + t * (p[1] - p[0]);
    const log = (value, is) => (is ? Math.log10(value) : value);
    return {
      x: log(d - 1 + t, state.log), y: log(at, isLog(state)), text: `${[...pair].map(name).join(", ")} cross`,
      showarrow: true, arrowhead: 0, arrowcolor: colour("--cx-ink"), ax: 30, ay: isScaled(state) ? -64 : plot.clientWidth < 500 ? 108 : 64, font: { color: colour("--cx-ink") },
    };
  });
  const highest = (state) => Math.max(...[...LETTERS, ...SINGLE].filter((x) => shown(x, state))
    .flatMap((x) => points(x, state).map((d) => height(entry(x, d, state), state))), 0.01);
  const layout = (state) => {
    const axis = { ticklabeloverflow: "allow", color: colour("--cx-ink"), gridcolor: colour("--cx-grid"), zeroline: false, fixedrange: true };
    const words = `${state.raw ? measure(state).name : `normalised ${measure(state).title}`}${isScaled(state) ? `, times ${power(state)}` : ""}`;
    const narrow = plot.clientWidth < 500;
    const step = [1, 2, 4, 8].find((n) => state.max / n <= (narrow ? 9 : 16)) ?? 8;
    const ticks = range(2, state.max).filter((d) => (state.log ? state.max <= 12 || [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64].includes(d) : d === 2 || d % step === 0));
    const ends = [2 - state.max / 45, state.max + state.max / 45];
    return {
      margin: { l: narrow ? 46 : 52, r: state.limits ? 70 : 14, t: 14, b: 44 }, height: 430, showlegend: false, dragmode: false, hovermode: "closest",
      paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", font: { color: colour("--cx-ink"), size: narrow ? 12 : 13, family: getComputedStyle(figure).fontFamily },
      xaxis: { ...axis, title: { text: "dimension d" }, type: state.log ? "log" : "linear", tickvals: ticks, tickangle: 0, range: state.log ? [Math.log10(1.9), Math.log10(state.max * 1.06)] : ends },
      yaxis: { ...axis, title: { text: words }, type: isLog(state) ? "log" : "linear", exponentformat: "power", ...(isLog(state) || isScaled(state) ? {} : { range: [0, 1.06 * highest(state)] }) },
      shapes: [{ type: "line", x0: state.d, x1: state.d, yref: "paper", y0: 0, y1: 1, layer: "below", line: { color: colour("--cx-here"), width: 6 } }],
      annotations: crossings(state),
      hoverlabel: { bgcolor: colour("--cx-paper"), bordercolor: colour("--cx-ink"), font: { color: colour("--cx-ink"), family: getComputedStyle(figure).fontFamily }, align: "left" },
    };
  };
  /* What Plotly draws says nothing to a screen reader; the words beside it do. */
  const hush = (box) => [...box.querySelectorAll("svg, canvas"), ...document.querySelectorAll("#js-plotly-tester")]
    .forEach((drawn) => drawn.setAttribute("aria-hidden", "true"));
  const draw = (state) => {
    const curves = [...LETTERS, ...SINGLE].filter((x) => shown(x, state)).map((x) => curve(x, state));
    const traces = [...(state.limits ? limits(state) : []), ...curves, ...(state.printed ? misprints(state) : [])];
    return window.Plotly.react(plot, traces, layout(state), { displayModeBar: false, responsive: true, scrollZoom: false })
      .then((done) => { hush(plot); return done; });
  };

  /* -- in words -- */

  const plain = (equal) => equal.map(name).join(" = ");
  const span = ([a, b]) => (a === b ? `d = ${a}` : `d = ${a} to ${b}`);
  const greatest = (state) => {
    const runs = [];
    range(2, state.max).forEach((d) => {
      const best = order(d, state)[0];
      if (!best) return;
      const last = runs.at(-1);
      if (last && last[0] === plain(best) && last[1][1] === d - 1) last[1][1] = d;
      else runs.push([plain(best), [d, d]]);
    });
    return runs.map(([who, ds]) => `${who} for ${span(ds)}`).join("; ");
  };
  const summary = (state) => {
    const what = state.raw ? `${measure(state).name}, not normalised` : `Normalised ${measure(state).title}`;
    if (!state.families.length) return "No family is chosen.";
    const n = misprints(state)[1].x.length;
    const parts = [`${what[0].toUpperCase()}${what.slice(1)}, d = 2 to ${state.max}. Greatest of those shown: ${greatest(state)}.`];
    crossing(state).forEach(([pair, d]) => parts.push(`${[...pair].map(name).join(" and ")} cross between d = ${d - 1} and d = ${d}.`));
    parts.push(n ? `Wrong printed values: ${n}.` : "No wrong printed value.");
    if (!power(state)) parts.push("It falls faster than any power of d, so there is no limit curve.");
    return parts.join(" ");
  };
  const cell = (row, kind, text) => { const made = row.appendChild(document.createElement(kind)); made.textContent = text; return made; };
  const read = (state) => {
    const table = document.createElement("table");
    const head = table.createTHead().insertRow();
    ["type", "value", "exact"].forEach((text) => { cell(head, "th", text).scope = "col"; });
    const body = table.createTBody();
    order(state.d, state).flat().forEach((family) => {
      const value = entry(family, state.d, state);
      const row = body.insertRow();
      const label = cell(row, "th", "");
      label.scope = "row";
      label.innerHTML = `<i class="cx-swatch cx-${family in data.families ? family : "X"}" aria-hidden="true"></i> ${typed(family, state.d)}`;
      cell(row, "td", value[1]);
      const exact = cell(row, "td", value[0]);
      if (value[3]) {
        const full = exact.appendChild(document.createElement("details"));
        full.innerHTML = "<summary>in full</summary>";
        full.append(value[3]);
      }
      wrong(family, state.d, state).forEach((x) => {
        const printed = cell(body.insertRow(), "td", "printed ");
        printed.colSpan = 3;
        printed.className = "cx-printed";
        const link = printed.appendChild(document.createElement("a"));
        link.href = x[7];
        link.textContent = `${x[4]} (${x[6]})`;
      });
    });
    const told = order(state.d, state).map(plain).join(" > ") || "nothing is shown here";
    const line = document.createElement("p");
    line.textContent = told;
    one(".cx-values").replaceChildren(line, table);
    one("[name=at]").textContent = state.d;
    one("[name=d]").setAttribute("aria-valuetext", `d = ${state.d}: ${told}`);
  };
  const fits = (families, state) => families === "X" ? state.families.includes("X") : [...families].every((x) => state.families.includes(x));
  const sentences = (state) => {
    all(".cx-orders [data-measure]").forEach((part) => { part.hidden = part.dataset.measure !== state.measure; });
    all(".cx-orders li").forEach((item) => { item.hidden = !fits(item.dataset.families, state); });
    const items = all(".cx-wrong li");
    items.forEach((item) => {
      const here = item.dataset.measure === state.measure && item.dataset.scale === (state.raw ? "raw" : "normalised");
      item.hidden = !(here && fits(item.dataset.families, state));
    });
    one(".cx-none").hidden = items.some((item) => !item.hidden);
  };

  /* -- it all together -- */

  let timer;
  const show = (state) => {
    draw(state);
    read(state);
    sentences(state);
    form.elements.top.textContent = state.max;
    one("[name=d]").max = state.max;
    form.elements.scaled.disabled = !power(state);
    one(".cx-scale-words").textContent = `times ${power(state) || "a power of d"}`;
    clearTimeout(timer);
    timer = setTimeout(() => { one(".cx-summary").textContent = summary(state); }, 250);
  };
  const changed = () => { const state = fromControls(); toAddress(state); show(state); };
  const restore = () => { const state = fromAddress(); toControls(state); show(state); };
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", changed);
  reader.addEventListener("input", changed);
  addEventListener("hashchange", restore);
  [form, reader, plot].forEach((part) => { part.hidden = false; });
  figure.classList.add("cx-live");
  plot.setAttribute("role", "img");
  plot.setAttribute("aria-label", "Curves of the chosen measure; the summary above and the table of values below say in words what they show");
  restore();
  plot.on("plotly_click", (event) => {
    const point = event.points.find((x) => x.customdata);
    if (!point) return;
    one("[name=d]").value = point.customdata[1];
    changed();
  });
  new MutationObserver(() => show(fromControls())).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
})();
