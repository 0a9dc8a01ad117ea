// SPDX-License-Identifier: GPL-2.0-or-later
// Discs, contacts and force chains on a canvas, as `mikromakro draw` draws them.

const CIRCLE = 2 * Math.PI;

class Painter {
  constructor(page, view) {
    this.page = page;
    this.view = view;
    this.context = view.canvas.getContext("2d");
    this.bulk = new Set(page.scene.bulk_types);
  }

  // look: frame, quantity (null: plain), chains, network, picked (id or null)
  paint(look) {
    const { context, view } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, view.canvas.width, view.canvas.height);
    context.save();
    if (look.frame.periodic.includes(true)) this.clip();
    const frame = look.frame;
    const discs = this.positions(frame);
    const shades = this.shades(frame, look.quantity);
    for (const shift of imageShifts(frame)) {
      context.setTransform(1, 0, 0, 1, view.scale * shift[0], -view.scale * shift[1]);
      this.discs(discs, shades, shift);
    }
    if (look.network || look.chains) this.contacts(frame, discs, look);
    if (look.picked !== null) this.mark(frame, discs, look.picked);
    context.restore();
  }

  clip() {
    const [x0, y1] = this.view.toPixel(this.view.whole[0], this.view.whole[2]);
    const [x1, y0] = this.view.toPixel(this.view.whole[1], this.view.whole[3]);
    this.context.beginPath();
    this.context.rect(x0, y0, x1 - x0, y1 - y0);
    this.context.clip();
  }

  // Pixels of the centres and of the radii.
  positions(frame) {
    const columns = ["x", "y", "radius"].map((name) => columnOf(this.page.scene.disc_columns, name));
    const [xs, ys, radii] = columns.map(({ name, low, step }) => Float64Array.from(frame.discs[name], (code) => low + step * code));
    const { scale } = this.view;
    const [left, top] = this.view.toPixel(0, 0);
    for (let i = 0; i < xs.length; ++i) {
      xs[i] = left + scale * xs[i];
      ys[i] = top - scale * ys[i];
      radii[i] *= scale;
    }
    return { xs, ys, radii, mean: scale * this.page.scene.mean_radius };
  }

  isBulk(frame, i) {
    if (this.bulk.size === 0) return true;
    return this.bulk.has(valueOf(columnOf(this.page.scene.disc_columns, "type"), frame.discs.type[i]));
  }

  // For each disc its place in the map of colours; -1 for walls.
  shades(frame, quantity) {
    const shades = new Int16Array(frame.ids.length);
    const count = this.page.colours.map.length;
    const value = quantity === null ? () => 0 : quantityOf(this.page, frame, quantity.name);
    const { low, high } = quantity ?? { low: 0, high: 1 };
    for (let i = 0; i < shades.length; ++i) {
      const part = high > low ? (value(i) - low) / (high - low) : 0.5;
      shades[i] = this.isBulk(frame, i) ? Math.min(Math.max(Math.floor(part * count), 0), count - 1) : -1;
    }
    return shades;
  }

  // Those of one colour at a time: a change of colour costs more than a disc.
  discs({ xs, ys, radii, mean }, shades, shift) {
    const { context, view, page } = this;
    const { width, height } = view.canvas;
    const offset = [view.scale * shift[0], -view.scale * shift[1]];
    const byShade = new Map();
    for (let i = 0; i < xs.length; ++i) {
      const x = xs[i] + offset[0];
      const y = ys[i] + offset[1];
      const reach = radii[i] + 1;
      if (x < -reach || y < -reach || x > width + reach || y > height + reach) continue;
      if (!byShade.has(shades[i])) byShade.set(shades[i], []);
      byShade.get(shades[i]).push(i);
    }
    const lined = mean > 2;
    context.lineWidth = Math.max(0.05 * mean, 0.5);
    context.strokeStyle = page.colours.outline;
    for (const [shade, members] of byShade) {
      context.fillStyle = shade < 0 ? page.colours.wall : page.colours.map[shade];
      context.beginPath();
      for (const i of members) {
        context.moveTo(xs[i] + radii[i], ys[i]);
        context.arc(xs[i], ys[i], radii[i], 0, CIRCLE);
      }
      context.fill();
      if (lined) context.stroke();
    }
  }


  // Ends of each contact's line in pixels, and its force relative to the mean.
  lines(frame, { xs, ys, radii }) {
    const columns = this.page.scene.contact_columns;
    const angle = columnOf(columns, "angle");
    const overlap = columnOf(columns, "overlap");
    const force = columnOf(columns, "normal_force");
    const { scale } = this.view;
    return Array.from(frame.first, (i, k) => {
      const j = frame.second[k];
      const turn = valueOf(angle, frame.contacts.angle[k]);
      const depth = overlap ? valueOf(overlap, frame.contacts.overlap[k]) : NaN;
      const reach = radii[i] - (Number.isNaN(depth) ? 0 : scale * depth);
      const length = j >= LAST_DISC ? reach : reach + radii[j];
      let x = length * Math.cos(turn);
      let y = -length * Math.sin(turn);
      let across = false;
      if (j < LAST_DISC) {
        const straight = [xs[j] - xs[i], ys[j] - ys[i]];
        across = Math.hypot(straight[0] - x, straight[1] - y) > 0.5 * length;
        if (!across) [x, y] = straight;
      }
      const size = force && this.page.scene.mean_force > 0 ? valueOf(force, frame.contacts.normal_force[k]) / this.page.scene.mean_force : NaN;
      return { x: xs[i], y: ys[i], dx: x, dy: y, across, size };
    });
  }

  contacts(frame, discs, look) {
    const lines = this.lines(frame, discs);
    const shifts = imageShifts(frame).map(([x, y]) => [this.view.scale * x, -this.view.scale * y]);
    const { colours } = this.page;
    if (look.network) this.strokes(lines, shifts, () => Math.max(colours.network_width * discs.mean, 0.5), colours.network);
    if (!look.chains) return;
    const width = (line) => colours.chain_width * discs.mean * Math.abs(line.size);
    const strong = lines.filter((line) => width(line) > 0.15).sort((a, b) => Math.abs(a.size) - Math.abs(b.size));
    const edge = colours.halo_width * discs.mean;
    const edged = 0.5;  // px; beside thinner lines an edge is not seen
    if (look.quantity !== null) this.strokes(strong.filter((line) => width(line) > edged), shifts, (line) => width(line) + 2 * Math.min(edge, width(line)), colours.halo);
    this.strokes(strong.filter((line) => line.size > 0), shifts, width, colours.compression);
    this.strokes(strong.filter((line) => line.size < 0), shifts, width, colours.tension);
  }

  // Lines of about one width together, the thinnest first.
  strokes(lines, shifts, width, colour) {
    const { context } = this;
    const byWidth = new Map();
    for (const line of lines) {
      const level = Math.round(8 * Math.log2(width(line)));
      if (!byWidth.has(level)) byWidth.set(level, []);
      byWidth.get(level).push(line);
    }
    context.strokeStyle = colour;
    context.lineCap = "butt";
    context.setTransform(1, 0, 0, 1, 0, 0);
    for (const level of [...byWidth.keys()].sort((a, b) => a - b)) {
      context.lineWidth = 2 ** (level / 8);
      context.beginPath();
      for (const line of byWidth.get(level)) this.addLine(line, shifts);
      context.stroke();
    }
  }

  addLine({ x, y, dx, dy }, shifts) {
    for (const [sx, sy] of shifts) {
      if (!this.near(x + sx, y + sy, Math.abs(dx) + Math.abs(dy))) continue;
      this.context.moveTo(x + sx, y + sy);
      this.context.lineTo(x + sx + dx, y + sy + dy);
    }
  }

  near(x, y, reach) {
    const { width, height } = this.view.canvas;
    return x > -reach && y > -reach && x < width + reach && y < height + reach;
  }

  // The picked disc is ringed in black and white, which shows on every colour.
  mark(frame, { xs, ys, radii }, id) {
    const i = frame.ids.indexOf(id);
    if (i < 0) return;
    const { context, view } = this;
    for (const [sx, sy] of imageShifts(frame)) {
      context.setTransform(1, 0, 0, 1, view.scale * sx, -view.scale * sy);
      for (const [width, colour] of [[6, "#fff"], [3, "#000"]]) {
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.beginPath();
        context.arc(xs[i], ys[i], Math.max(radii[i], 4), 0, CIRCLE);
        context.stroke();
      }
    }
  }
}

// Values of a quantity by disc.
function quantityOf(page, frame, name) {
  if (name === "contacts") return contactCounts(frame);
  const read = (wanted) => {
    const column = columnOf(page.scene.disc_columns, wanted);
    return (i) => valueOf(column, frame.discs[wanted][i]);
  };
  if (name !== "velocity") return read(name);
  const [vx, vy] = [read("vx"), read("vy")];
  return (i) => Math.hypot(vx(i), vy(i));
}

function contactCounts(frame) {
  const counts = new Int32Array(frame.ids.length);
  for (let k = 0; k < frame.first.length; ++k) {
    ++counts[frame.first[k]];
    if (frame.second[k] < LAST_DISC) ++counts[frame.second[k]];
  }
  return (i) => counts[i];
}
