// SPDX-License-Identifier: GPL-2.0-or-later
// The scene in time: plays, steps, zooms, picks.

const SPEEDS = [["2 per s", 2], ["5 per s", 5], ["10 per s", 10], ["25 per s", 25], ["fastest", Infinity]];

class Player {
  constructor(page, onFrame) {
    this.page = page;
    this.onFrame = onFrame;
    this.view = new View(byId("stage"), page.scene.window);
    this.painter = new Painter(page, this.view);
    this.place = 0;
    this.picked = null;
    this.playing = false;
    this.fillControls();
    this.listen();
    this.show(0);
  }

  get frame() {
    return this.page.frames[this.place];
  }

  get look() {
    const index = Number(byId("quantity").value);
    return { frame: this.frame, picked: this.picked, quantity: this.page.scene.quantities[index] ?? null,
             chains: byId("chains").checked, network: byId("network").checked };
  }

  fillControls() {
    const { quantities, contact_columns: contacts } = this.page.scene;
    setOptions(byId("quantity"), quantities.map(({ label }) => label));
    byId("quantity").value = Math.max(quantities.findIndex(({ name }) => name === "velocity"), 0);
    setOptions(byId("speed"), SPEEDS.map(([text]) => text));
    byId("speed").value = 2;
    byId("frame").max = this.page.frames.length - 1;
    const forces = columnOf(contacts, "normal_force") !== undefined;
    byId("chains").checked = forces;
    byId("chains").disabled = !forces;
    byId("network").disabled = contacts.length === 0;
  }

  listen() {
    const on = (id, kind, act) => byId(id).addEventListener(kind, act);
    on("play", "click", () => this.toggle());
    on("previous", "click", () => this.show(this.place - 1));
    on("next", "click", () => this.show(this.place + 1));
    on("frame", "input", () => this.show(Number(byId("frame").value)));
    for (const id of ["quantity", "chains", "network"]) on(id, "change", () => this.repaint(true));
    on("closer", "click", () => this.zoom(1.5));
    on("farther", "click", () => this.zoom(1 / 1.5));
    on("whole", "click", () => this.zoom(0));
    on("pick", "submit", (event) => {
      event.preventDefault();
      const id = Number(byId("pick-id").value);
      this.pick(byId("pick-id").value.trim() !== "" && Number.isInteger(id) ? id : null);
    });
    window.addEventListener("resize", () => this.repaint(true));
    document.addEventListener("keydown", (event) => this.key(event));
    new Gestures(this);
  }

  show(place) {
    this.place = Math.min(Math.max(place, 0), this.page.frames.length - 1);
    byId("frame").value = this.place;
    byId("frame").setAttribute("aria-valuetext", timeText(this.frame));
    byId("time").value = `${timeText(this.frame)}, frame ${this.frame.index}`;
    this.repaint(this.place === 0);
    this.showNumbers();
    this.onFrame(this.place);
  }

  showNumbers() {
    showPicked(this.page, this.frame, this.picked, (id) => this.pick(id));
  }

  repaint(withLegend) {
    this.view.fit();
    this.painter.paint(this.look);
    if (withLegend) showLegend(this.page, this.view, this.look);
    const caption = `${timeText(this.frame)}, frame ${this.frame.index}: ${this.frame.ids.length} discs by ${this.look.quantity?.label ?? "nothing"}`;
    byId("stage").setAttribute("aria-label", caption);
    byId("scene-caption").textContent = caption;
  }

  pick(id) {
    this.picked = id;
    byId("pick-id").value = id ?? "";
    this.repaint(false);
    this.showNumbers();
  }

  pickAt(px, py) {
    const i = discAt(this.page, this.frame, ...this.view.toPlane(px, py));
    this.pick(i < 0 ? null : this.frame.ids[i]);
  }

  zoom(factor, ...at) {
    if (factor === 0) this.view.reset();
    else this.view.zoomBy(factor, ...at);
    this.view.canvas.style.touchAction = this.view.zoom > 1 ? "none" : "pan-y";
    this.repaint(true);
  }

  toggle() {
    this.playing = !this.playing;
    byId("play").textContent = this.playing ? "Pause" : "Play";
    if (!this.playing) return;
    if (this.place === this.page.frames.length - 1) this.show(0);
    this.due = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    if (!this.playing) return;
    const pause = 1000 / SPEEDS[Number(byId("speed").value)][1];
    if (now >= this.due) {
      if (this.place === this.page.frames.length - 1) return this.toggle();
      this.show(this.place + 1);
      this.due = Math.max(this.due + pause, now);
    }
    requestAnimationFrame((later) => this.tick(later));
  }

  // Keys act where they have no other meaning.
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("select, input, summary, #table")) return;
    if (event.key === " " && event.target.closest("button")) return;
    const far = 0.15 * this.view.canvas.width;
    const moves = { ArrowLeft: [far, 0], ArrowRight: [-far, 0], ArrowUp: [0, far], ArrowDown: [0, -far] };
    const acts = { " ": () => this.toggle(), ArrowLeft: () => this.show(this.place - 1), ArrowRight: () => this.show(this.place + 1),
                   Home: () => this.show(0), End: () => this.show(this.page.frames.length - 1),
                   "+": () => this.zoom(1.5), "=": () => this.zoom(1.5), "-": () => this.zoom(1 / 1.5), 0: () => this.zoom(0) };
    if (event.shiftKey && event.key in moves) {
      this.view.moveBy(...moves[event.key]);
      this.repaint(false);
    } else if (event.key in acts && !(["Home", "End"].includes(event.key) && document.activeElement === document.body)) {
      acts[event.key]();
    } else {
      return;
    }
    event.preventDefault();
  }
}
