// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers as text, and round numbers for scales.

// Six digits, as the page holds them.
function sixDigits(value) {
  if (value === null) return "nan";
  const short = Number(value.toPrecision(6));
  return short !== 0 && Math.abs(short) < 1e-4 ? short.toExponential() : String(short);
}

const PREFIXES = [["G", 1e9], ["M", 1e6], ["k", 1e3], ["", 1], ["m", 1e-3], ["\u00b5", 1e-6], ["n", 1e-9]];

// The SI prefix that brings a size into 1 ... 1000; none for numbers without a unit.
function prefixOf(size, unit) {
  const plain = ["", 1];
  if (unit === "" || size === 0 || !Number.isFinite(size)) return plain;
  return PREFIXES.find(([, factor]) => Math.abs(size) >= factor * 0.9999999) || plain;
}

// A quantised number: the last digit shown is no smaller than the step; six digits at most.
function withUnit(value, unit, step) {
  if (Number.isNaN(value)) return "not known";
  if (step === 1 && unit === "") return String(value);
  const small = Math.abs(value) < step / 2 ? 0 : value;
  const [prefix, factor] = prefixOf(Math.max(Math.abs(small), step), unit);
  const digits = Math.min(6, Math.max(1, Math.floor(Math.log10(Math.abs(small))) - Math.ceil(Math.log10(step)) + 1));
  const text = small === 0 ? "0" : String(Number((small / factor).toPrecision(digits)));
  return unit === "" ? text : `${text} ${prefix}${unit}`;
}

// Two digits suffice to say how coarse a number is.
function coarse(size, unit) {
  const [prefix, factor] = prefixOf(size, unit);
  return `${Number((size / factor).toPrecision(2))} ${prefix}${unit}`.trim();
}

function roundBelow(x) {
  const power = 10 ** Math.floor(Math.log10(x) + 1e-12);
  return [5, 2, 1].find((leading) => leading * power <= x * (1 + 1e-12)) * power;
}

// Round, equally spaced numbers within low ... high, about `count` of them.
function ticks(low, high, count) {
  if (!(high > low)) return [low];
  let step = roundBelow((high - low) / count);
  if ((high - low) / step > 1.6 * count) step = roundBelow(2.5 * step);
  const all = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) all.push(i === 0 ? 0 : i * step);
  return all;
}

function timeText(place) {
  return place.time === null ? `step ${place.step}` : `t = ${Number(place.time.toPrecision(6))} s`;
}
