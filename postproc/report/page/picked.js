// SPDX-License-Identifier: GPL-2.0-or-later
// The picked disc: its numbers and contacts.

// The disc at a point of the plane (m), -1 if there is none.
function discAt(page, frame, x, y) {
  const [cx, cy, cr] = ["x", "y", "radius"].map((name) => columnOf(page.scene.disc_columns, name));
  let found = -1;
  let nearest = 1;
  for (const [sx, sy] of imageShifts(frame)) {
    for (let i = 0; i < frame.ids.length; ++i) {
      const radius = valueOf(cr, frame.discs.radius[i]);
      const apart = Math.hypot(valueOf(cx, frame.discs.x[i]) + sx - x, valueOf(cy, frame.discs.y[i]) + sy - y) / radius;
      if (apart < nearest) [found, nearest] = [i, apart];
    }
  }
  return found;
}

function contactsOf(frame, i) {
  const all = [];
  for (let k = 0; k < frame.first.length; ++k) if (frame.first[k] === i || frame.second[k] === i) all.push(k);
  return all;
}

function discNumbers(page, frame, i) {
  const numbers = page.scene.disc_columns.map((column) => [column.name, withUnit(valueOf(column, frame.discs[column.name][i]), column.unit, column.step)]);
  if ("vx" in frame.discs && "vy" in frame.discs) {
    const steps = ["vx", "vy"].map((name) => columnOf(page.scene.disc_columns, name).step);
    numbers.push(["speed", withUnit(quantityOf(page, frame, "velocity")(i), "m/s", Math.hypot(...steps))]);
  }
  return numbers;
}

// Seen from disc i: the angle of the contact, and the forces on the disc.
function contactRow(page, frame, i, k, pick) {
  const own = frame.first[k] === i;
  const wall = own ? wallOf(frame.second[k]) : null;
  const other = own ? frame.second[k] : frame.first[k];
  const cells = page.scene.contact_columns.map((column) => {
    const value = valueOf(column, frame.contacts[column.name][k]);
    if (column.name !== "angle") return withUnit(value, column.unit, column.step);
    const degrees = (((own ? value : value + Math.PI) * 180) / Math.PI) % 360;
    return `${degrees.toFixed(1)}\u00b0`;
  });
  if (wall !== null) return [`wall ${wall}`, ...cells];
  const id = frame.ids[other];
  const link = element("button", { type: "button", class: "link" }, String(id));
  link.addEventListener("click", () => pick(id));
  return [link, ...cells];
}

const CONTACT_HEADS = { angle: "at", overlap: "overlap", normal_force: "f_n", tangential_force: "f_t" };

function showPicked(page, frame, id, pick) {
  const place = byId("picked");
  if (id === null) return place.replaceChildren(element("p", {}, "No disc is selected."));
  const i = frame.ids.indexOf(id);
  if (i < 0) return place.replaceChildren(element("p", {}, `Disc ${id} is not in this frame.`));
  const contacts = contactsOf(frame, i);
  const head = ["with", ...page.scene.contact_columns.map(({ name }) => CONTACT_HEADS[name])];
  const table = fillTable(element("table", {}), head, contacts.map((k) => contactRow(page, frame, i, k, pick)));
  place.replaceChildren(element("h3", {}, `Disc ${id}`), definitions(discNumbers(page, frame, i)),
                        element("p", { class: "note" }, `${contacts.length} contacts, seen from this disc: f_n > 0 pushes it away, f_t > 0 pushes it to the left of the direction to the other`),
                        element("div", { class: "scroll" }, table));
}
