// SPDX-License-Identifier: GPL-2.0-or-later
// Averages: of the window that the slider is in, beside those of all frames.

const MAPPED = { grid: true, sectors: true, rings: false, box: false };

class Profiles {
  constructor(page) {
    this.page = page;
    this.window = null;  // null: of all frames
    this.many = page.windows.length > 1 || (page.windows.length === 1 && page.windows[0].frames < page.all.frames);
    const { kind, rows } = page.volumes;
    this.mapped = MAPPED[kind];
    setOptions(byId("column"), page.columns.map(({ name, unit }) => (unit === "" ? name : `${name} (${unit})`)));
    byId("column").value = Math.max(page.columns.findIndex(({ name }) => name === "v_phi"), 0);
    setOptions(byId("window"), ["all", ...page.windows.map((window) => this.windowText(window))]);
    setOptions(byId("volume"), rows.map((row) => this.volumeText(row)));
    byId("window-label").hidden = byId("in-time-figure").hidden = !this.many;
    byId("volume-label").hidden = !this.many || rows.length === 1;
    byId("logarithm-label").hidden = this.mapped;
    for (const id of ["column", "logarithm", "volume"]) byId(id).addEventListener("change", () => this.show());
    byId("window").addEventListener("change", () => this.showWindow([null, ...page.windows.keys()][Number(byId("window").value)]));
    this.show();
  }

  windowText({ first, last }) {
    const when = first.time === null ? `steps ${first.step} to ${last.step}` : `t = ${Number(first.time.toPrecision(6))} to ${Number(last.time.toPrecision(6))} s`;
    return `${first.index} to ${last.index} (${when})`;
  }

  volumeText(row) {
    const at = { rings: [2], sectors: [2, 5], grid: [4, 5], box: [4, 5] }[this.page.volumes.kind];
    return at.map((i) => `${this.page.volumes.columns[i].name} = ${row[i]} ${this.page.volumes.columns[i].unit}`).join(", ");
  }

  // The window of the slider's frame; null: the frame is in none.
  showWindow(window) {
    if (!this.many || window === this.window) return;
    this.window = window;
    byId("window").value = window === null ? 0 : window + 1;
    this.show();
  }

  of(average) {
    const i = Number(byId("column").value);
    return { values: average.values[i], errors: average.errors[i] };
  }

  // Of the window, or of all frames.
  get now() {
    return this.of(this.window === null ? this.page.all : this.page.windows[this.window]);
  }

  show() {
    const column = this.page.columns[Number(byId("column").value)];
    const title = column.unit === "" ? column.name : `${column.name} (${column.unit})`;
    const source = column.equation === "-" ? "" : ` (${column.equation})`;
    byId("column-text").textContent = `${column.name}: ${column.text}${source}`;
    if (this.mapped) this.showMap(title);
    else this.showProfile(title);
    if (this.many) this.showInTime(title);
    this.showTable(title);
  }

  caption() {
    const windowed = this.window !== null;
    const known = ({ errors }) => errors.some((error) => error !== null);
    const all = `all ${this.page.all.frames} frames`;
    const whole = this.of(this.page.all);
    const without = [...(windowed && !known(this.now) ? ["the window"] : []), ...(known(whole) ? [] : [all])];
    const bands = without.length === 0 ? "Bands: standard errors." : `No standard errors of ${without.join(" or ")}: too few independent frames.`;
    const curves = windowed ? `Solid: frames ${this.windowText(this.page.windows[this.window])}. Dashed: ${all}.` : `Mean of ${all}.`;
    return `${curves} ${bands}`;
  }

  showProfile(title) {
    const { columns, rows, kind } = this.page.volumes;
    const at = kind === "rings" ? 2 : 4;
    const whole = this.of(this.page.all);
    const range = this.page.windows.flatMap((window) => this.of(window).values);
    byId("profile").replaceChildren(profileChart({ points: rows.map((row) => row[at]), whole, now: this.window === null ? null : this.now, range, yTitle: title,
                                                   xTitle: `${columns[at].name} (${columns[at].unit})`, logarithm: byId("logarithm").checked }));
    byId("profile-caption").textContent = this.caption();
  }

  showMap(title) {
    const values = [this.page.all, ...this.page.windows].flatMap((average) => finite(this.of(average).values));
    const range = values.length > 0 ? [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))] : [0, 1];
    const choose = (i) => {
      byId("volume").value = i;
      this.show();
    };
    const { unit } = this.page.columns[Number(byId("column").value)];
    const bar = drawn("svg", { viewBox: "0 0 480 42", class: "key", role: "img", "aria-label": "colours" }, ...colourBar(this.page, { low: range[0], high: range[1], unit, label: title.replace(/ \(.*/, "") }));
    byId("profile").replaceChildren(fieldMap(this.page, this.now.values, range, Number(byId("volume").value), choose), bar);
    byId("profile-caption").textContent = this.window === null ? `All ${this.page.all.frames} frames.` : `Frames ${this.windowText(this.page.windows[this.window])}.`;
  }

  showInTime(title) {
    const volume = Number(byId("volume").value);
    const { windows } = this.page;
    const timed = windows.every(({ time }, i) => time !== null && (i === 0 || time > windows[i - 1].time));
    const points = windows.map(({ time, first, last }) => (timed ? time : (first.index + last.index) / 2));
    const of = (name) => windows.map((window) => this.of(window)[name][volume]);
    byId("in-time").replaceChildren(timeChart({ points, values: of("values"), errors: of("errors"), mark: this.window, yTitle: title,
                                                xTitle: timed ? "t (s)" : "frame", logarithm: byId("logarithm").checked && !this.mapped }));
    byId("in-time-caption").textContent = `At ${this.volumeText(this.page.volumes.rows[volume])}: one point per window of ${this.page.every} frames${of("errors").some((error) => error !== null) ? ", bars are standard errors" : ", without standard errors"}.`;
  }

  showTable(title) {
    const { columns, rows } = this.page.volumes;
    const whole = this.of(this.page.all);
    const { now } = this;
    const head = [...columns.map(({ name, unit }) => `${name} (${unit})`), title, "error", ...(this.window === null ? [] : ["all frames", "error"])];
    const pair = (average, i) => [sixDigits(average.values[i]), sixDigits(average.errors[i])];
    fillTable(byId("table"), head, rows.map((row, i) => [...row.map(sixDigits), ...pair(now, i), ...(this.window === null ? [] : pair(whole, i))]));
  }
}
