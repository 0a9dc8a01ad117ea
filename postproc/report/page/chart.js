// SPDX-License-Identifier: GPL-2.0-or-later
// Curves with bands of standard errors.

const CHART = { width: 460, height: 300, left: 62, right: 14, top: 26, bottom: 42 };

function finite(values) {
  return values.filter((value) => value !== null && Number.isFinite(value));
}

// A linear or logarithmic scale from values to pixels, with its marks.
function scaleOf(values, pixels, logarithm) {
  const usable = finite(values).filter((value) => !logarithm || value > 0).map((value) => (logarithm ? Math.log10(value) : value));
  let [low, high] = usable.length > 0 ? [Math.min(...usable), Math.max(...usable)] : [0, 1];
  const room = high > low ? 0.05 * (high - low) : 0.5 * Math.abs(low) || 1;
  [low, high] = [low - room, high + room];
  const place = (value) => {
    if (value === null || !Number.isFinite(value) || (logarithm && value <= 0)) return null;
    return pixels[0] + ((pixels[1] - pixels[0]) * ((logarithm ? Math.log10(value) : value) - low)) / (high - low);
  };
  const decades = logarithm ? ticks(low, high, 5).filter(Number.isInteger).map((power) => 10 ** power) : [];
  const marks = decades.length > 1 ? decades : logarithm ? ticks(10 ** low, 10 ** high, 5) : ticks(low, high, 5);
  return { place, marks };
}

function axes(x, y, xTitle, yTitle) {
  const { width, height, left, right, top, bottom } = CHART;
  const [x1, y0] = [width - right, height - bottom];
  const text = (value) => String(Number(value.toPrecision(5)));
  const parts = [];
  for (const mark of y.marks) {
    const at = y.place(mark);
    parts.push(drawn("line", { x1: left, x2: x1, y1: at, y2: at, class: "grid" }), drawn("text", { x: left - 5, y: at + 4, "text-anchor": "end" }, text(mark)));
  }
  for (const mark of x.marks) {
    const at = x.place(mark);
    parts.push(drawn("line", { x1: at, x2: at, y1: y0, y2: y0 + 4, class: "axis" }), drawn("text", { x: at, y: y0 + 17, "text-anchor": "middle" }, text(mark)));
  }
  parts.push(drawn("path", { class: "axis", d: `M${left} ${top}V${y0}H${x1}` }));
  parts.push(drawn("text", { x: (left + x1) / 2, y: height - 6, "text-anchor": "middle" }, xTitle));
  parts.push(drawn("text", { x: 6, y: 14 }, yTitle));
  return parts;
}

// Runs of neighbouring points for which `known` holds.
function runsOf(count, known) {
  const runs = [];
  for (let i = 0; i < count; ++i) {
    if (!known(i)) continue;
    if (i === 0 || !known(i - 1)) runs.push([]);
    runs.at(-1).push(i);
  }
  return runs;
}

function curve(x, y, points, values, kind) {
  const runs = runsOf(points.length, (i) => y.place(values[i]) !== null);
  const d = runs.map((run) => "M" + run.map((i) => `${x.place(points[i])} ${y.place(values[i])}`).join("L")).join("");
  return drawn("path", { d, class: kind });
}

// From value - error to value + error; on a logarithmic scale down to the axis where that is not positive.
function band(x, y, points, values, errors, kind) {
  const floor = CHART.height - CHART.bottom;
  const runs = runsOf(points.length, (i) => errors[i] !== null && y.place(values[i]) !== null);
  const corner = (i, sign) => `${x.place(points[i])} ${y.place(values[i] + sign * errors[i]) ?? floor}`;
  const d = runs.map((run) => "M" + [...run.map((i) => corner(i, 1)), ...run.toReversed().map((i) => corner(i, -1))].join("L") + "Z").join("");
  return drawn("path", { d, class: kind });
}

function bars(x, y, points, values, errors) {
  const floor = CHART.height - CHART.bottom;
  return points.flatMap((point, i) => {
    if (y.place(values[i]) === null) return [];
    const at = { x: x.place(point), y: y.place(values[i]) };
    const dot = drawn("circle", { cx: at.x, cy: at.y, r: 3, class: "dot" });
    if (errors[i] === null) return [dot];
    return [drawn("line", { x1: at.x, x2: at.x, y1: y.place(values[i] - errors[i]) ?? floor, y2: y.place(values[i] + errors[i]), class: "bar" }), dot];
  });
}

function withBand(values, errors) {
  return values.flatMap((value, i) => (value === null ? [] : [value - (errors[i] ?? 0), value + (errors[i] ?? 0)]));
}

// whole: the average of all frames; now: that of the window, none if there is one window only; range: numbers that the scale has to hold.
function profileChart({ points, whole, now, range, xTitle, yTitle, logarithm }) {
  const { width, height, left, right, top, bottom } = CHART;
  const x = scaleOf(points, [left, width - right], false);
  const y = scaleOf([...range, ...withBand(whole.values, whole.errors)], [height - bottom, top], logarithm);
  const shown = now ?? whole;
  const behind = now ? [band(x, y, points, whole.values, whole.errors, "whole-band"), curve(x, y, points, whole.values, "whole")] : [];
  return drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${yTitle} against ${xTitle}` },
               ...axes(x, y, xTitle, yTitle), ...behind, band(x, y, points, shown.values, shown.errors, "band"),
               curve(x, y, points, shown.values, "curve"), ...bars(x, y, points, shown.values, points.map(() => null)));
}

function timeChart({ points, values, errors, mark, xTitle, yTitle, logarithm }) {
  const { width, height, left, right, top, bottom } = CHART;
  const x = scaleOf(points, [left, width - right], false);
  const y = scaleOf(withBand(values, errors), [height - bottom, top], logarithm);
  const now = mark === null ? [] : [drawn("line", { x1: x.place(points[mark]), x2: x.place(points[mark]), y1: top, y2: height - bottom, class: "now" })];
  return drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${yTitle} against ${xTitle}` },
               ...axes(x, y, xTitle, yTitle), ...now,
               curve(x, y, points, values, "curve"), ...bars(x, y, points, values, errors));
}
