/* Pictures to turn. Each figure of the class cx-scene brings a drawing, its numbers as text, and the data of a
   picture in space. This script puts the picture and its controls in the place of the drawing. Without it, on paper,
   and where a browser has no WebGL, the drawing stays. */
(() => {
  "use strict";

  const SIGNS = ["circle", "square", "diamond", "cross"];
  const KEYS = ["●", "■", "◆", "✚"];
  const LOW = "₀₁₂₃";
  const FACES = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];
  const PAIRS = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
  const HALF = 4; // half the range of the axes: more than anything reaches
  const still = matchMedia("(prefers-reduced-motion: reduce)");

  /* -- vectors -- */

  const add = (a, b, t = 1) => a.map((x, i) => x + t * b[i]);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const size = (a) => Math.sqrt(dot(a, a));
  const unit = (a) => a.map((x) => x / size(a));
  const mean = (points) => points.reduce((sum, p) => add(sum, p)).map((x) => x / points.length);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const between = (p, q, t) => add(p, add(q, p, -1), t);
  const columns = (points) => ({ x: points.map((p) => p && p[0]), y: points.map((p) => p && p[1]), z: points.map((p) => p && p[2]) });
  const turns = (n) => Array.from({ length: n }, (_, i) => (2 * Math.PI * i) / n);

  /* Two unit vectors across a given one. */
  const across = (n) => {
    const a = unit(cross(n, Math.abs(n[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
    return [a, cross(n, a)];
  };

  /* A vector, turned about a unit vector. */
  const turned = (a, n, t) => add(add(a.map((x) => x * Math.cos(t)), cross(n, a), Math.sin(t)), n, dot(n, a) * (1 - Math.cos(t)));

  /* -- traces of the plotting library -- */

  const plain = { hoverinfo: "skip", showlegend: false };

  const MATT = { ambient: 1, diffuse: 0, specular: 0, fresnel: 0 };

  const mesh = (points, triangles, color, opacity, more = {}) => ({
    ...plain, ...columns(points), type: "mesh3d", color, opacity, flatshading: true,
    i: triangles.map((t) => t[0]), j: triangles.map((t) => t[1]), k: triangles.map((t) => t[2]),
    lighting: { ambient: 0.7, diffuse: 0.48, specular: 0.06, roughness: 0.9, fresnel: 0.02 }, ...more,
  });

  const tetrahedra = (solids, color, opacity, more) => mesh(
    solids.flat(), solids.flatMap((_, n) => FACES.map((face) => face.map((k) => 4 * n + k))), color, opacity, more);

  const lines = (paths, color, width, more = {}) => ({
    ...plain, ...columns(paths.flatMap((path) => [...path, null])), type: "scatter3d", mode: "lines", line: { color, width, ...more },
  });

  const edges = (solids) => solids.flatMap((solid) => PAIRS.map((pair) => pair.map((k) => solid[k])));

  const marks = (points, symbol, color, width) => ({
    ...plain, ...columns(points), type: "scatter3d", mode: "markers",
    marker: { symbol, color, size: width, opacity: 1, line: { color, width: 1.5 } },
  });

  const ball = (centre, radius, color, opacity) => {
    const rows = Array.from({ length: 33 }, (_, i) => (Math.PI * i) / 32);
    const ring = [...turns(64), 2 * Math.PI];
    const grid = (f) => rows.map((v) => ring.map((u) => f(u, v)));
    const none = { highlight: false };
    return {
      ...plain, type: "surface", opacity, showscale: false, colorscale: [[0, color], [1, color]],
      x: grid((u, v) => centre[0] + radius * Math.sin(v) * Math.cos(u)),
      y: grid((u, v) => centre[1] + radius * Math.sin(v) * Math.sin(u)),
      z: grid((_, v) => centre[2] + radius * Math.cos(v)),
      contours: { x: none, y: none, z: none },
      lighting: { ambient: 0.75, diffuse: 0.35, specular: 0.25, roughness: 0.5 },
    };
  };

  const circle = (centre, radius, normal) => {
    const [a, b] = across(normal);
    return [...turns(64), 0].map((t) => add(add(centre, a, radius * Math.cos(t)), b, radius * Math.sin(t)));
  };

  const disc = (centre, radius, normal, color, opacity) => {
    const rim = circle(centre, radius, normal);
    const fan = rim.slice(1).map((_, i) => [0, i + 1, i + 2]);
    return [mesh([centre, ...rim], fan, color, opacity, { lighting: MATT }), lines([rim], color, 2)];
  };

  /* An arrow that ends in a point. */
  const arrow = (tip, along, length, color) => {
    const neck = add(tip, along, -0.25 * length);
    const rim = circle(neck, 0.075 * length, along).slice(0, -1).filter((_, i) => i % 4 === 0);
    const sides = rim.flatMap((_, i) => [[0, 2 + i, 2 + ((i + 1) % rim.length)], [1, 2 + i, 2 + ((i + 1) % rim.length)]]);
    return [lines([[add(tip, along, -length), neck]], color, 5), mesh([tip, neck, ...rim], sides, color, 1, { lighting: MATT })];
  };

  /* -- elements -- */

  const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
    element.append(...children);
    return element;
  };

  const colours = () => {
    const style = getComputedStyle(document.documentElement);
    const dark = document.documentElement.dataset.theme === "dark";
    const ink = style.getPropertyValue("--pst-color-text-base").trim() || (dark ? "#ddd" : "#222");
    const ground = style.getPropertyValue("--pst-color-background").trim() || (dark ? "#121212" : "#fff");
    return {
      ink, ground,
      labels: dark ? ["#4FA3E3", "#FF8533", "#E08FC0", ink] : ["#0072B2", "#D55E00", "#B24C86", ink],
      simplex: dark ? "#1FB88A" : "#009E73",
      tones: dark ? ["#5E9CCB", "#D9A355"] : ["#6FA9D6", "#E8B666"],
      rim: dark ? "#0B1014" : "#22303C",
      sphere: dark ? "#4FA3E3" : "#0072B2",
      inner: dark ? "#FF8533" : "#D55E00",
    };
  };

  const SHOWN = {
    simplex: "Fundamental simplex",
    circumsphere: "Circumsphere",
    circumcentre: "Circumcentre, radii",
    incentre: "Incentre, insphere",
    normals: "Facet normals",
    mirrors: "Mirrors of the facets",
    apexes: "Apexes of neighbours",
    patch: "Simplices around a vertex",
  };

  const TURNS = { ArrowLeft: ["←", "Turn to the left", -1, 0], ArrowUp: ["↑", "Turn upwards", 0, 1],
    ArrowDown: ["↓", "Turn downwards", 0, -1], ArrowRight: ["→", "Turn to the right", 1, 0] };
  const STEP = Math.PI / 24;

  let count = 0;

  /* -- one picture -- */

  /* What Plotly draws says nothing to a screen reader; the words beside it do. */
  const hush = (box) => [...box.querySelectorAll("svg, canvas"), ...document.querySelectorAll("#js-plotly-tester")]
    .forEach((drawn) => drawn.setAttribute("aria-hidden", "true"));

  class Picture {
    constructor(figure) {
      this.figure = figure;
      this.data = JSON.parse(figure.querySelector("script[type='application/json']").textContent);
      this.start = { simplex: true, circumsphere: true, circumcentre: true, incentre: false, normals: false, mirrors: false,
        apexes: false, patch: false, through: false, star: this.data.around, apart: 0, shown: Infinity, step: null, zoom: 1 };
      this.state = { ...this.start };
      this.own = this.data.alcoves[this.star.alcoves[0]].map((n) => this.data.points[n]);
      this.build();
      this.face();
    }

    get star() { return this.data.stars[this.state.star]; }

    build() {
      const id = `cx-help-${count += 1}`;
      const keys = "A finger begins sideways, as up and down scroll the page. Arrow keys turn it too, plus and minus change its size, 0 sets it back.";
      this.stage = make("div", { class: "cx-stage", tabindex: 0, role: "application",
        "aria-label": `${this.data.title}: a picture to turn`, "aria-describedby": id });
      this.says = make("output", { class: "cx-says" }, this.data.told.circumcentre);
      const help = make("p", { class: "cx-help", id }, `Drag to turn. ${keys}`);
      const key = make("p", { class: "cx-key" }, "Marks: ");
      KEYS.forEach((sign, k) => key.append(make("span", {}, make("span", { class: `cx-label-${k}`, "aria-hidden": "true" }, sign), ` u${LOW[k]}`), " "));
      key.append(make("span", {}, make("span", { class: "cx-outer", "aria-hidden": "true" }, "○"), " c circumcentre"), " ",
        make("span", {}, make("span", { class: "cx-inner", "aria-hidden": "true" }, "×"), " i incentre"));
      const left = make("div", { class: "cx-left" }, this.stage, key, this.says, help);
      this.turn = make("div", { class: "cx-turn" }, left, this.panel());
      this.figure.prepend(this.turn);
      this.figure.classList.add("cx-live");
      this.stage.addEventListener("keydown", (event) => this.pressed(event));
      ["wheel", "touchstart", "touchmove"].forEach((kind) => this.stage.addEventListener(kind, (event) => event.stopPropagation(),
        { capture: true, passive: true })); // else Plotly would keep the page from scrolling
      this.dragged();
      new ResizeObserver(() => this.later()).observe(this.stage);
    }

    panel() {
      this.boxes = {};
      const shown = this.group("Show", ...Object.entries(SHOWN).map(([name, words]) => this.box(name, words)));
      const select = make("select");
      this.data.stars.forEach((star, k) => select.append(make("option", { value: k }, `u${LOW[k]} (${star.alcoves.length} simplices)`)));
      select.value = this.state.star;
      select.addEventListener("change", () => this.around(Number(select.value)));
      this.slider = make("input", { type: "range", min: 0, max: 1.5, step: 0.05, value: 0 });
      this.slider.addEventListener("input", () => this.apart(Number(this.slider.value)));
      this.select = select;
      const through = this.box("through", "See through them");
      through.classList.add("cx-wide");
      const patch = this.group("Simplices around a vertex", make("label", { class: "cx-wide" }, "Around", select),
        make("label", { class: "cx-wide" }, "Explode", this.slider), through);
      const steps = this.group("Reflections one by one", this.button("Start", () => this.step(1)), this.button("Back", () => this.step(this.count - 1)),
        this.button("Next", () => this.step(this.count + 1)), this.button("All", () => this.step(Infinity)));
      const ways = Object.values(TURNS).map(([sign, words, ...turn]) => this.button(sign, () => this.rotate(...turn.map((t) => t * STEP)), words));
      const view = this.group("View", make("div", { class: "cx-row" }, ...ways), make("div", { class: "cx-row" },
        this.button("Nearer", () => this.zoom(1.2)), this.button("Farther", () => this.zoom(1 / 1.2)), this.button("Reset", () => this.reset())));
      steps.classList.add("cx-row");
      return make("div", { class: "cx-panel" }, shown, patch, steps, view);
    }

    group(words, ...children) { return make("fieldset", {}, make("legend", {}, words), ...children); }

    button(words, done, name) {
      const button = make("button", { type: "button", ...(name && { "aria-label": name, title: name }) }, words);
      button.addEventListener("click", done);
      return button;
    }

    box(name, words) {
      const box = make("input", { type: "checkbox" });
      box.checked = this.state[name];
      box.addEventListener("change", () => this.toggle(name, box.checked));
      this.boxes[name] = box;
      return make("label", {}, box, ` ${words}`);
    }

    /* -- what the controls do -- */

    say(words) { this.says.textContent = words; }

    /* With the first simplices around a vertex, what they would hide is put away. */
    set(changes) {
      const away = changes.patch && !this.state.patch ? { circumsphere: false, circumcentre: false, apexes: false } : {};
      Object.assign(this.state, away, changes);
      Object.entries(this.boxes).forEach(([name, box]) => { box.checked = this.state[name]; });
      this.slider.value = this.state.apart;
      this.select.value = this.state.star;
      this.later();
    }

    toggle(name, on) {
      const words = name === "patch" ? `${this.star.about}.` : this.data.told[name];
      this.set({ [name]: on, ...(name === "patch" ? { shown: Infinity, step: null } : {}), ...(name === "through" && on ? { patch: true } : {}) });
      if (words) this.say(on ? words : `${SHOWN[name]}: hidden.`);
    }

    around(star) {
      this.set({ star, patch: true, shown: Infinity, step: null });
      this.say(`${this.star.about}.`);
    }

    apart(apart) { this.set({ apart, patch: true }); }

    /* How many simplices are shown. */
    get count() { return this.state.patch ? Math.min(this.state.shown, this.star.alcoves.length) : 1; }

    step(to) {
      const all = this.star.alcoves.length;
      const wanted = to === Infinity ? all : Math.min(Math.max(to, 1), all);
      const forward = wanted === this.count + 1;
      const step = to === Infinity || wanted === 1 ? null : wanted - 2;
      this.set({ patch: true, shown: wanted, step });
      if (forward && !still.matches) this.fly(step);
      this.say(step === null ? (wanted === 1 ? `The fundamental simplex. ${this.data.told.simplex}` : `${this.star.about}.`) : this.star.told[step]);
    }

    zoom(factor) { this.set({ zoom: Math.min(Math.max(this.state.zoom * factor, 0.3), 5) }); }

    face() {
      this.eye = this.data.towards.map((t) => 2.6 * t);
      this.up = [0, 0, 1];
    }

    reset() {
      this.face();
      this.set({ zoom: 1 });
    }

    pressed(event) {
      const [, , ...turn] = TURNS[event.key] ?? [];
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (turn.length) this.rotate(...turn.map((t) => t * (event.shiftKey ? STEP / 4 : STEP)));
      else if (event.key === "+" || event.key === "=") this.zoom(1.1);
      else if (event.key === "-") this.zoom(1 / 1.1);
      else if (event.key === "0" || event.key === "Home") this.reset();
      else return;
      event.preventDefault();
    }

    /* A pointer turns the picture by half a turn from side to side. The style leaves a finger's ways up and down to
       the page, unless it began sideways. */
    dragged() {
      let at = null;
      this.stage.addEventListener("pointerdown", (event) => {
        if (!event.isPrimary || event.button) return;
        at = [event.clientX, event.clientY, event.pointerType === "touch" ? 8 : 0];
        this.stage.setPointerCapture(event.pointerId);
      });
      this.stage.addEventListener("pointermove", ({ isPrimary, clientX, clientY }) => {
        if (!at || !isPrimary || Math.abs(clientX - at[0]) < at[2]) return;
        this.rotate(...[clientX - at[0], at[1] - clientY].map((t) => (t * Math.PI) / this.stage.clientWidth));
        at = [clientX, clientY, 0];
      });
      ["pointerup", "pointercancel"].forEach((kind) => this.stage.addEventListener(kind, () => { at = null; }));
    }

    /* What is in front goes to the right, and upwards; no direction is special, so it turns on and on. */
    rotate(right, up) {
      const [side, above] = this.screen;
      const eye = turned(turned(this.eye, above, -right), side, up);
      this.up = turned(above, side, up);
      this.eye = eye;
      this.later();
    }

    /* The directions to the right and upwards on the screen. */
    get screen() {
      const side = unit(cross(this.up, this.eye));
      return [side, unit(cross(this.eye, side))];
    }

    /* -- what is drawn -- */

    /* The corners of a simplex of the star, moved away from the fundamental one, which stays. */
    solid(n) {
      const corners = this.data.alcoves[this.star.alcoves[n]].map((i) => this.data.points[i]);
      const shift = add(mean(corners), mean(this.own), -1).map((x) => this.state.apart * x);
      return corners.map((corner) => add(corner, shift));
    }

    get centre() {
      const centre = this.data.points[this.star.centre];
      return this.state.patch ? add(centre, add(centre, mean(this.own), -1), this.state.apart) : this.data.circumcentre;
    }

    /* The light comes over the viewer's left shoulder. */
    traces() {
      const [right, up] = this.screen;
      const light = add(add(unit(this.eye), right, -0.45), up, 0.6).map((t) => 1e5 * t);
      const lightposition = { x: light[0], y: light[1], z: light[2] };
      return this.things().map((trace) => (/mesh3d|surface/.test(trace.type) ? { ...trace, lightposition } : trace));
    }

    things() {
      const { state, data } = this;
      const c = colours();
      const found = [];
      if (state.patch) found.push(...this.patch(c));
      if (state.simplex) {
        found.push(tetrahedra([this.own], c.simplex, state.patch && !state.through ? 1 : 0.42), lines(edges([this.own]), c.simplex, 6));
      }
      this.own.forEach((corner, k) => found.push(marks([corner], SIGNS[k], c.labels[k], 7)));
      if (state.circumsphere) {
        const { circumcentre: at, circumradius: r } = data;
        found.push(ball(at, r, c.sphere, 0.13), lines([[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((n) => circle(at, r, n)), c.sphere, 1.5));
      }
      if (state.circumcentre) {
        found.push(lines(this.own.map((corner) => [data.circumcentre, corner]), c.sphere, 3, { dash: "dash" }));
        found.push(marks([data.circumcentre], "circle-open", c.sphere, 8));
      }
      if (state.incentre) {
        found.push(ball(data.incentre, data.inradius, c.inner, 0.4), marks([data.incentre], "x", c.inner, 4));
      }
      if (state.normals) found.push(...this.normals(c));
      if (state.mirrors) data.walls.forEach((wall, k) => found.push(...this.mirror(wall, mean(this.own), 0.95 * data.circumradius, c.labels[k], 0.16)));
      this.apexes.forEach((apex) => found.push(...this.apex(c, apex)));
      return found;
    }

    patch(c) {
      const opacity = this.state.through ? 0.12 : 1;
      const flying = this.flying && this.state.step;
      const ids = Array.from({ length: this.count }, (_, n) => n).slice(1).filter((n) => n !== flying + 1 || !this.flying);
      const groups = [0, 1].map((odd) => ids.filter((n) => this.star.odd[n] === odd).map((n) => this.solid(n)));
      const found = groups.map((solids, odd) => tetrahedra(solids, c.tones[odd], opacity)).filter((_, odd) => groups[odd].length);
      const all = groups.flat();
      if (all.length) found.push(lines(edges(all), c.rim, this.state.through ? 1.5 : 2.5));
      if (this.flying) found.push(tetrahedra([this.flying], c.tones[this.star.odd[flying + 1]], 0.8), lines(edges([this.flying]), c.rim, 3));
      SIGNS.forEach((sign, k) => { if (all.length) found.push(marks(all.map((solid) => solid[k]), sign, c.labels[k], 4)); });
      if (this.state.step !== null) {
        if (!this.flying) found.push(lines(edges([this.solid(this.state.step + 1)]), c.ink, 6));
        const [, facet, mirror] = this.star.steps[this.state.step];
        found.push(...disc(this.centre, 0.9 * this.span, this.data.mirrors[mirror].slice(0, 3), c.labels[facet], 0.3));
      }
      return found;
    }

    /* A disc in a plane, around the point of the plane that is nearest to a given one. */
    mirror([x, y, z, k], near, radius, color, opacity) {
      const n = [x, y, z];
      return disc(add(near, n, k - dot(n, near)), radius, n, color, opacity);
    }

    normals(c) {
      return this.arrows.flatMap(({ tip, along, length }, k) => arrow(tip, along, length, c.labels[k]));
    }

    get arrows() {
      const longest = Math.max(...this.data.normals.map(size));
      return this.data.normals.map((normal, k) => ({ tip: mean(FACES[k].map((i) => this.own[i])), along: unit(normal),
        length: (0.75 * this.data.circumradius * size(normal)) / longest }));
    }

    /* The apexes of neighbours; with the circumsphere come those that lie in it or on it. */
    get apexes() {
      return this.data.apexes.filter(({ where }) => this.state.apexes || (this.state.circumsphere && where !== "outside"));
    }

    apex(c, { at, label, where }) {
      const near = where !== "outside";
      return [
        lines(FACES[label].map((k) => [this.own[k], at]), c.labels[label], near ? 3 : 1.5, { dash: near ? "solid" : "dot" }),
        marks([at], label === 3 ? "cross" : `${SIGNS[label]}-open`, c.labels[label], near ? 9 : 6),
      ];
    }

    /* The new simplex on its way through the mirror. */
    fly(step) {
      const [parent] = this.star.steps[step];
      const [from, to] = [this.solid(parent), this.solid(step + 1)];
      const began = performance.now();
      const frame = (now) => {
        const t = Math.min(Math.max((now - began) / 500, 0), 1);
        const going = t < 1 && this.state.step === step;
        this.flying = going ? from.map((corner, k) => between(corner, to[k], t * t * (3 - 2 * t))) : null;
        this.draw();
        if (going) requestAnimationFrame(frame);
      };
      this.flying = from;
      requestAnimationFrame(frame);
    }

    /* How far from the centre the simplices reach, all of them, also before they are shown. */
    get span() {
      const points = this.state.patch ? this.star.alcoves.flatMap((_, n) => this.solid(n)) : this.own;
      return this.farthest(points);
    }

    farthest(points) { return Math.max(...points.map((point) => size(add(point, this.centre, -1)))); }

    /* All that is drawn lies in a ball around the centre, and the ball fits into the stage. */
    layout(traces) {
      const c = colours();
      const shown = traces.flatMap(({ x, y, z }) => x.flat().map((_, i) => [x, y, z].map((t) => t.flat()[i])).filter(([t]) => t !== null));
      const reach = Math.max(this.span, this.farthest(shown));
      const narrow = Math.min(1, this.stage.clientWidth / this.stage.clientHeight || 1);
      const scale = (1.7 * HALF * narrow * this.state.zoom) / reach;
      const axis = (i) => ({ visible: false, showspikes: false, range: [this.centre[i] - HALF, this.centre[i] + HALF] });
      const [eye, up] = [this.eye, this.up].map(([x, y, z]) => ({ x, y, z }));
      return {
        margin: { l: 0, r: 0, t: 0, b: 0 }, paper_bgcolor: c.ground, showlegend: false, hovermode: false,
        font: { family: "Arial, 'Liberation Sans', Helvetica, sans-serif" },
        scene: { xaxis: axis(0), yaxis: axis(1), zaxis: axis(2), bgcolor: c.ground, dragmode: false, annotations: this.names(c),
          camera: { eye, up, center: { x: 0, y: 0, z: 0 } }, aspectmode: "manual", aspectratio: { x: scale, y: scale, z: scale } },
      };
    }

    /* The names of points stand in front of everything, on the side of their point that is away from the simplex. */
    names({ ink }) {
      const { state, data, screen } = this;
      const aside = [
        ...this.own.map((corner, k) => [corner, `u${LOW[k]}`]),
        ...this.apexes.map(({ at, label }) => [at, `s${LOW[label]}(u${LOW[label]})`]),
        ...(state.normals ? this.arrows.map(({ tip, along, length }, k) => [add(tip, along, -length), `n${LOW[k]}`]) : []),
      ].map(([at, words]) => {
        const [x, y] = screen.map((axis) => dot(axis, add(at, mean(this.own), -1)));
        const r = Math.hypot(x, y) || 1;
        return [at, words, ((10 + 4 * words.length) * x) / r, (18 * y) / r];
      });
      const centres = [...(state.circumcentre ? [[data.circumcentre, "c", 0, -17]] : []), ...(state.incentre ? [[data.incentre, "i", 0, 17]] : [])];
      return [...aside, ...centres].map(([[x, y, z], text, xshift, yshift]) => ({ x, y, z, text, xshift, yshift, showarrow: false, font: { color: ink, size: 15 } }));
    }

    draw() {
      if (!this.ready) return;
      const traces = this.traces();
      Plotly.react(this.stage, traces, this.layout(traces), { displayModeBar: false, scrollZoom: false }).then(() => hush(this.stage));
    }

    later() {
      this.waiting ??= requestAnimationFrame(() => {
        this.waiting = null;
        if (!this.flying) this.draw();
      });
    }

    /* Called when the picture comes near the window. */
    show() {
      this.ready = true;
      this.draw();
    }
  }

  /* -- all pictures of the page -- */

  const hasWebGL = () => {
    try {
      const canvas = document.createElement("canvas");
      return Boolean(canvas.getContext("webgl2") || canvas.getContext("webgl"));
    } catch { return false; }
  };

  const start = () => {
    const figures = [...document.querySelectorAll("figure.cx-scene")];
    if (!figures.length) return;
    if (!window.Plotly || !hasWebGL()) {
      const words = "This browser shows no pictures in space (it lacks WebGL), so a drawing stands here.";
      figures.forEach((figure) => figure.querySelector(".cx-still").after(make("p", { class: "cx-note" }, words)));
      return;
    }
    const pictures = new Map(figures.map((figure) => [figure, new Picture(figure)]));
    const observer = new IntersectionObserver((entries) => entries.filter((entry) => entry.isIntersecting).forEach((entry) => {
      observer.unobserve(entry.target);
      pictures.get(entry.target).show();
    }), { rootMargin: "300px" });
    figures.forEach((figure) => observer.observe(figure));
    new MutationObserver(() => pictures.forEach((picture) => picture.later()))
      .observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  };

  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
  else start();
})();
