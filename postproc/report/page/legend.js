// SPDX-License-Identifier: GPL-2.0-or-later
// What the colours and widths of the scene mean.

function colourBar(page, quantity) {
  const [left, width, height] = [8, 300, 14];
  const { map } = page.colours;
  const cells = map.map((colour, i) => drawn("rect", { x: left + (i * width) / map.length, y: 4, width: width / map.length + 0.5, height, fill: colour }));
  const [prefix, factor] = prefixOf(Math.max(Math.abs(quantity.low), Math.abs(quantity.high)), quantity.unit);
  const range = quantity.high - quantity.low;
  const marks = range > 0 ? ticks(quantity.low / factor, quantity.high / factor, 5) : [quantity.low / factor];
  const labels = marks.flatMap((mark) => {
    const x = left + width * (range > 0 ? (mark * factor - quantity.low) / range : 0.5);
    return [drawn("line", { x1: x, x2: x, y1: 4 + height, y2: 8 + height, class: "axis" }),
            drawn("text", { x, y: 20 + height, "text-anchor": "middle" }, String(Number(mark.toPrecision(6))))];
  });
  const unit = quantity.unit === "" ? "" : ` (${prefix}${quantity.unit})`;
  const title = drawn("text", { x: left + width + 12, y: 16 }, quantity.label + unit);
  return [...cells, ...labels, title];
}

// Lines of round forces, as wide as in the scene at its present zoom.
function chainKey(page, view, x, y, frame) {
  const { scene, colours } = page;
  const force = roundBelow(2 * scene.mean_force);
  const [prefix, factor] = prefixOf(force, "N");
  const density = view.canvas.width / (view.canvas.clientWidth || 1);
  const width = (colours.chain_width * view.scale * scene.mean_radius * force) / scene.mean_force / density;
  const column = columnOf(scene.contact_columns, "normal_force");
  const pulls = frame.contacts.normal_force.some((code) => valueOf(column, code) < -column.step / 2);
  const entry = (at, colour, text) => [drawn("line", { x1: at, x2: at + 26, y1: y - 4, y2: y - 4, stroke: colour, "stroke-width": Math.min(width, 12) }), drawn("text", { x: at + 32, y }, text)];
  return [...entry(x, colours.compression, `${Number((force / factor).toPrecision(3))} ${prefix}N, compression`), ...(pulls ? entry(x + 180, colours.tension, "tension") : [])];
}

function showLegend(page, view, look) {
  const bar = look.quantity === null ? [] : colourBar(page, look.quantity);
  const key = look.chains && page.scene.mean_force > 0 ? chainKey(page, view, 8, 56, look.frame) : [];
  const height = key.length > 0 ? 64 : 42;
  byId("legend").replaceChildren(drawn("svg", { viewBox: `0 0 480 ${height}`, class: "key", role: "img", "aria-label": "legend" }, ...bar, ...key));
}
