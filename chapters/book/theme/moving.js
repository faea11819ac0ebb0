// Figures that move. What is drawn is the chapter's own C++, compiled to WebAssembly: this script
// passes settings in and puts the picture up. Without it, or where it fails, the still picture stays.
const tumbleMoving = (function () {
  const folder = document.currentScript.src.replace(/[^/]*$/, "moving/");
  const arrivals = {}; // module → who waits for its bytes
  const modules = {}; // its name → a promise of it

  // ── A figure's module ──

  function unpack(base64) {
    const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  }

  async function instantiate(base64) {
    let memory;
    const text = (place, length) => new TextDecoder().decode(new Uint8Array(memory.buffer, place, length));
    const numbers = (place, count) => new Float64Array(memory.buffer, place, count);
    const tumble_refused = (place, length) => { throw new Error(text(place, length)); };
    const { instance: { exports: c } } = await WebAssembly.instantiate(await unpack(base64), { env: { tumble_refused } });
    memory = c.memory;
    c._initialize();
    return {
      declaration: () => JSON.parse(text(c.declaration(), c.text_size())),
      draw: () => text(c.draw(), c.text_size()),
      drag: c.drag,
      question: () => [...numbers(c.question(), c.numbers_size())],
      take: (answer) => (numbers(c.room(answer.length), answer.length).set(answer), c.take()),
      // A view of the memory, made anew each time: it moves when the memory grows.
      settings: (count) => numbers(c.settings(), count),
    };
  }

  function load(name) {
    modules[name] ??= new Promise((resolve, reject) => {
      arrivals[name] = (base64) => instantiate(base64).then(resolve, reject);
      const script = document.createElement("script");
      script.src = folder + name + ".js";
      script.onerror = () => reject(new Error(script.src + " is missing"));
      document.head.append(script);
    });
    return modules[name];
  }

  // ── The controls of a figure ──

  function made(tag, properties, ...children) {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  }

  function shown(control, value) {
    const digits = Math.max(0, Math.ceil(-Math.log10(control.step) - 1e-9));
    return value.toFixed(digits).replace("-", "−") + (control.unit ? " " + control.unit : "");
  }

  function field(control, changed) {
    const id = "control-" + Math.random().toString(36).slice(2);
    const label = made("label", { htmlFor: id }, control.label);
    if (control.choices) {
      const options = control.choices.split("|").map((name, i) => made("option", { value: i }, name));
      const select = made("select", { id, onchange: () => changed(+select.value) }, ...options);
      return { row: made("div", {}, label, select), show: (value) => (select.value = value) };
    }
    const { least: min, most: max, step } = control;
    const range = made("input", { id, type: "range", min, max, step, oninput: () => changed(+range.value) });
    const output = made("output", { htmlFor: id });
    const show = (value) => {
      range.value = value;
      output.value = shown(control, value);
      range.setAttribute("aria-valuetext", output.value);
    };
    return { row: made("div", {}, label, range, output), show };
  }

  // ── A figure of the page ──

  class Figure {
    constructor(place, chapter, name, module) {
      const declared = module.declaration(), { controls } = declared;
      Object.assign(this, { place, chapter, name, module, declared, controls, playing: false, seen: true });
      this.fields = this.controls.map((control, k) => field(control, (value) => this.set(k, value)));
      this.fields.forEach(({ show }, k) => show(this.controls[k].start));
      (place.closest(".scroll") ?? place).after((this.panel = this.makePanel())); // it stays where a wide picture scrolls
      if (this.declared.drags) this.listen();
    }

    settings() {
      return this.module.settings(this.controls.length);
    }

    makePanel() {
      const button = (text, onclick) => made("button", { type: "button", onclick }, text);
      const buttons = made("div", { className: "moving-buttons" });
      if (this.declared.plays >= 0) {
        this.playButton = button("Play", () => this.play(!this.playing));
        buttons.append(this.playButton, button("Step", () => this.advance(this.controls[this.declared.plays].step)));
      }
      buttons.append(button("Reset", () => this.reset()));
      const properties = { className: "moving-panel", role: "group", ariaLabel: "Controls of the figure" };
      return made("div", properties, buttons, ...this.fields.map((each) => each.row));
    }

    set(k, value) {
      this.settings()[k] = value;
      this.changed();
    }

    reset() {
      this.play(false);
      this.settings().set(this.controls.map((control) => control.start));
      this.changed();
      if (location.hash.startsWith("#figure=")) history.replaceState(null, "", location.pathname);
    }

    changed() {
      this.onchange?.();
      this.draw();
      clearTimeout(this.link);
      if (!this.playing) this.link = setTimeout(() => this.writeLink(), 300);
    }

    // The style of all figures is in the page once: a new one in each frame would make the browser
    // look at every element of the page again.
    draw() {
      this.place.innerHTML = this.module.draw().replace(/<style>[^]*?<\/style>/, "");
      this.settings().forEach((value, k) => this.fields[k].show(value));
    }

    // The settings are in the address, so that a link leads to them.
    writeLink() {
      const settings = this.settings();
      const values = this.controls.map((control, k) => "&" + control.name + "=" + +settings[k].toFixed(6));
      history.replaceState(null, "", "#figure=" + this.name + values.join(""));
    }

    readLink() {
      const wanted = new URLSearchParams(location.hash.slice(1));
      if (wanted.get("figure") !== this.name) return false;
      const settings = this.settings();
      this.controls.forEach((control, k) => {
        const value = wanted.has(control.name) ? +wanted.get(control.name) : NaN;
        if (value >= control.least && value <= control.most) settings[k] = value;
      });
      this.draw();
      this.place.scrollIntoView({ block: "center" });
      return true;
    }

    play(on) {
      this.playing = on;
      if (this.playButton) this.playButton.textContent = on ? "Pause" : "Play";
      if (!on) return;
      const k = this.declared.plays, { start, least } = this.controls[k];
      if (this.settings()[k] === start) this.set(k, least); // not from where nothing moves any more
      let before = performance.now();
      const frame = (now) => {
        if (!this.playing) return;
        if (this.seen) this.advance(this.declared.pace * Math.min(0.1, Math.max(0, now - before) / 1000));
        before = now;
        requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
    }

    advance(by) {
      const { plays } = this.declared, { least, most } = this.controls[plays];
      const next = this.settings()[plays] + by;
      this.set(plays, next > most ? least : next);
    }

    // A pointer's place in the picture's own pixels.
    at(event) {
      const svg = this.place.querySelector("svg"), box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
      return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    }

    listen() {
      let last = null, off;
      const drag = (event) => {
        const [x, y] = this.at(event).map((it, k) => it + off[k]);
        this.module.drag(x, y, last ? x - last[0] : 0, last ? y - last[1] : 0);
        last = [x, y];
        this.changed();
      };
      this.place.addEventListener("pointerdown", (event) => {
        const box = event.target.closest(".grip")?.getBBox(), [x, y] = this.at(event);
        if (event.button !== 0 || !box) return;
        off = box.width + box.height > 0 ? [0, 0] : [box.x - x, box.y - y]; // a point does not jump to the pointer
        last = null;
        this.place.setPointerCapture(event.pointerId);
        drag(event);
      });
      this.place.addEventListener("pointermove", (event) => this.place.hasPointerCapture(event.pointerId) && drag(event));
    }
  }

  // ── The page ──

  function start(place, chapter, name, words) {
    return load(chapter + "." + name)
      .then((module) => {
        const figure = new Figure(place, chapter, name, module);
        new IntersectionObserver((entries) => (figure.seen = entries.at(-1).isIntersecting)).observe(place);
        const linked = figure.readLink();
        window.addEventListener("hashchange", () => figure.readLink());
        const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
        // It replaces another picture, as on the front page.
        if (!place.dataset.figure.endsWith("/" + name + ".svg")) {
          figure.draw();
          place.closest("figure")?.querySelector("figcaption")?.append(" " + words);
          if (!still && !linked) figure.play(true);
        }
        return figure;
      })
      .catch((error) => place.after(made("p", { className: "moving-error" }, "This figure stands still here: " + error.message)));
  }

  return {
    arrived: (name, base64) => arrivals[name](base64),
    figures: [], // promises of those that were seen
    /// Calls `act` with every figure, also those that are seen later; with nothing for one that stands still.
    each(act) {
      this.act = act;
      for (const figure of this.figures) figure.then(act);
    },
    /// figures: file of the picture → [chapter, name, what the caption adds where it replaces another picture]
    page(figures) {
      // The page's first picture holds the style of all, and may be one that is drawn anew.
      const style = document.querySelector("[data-figure] style")?.textContent ?? "";
      document.head.append(made("style", { textContent: style }));
      for (const place of document.querySelectorAll("[data-figure]")) {
        const found = figures[place.dataset.figure];
        if (!found) continue;
        const begin = () => {
          this.figures.push(start(place, ...found));
          this.figures.at(-1).then(this.act);
        };
        const observer = new IntersectionObserver((entries) => {
          if (entries.some((entry) => entry.isIntersecting)) observer.disconnect(), begin();
        }, { rootMargin: "400px" });
        const linked = () => new URLSearchParams(location.hash.slice(1)).get("figure") === found[1];
        addEventListener("hashchange", () => linked() && place.scrollIntoView({ block: "center" }));
        linked() ? begin() : observer.observe(place);
      }
    },
  };
})();
