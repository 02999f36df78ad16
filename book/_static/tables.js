/* Under each table: download it as CSV, JSON or LaTeX, unless a glance takes it in, and switch decimals to exact
   values. All is made here, from the table itself: a cell shows a decimal, and its title is the exact value. Without
   this script the title tells. */
(() => {
  "use strict";
  const GLANCE = 2; // rows below the head
  const OTHERS = ".lg-errata, [class*=lg-sheet-], .cx-explorer table, .highlighttable, .indextable, .cx-no-download";
  const BOXES = ".table-box, .lg-scroll, .pst-scrollable-table-container";
  const SIGNS = {
    "–": "--", "—": "---", "…": "\\dots{}", "≥": "$\\geq$", "≤": "$\\leq$", "≈": "$\\approx$", "≠": "$\\neq$",
    "×": "$\\times$", "·": "$\\cdot$", "∞": "$\\infty$", "−": "$-$", "→": "$\\to$", "′": "$'$", "√": "$\\surd$",
    "ℝ": "$\\mathbf{R}$", "±": "$\\pm$", "²": "$^2$", "‖": "$\\|$", "∈": "$\\in$", "∎": "$\\Box$", "\u00a0": "~",
    "°": "$^\\circ$", "⟨": "$\\langle$", "⟩": "$\\rangle$", "⁻": "$^-$", "¹": "$^1$", "³": "$^3$", "ι": "$\\iota$",
    "<": "$<$", ">": "$>$", "|": "$|$", "\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\^{}",
    "“": "``", "”": "''", "‘": "`", "’": "'",
  };
  "αalpha βbeta γgamma δdelta εvarepsilon ηeta θtheta κkappa λlambda μmu νnu ξxi πpi ρrho σsigma τtau φvarphi χchi ψpsi ωomega ΓGamma ΔDelta ΘTheta ΛLambda ΣSigma ΦPhi ΩOmega"
    .split(" ").forEach((word) => { SIGNS[word[0]] = `$\\${word.slice(1)}$`; });
  [..."₀₁₂₃₄₅₆₇₈₉"].forEach((digit, n) => { SIGNS[digit] = `$_${n}$`; });

  /* Text for LaTeX; of letters that it may not know the number is left. */
  const escaped = (text) => text.replaceAll("Ã", "A\u0303").replace(/([A-Za-z])\u0303/g, "\u0001$1\u0002").replace(/[&%$#_{}]/g, "\\$&")
    .replace(/[^\x01-\x7e]|[<>|^~]|\\(?![&%$#_{}])/g, (sign) => SIGNS[sign] ?? (/[\u00c0-\u017f]/.test(sign) ? sign : `[U+${sign.codePointAt(0).toString(16)}]`))
    .replace(/\u0001(.)\u0002/g, "$\\tilde{$1}$");

  /* A formula, with its Greek letters by name. */
  const formula = (tex) => `$${tex.replace(/[^\x01-\x7e]/g, (sign) => (SIGNS[sign] ? `{${SIGNS[sign].replaceAll("$", "")}}` : sign))}$`;

  /* An exact value, "2*sqrt(3)/9", in LaTeX, as the library writes it. */
  const exactTex = (text) => {
    const power = /^(.*)\*\*\(1\/(\d+)\)$/.exec(text);
    if (power) {
      const base = exactTex(power[1].replace(/^\((.*)\)$/, "$1"));
      return `${/^\d+$/.test(base) ? base : `\\left(${base}\\right)`}^{1/${power[2]}}`;
    }
    const roots = text.replace(/sqrt\((\d+)\)/g, "\\sqrt{$1}").replaceAll("*", "");
    const over = /^(?:\((.*)\)|([^()]*))\/\((.*)\)$/.exec(roots);
    if (over) return `\\frac{${fractions(over[1] ?? over[2])}}{${fractions(over[3])}}`;
    return fractions(roots);
  };
  const fractions = (text) => text.replace(/(\d*\\sqrt\{\d+\}|\d+)\/(\d+)/g, "\\frac{$1}{$2}");

  const sourceOf = (set) => {
    const list = window.MathJax?.startup?.document?.math ?? [];
    return [...list].find((item) => item.typesetRoot === set)?.math ?? set.textContent;
  };
  const KINDS = {
    plain: {
      text: (text) => text.replace(/\\\((.*?)\\\)/g, "$1").replaceAll("−", "-").replaceAll("Ã", "A~").replace(/([A-Za-z])\u0303/g, "$1~"),
      math: (tex) => tex,
      sub: (inner, before) => (/[A-Z]~$/.test(before) ? inner : inner && `_${inner}`),
      sup: (inner) => `^${inner}`,
    },
    latex: {
      text: (text) => text.split(/\\\((.*?)\\\)/).map((part, n) => (n % 2 ? formula(part) : escaped(part))).join(""),
      math: formula,
      sub: (inner) => inner && `$_{${inner.replaceAll("$", "")}}$`,
      sup: (inner) => `$^{${inner.replaceAll("$", "")}}$`,
    },
  };
  const read = (node, kind) => {
    let made = "";
    for (const child of node.childNodes) {
      if (child.nodeType === Node.TEXT_NODE) made += kind.text(child.nodeValue.replace(/\s+/g, " "));
      else if (child.nodeType !== Node.ELEMENT_NODE || child.matches("[aria-hidden=true], script, .headerlink")) continue;
      else if (child.localName === "br") made += " ";
      else if (child.localName === "mjx-container") made += kind.math(sourceOf(child));
      else if (child.localName === "sub" || child.localName === "sup") made += kind[child.localName](read(child, kind), made);
      else made += read(child, kind);
    }
    return made.replace(/\$\$/g, "").trim();
  };
  /* Commas between thousands are for eyes. */
  const number = (text) => (/^\d{1,3}(,\d{3})+(\.\d+)?$/.test(text) ? text.replaceAll(",", "") : text);
  /* A cell is {text, tex}, and if it has an exact value {exact} too. */
  const cell = (td, exact) => {
    const value = td.title && td.closest(".table-box") ? td.title : "";
    if (!value) return { text: td.dataset.text ?? number(read(td, KINDS.plain)), tex: read(td, KINDS.latex) };
    const decimal = td.dataset.decimal ?? td.textContent;
    return { exact: value, decimal, text: exact ? value : decimal, tex: exact ? `$${exactTex(value)}$` : decimal };
  };
  const rowsOf = (table, exact) => [...table.rows].map((row) => [...row.cells].map((td) => cell(td, exact)));
  const title = (table) => {
    const box = table.closest(".lg-scroll[aria-label]");
    const head = table.caption ?? table.closest("section")?.querySelector("h1, h2, h3");
    return box?.ariaLabel || (head && read(head, KINDS.plain).replace(/\\tilde ([A-Z])/g, "$1~")) || "Table";
  };

  const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const write = {
    csv: (rows) => rows.map((row) => row.map((x) => quoted(x.text)).join(",")).join("\n"),
    json: (rows, name, heads) => {
      const names = heads ? rows[0].map((x) => x.text) : [];
      const value = (x) => JSON.stringify(x.exact ? { exact: x.exact, decimal: x.decimal } : x.text || null);
      const named = names.length && names.every(Boolean) && new Set(names).size === names.length;
      const object = (row) => `{${row.map((x, n) => `${JSON.stringify(names[n] ?? n)}: ${value(x)}`).join(", ")}}`; // in order
      const lines = rows.slice(heads).map((row) => (named ? object(row) : `[${row.map(value).join(", ")}]`));
      const head = heads && !named ? ` "header": ${JSON.stringify(names)},\n` : "";
      return `{\n "title": ${JSON.stringify(name)},\n${head} "rows": [\n  ${lines.join(",\n  ")}\n ]\n}`;
    },
    tex: (rows, name, heads) => {
      const columns = Math.max(...rows.map((row) => row.length));
      const lines = rows.map((row) => `${row.map((x) => x.tex.replace(/^\[/, "{}[") || "--").join(" & ")} \\\\`);
      lines.splice(heads, 0, ...(heads ? ["\\hline"] : []));
      return [`\\begin{tabular}{l${"c".repeat(columns - 1)}}`, "\\hline", ...lines, "\\hline", "\\end{tabular}"].join("\n");
    },
  };
  const TYPES = { csv: "text/csv", json: "application/json", tex: "application/x-tex" };
  const save = (table, end, exact) => {
    const name = title(table);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([`${write[end](rowsOf(table, exact), name, Number(Boolean(table.tHead)))}\n`], { type: `${TYPES[end]};charset=utf-8` }));
    link.download = `${name.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 60) || "table"}.${end}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  };

  const button = (words, action) => {
    const made = Object.assign(document.createElement("button"), { type: "button", textContent: words });
    made.addEventListener("click", () => action(made));
    return made;
  };
  /* Exact values in place of decimals, for those as well whose pointer cannot rest on a cell. */
  const swap = (table, exact) => {
    const cells = [...table.querySelectorAll("td[title]")];
    cells.forEach((td) => {
      td.dataset.decimal ??= td.textContent;
      td.innerHTML = exact ? `<span class="math notranslate nohighlight">\\(${exactTex(td.title)}\\)</span>` : td.dataset.decimal;
    });
    if (exact) window.MathJax?.typesetPromise?.(cells).catch(console.error);
  };
  document.querySelectorAll("article table").forEach((table) => {
    if (table.closest(OTHERS) || !table.rows.length) return;
    const tools = Object.assign(document.createElement("div"), { className: "cx-table-tools" });
    tools.setAttribute("role", "group");
    tools.setAttribute("aria-label", `The table: ${title(table)}`);
    let exact = false;
    if (table.rows.length - (table.tHead?.rows.length ?? 0) > GLANCE) {
      tools.append("Download: ", ...[["CSV", "csv"], ["JSON", "json"], ["LaTeX", "tex"]].map(([words, end]) => button(words, () => save(table, end, exact))));
    }
    if (table.closest(".table-box")?.querySelector("td[title]")) {
      const exactly = button("Exact values", (made) => {
        exact = !exact;
        made.setAttribute("aria-pressed", exact);
        swap(table, exact);
      });
      exactly.setAttribute("aria-pressed", "false");
      tools.append(exactly);
    }
    if (tools.hasChildNodes()) (table.closest(BOXES) ?? table).after(tools);
  });
})();
