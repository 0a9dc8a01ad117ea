// SPDX-License-Identifier: GPL-2.0-or-later
// Averages over grids and sectors as a map.

function cellPath(kind, row) {
  if (kind === "grid") {
    const [x0, x1, y0, y1] = row;
    return `M${x0} ${-y0}H${x1}V${-y1}H${x0}Z`;
  }
  const [inner, outer] = row;
  const point = (r, degrees) => `${r * Math.cos((degrees * Math.PI) / 180)} ${-r * Math.sin((degrees * Math.PI) / 180)}`;
  const [begin, middle, end] = [row[3], (row[3] + row[4]) / 2, row[4]];
  const arc = (r, from, via, to, sweep) => `A${r} ${r} 0 0 ${sweep} ${point(r, via)}A${r} ${r} 0 0 ${sweep} ${point(r, to)}`;
  return `M${point(inner, begin)}L${point(outer, begin)}${arc(outer, begin, middle, end, 0)}L${point(inner, end)}${arc(inner, end, middle, begin, 1)}Z`;
}

function extentOf(kind, rows) {
  const column = (i) => rows.map((row) => row[i]);
  if (kind === "grid") return [Math.min(...column(0)), Math.max(...column(1)), Math.min(...column(2)), Math.max(...column(3))];
  const outer = Math.max(...column(1));
  return [-outer, outer, -outer, outer];
}

// range: ends of the colours, of all windows.
function fieldMap(page, values, range, chosen, choose) {
  const { kind, rows } = page.volumes;
  const [x0, x1, y0, y1] = extentOf(kind, rows);
  const { map } = page.colours;
  const [low, high] = range;
  const cells = rows.map((row, i) => {
    const part = high > low ? (values[i] - low) / (high - low) : 0.5;
    const fill = values[i] === null ? "#fff" : map[Math.min(Math.max(Math.floor(part * map.length), 0), map.length - 1)];
    const cell = drawn("path", { d: cellPath(kind, row), fill, class: i === chosen ? "cell chosen" : "cell", "vector-effect": "non-scaling-stroke" });
    cell.addEventListener("click", () => choose(i));
    return cell;
  });
  cells.push(...cells.splice(chosen, 1));
  const room = 0.01 * Math.max(x1 - x0, y1 - y0);
  return drawn("svg", { viewBox: `${x0 - room} ${-y1 - room} ${x1 - x0 + 2 * room} ${y1 - y0 + 2 * room}`, role: "img", "aria-label": "map" }, ...cells);
}
