// SPDX-License-Identifier: GPL-2.0-or-later
// Summary, audit, parameters, command lines, and what is not in the page.

function showSummary(page) {
  const { frames } = page.scene;
  const { first, last } = page.all;
  const largest = (name) => Math.max(...frames.map((frame) => frame[name]));
  const when = first.time === null ? "" : `, t = ${Number(first.time.toPrecision(6))} to ${Number(last.time.toPrecision(6))} s`;
  const shown = frames.length === page.all.frames ? "" : `, of which ${frames.length} are shown`;
  document.title = `${page.title} \u2013 mikromakro`;
  byId("title").textContent = page.title;
  byId("summary").textContent = `${page.all.frames} frames (steps ${first.step} to ${last.step}${when})${shown}; up to ${largest("discs")} discs and ${largest("contacts")} contacts in a frame. Made by ${page.program}.`;
}

function showAudit(page) {
  const { balances, impossible } = page.audit;
  if (impossible) return byId("audit").replaceChildren(element("p", {}, `No balance could be checked: ${impossible}`));
  const rows = balances.map(({ question, answer, judged, text }) => [question, judged || answer === "not known" ? answer : `${answer} (not judged)`, text]);
  const table = fillTable(element("table", { class: "words" }), ["question", "answer", "definition"], rows);
  return byId("audit").replaceChildren(element("p", {}, "Balances that hold for any contact law, evaluated over all frames:"), table);
}

function splitAt(text, mark) {
  const place = text.indexOf(mark);
  return [text.slice(0, place), text.slice(place + mark.length)];
}

function showParameters(page) {
  const constants = page.constants.length > 0 ? [element("h3", {}, "Of the run"), definitions(page.constants)] : [];
  byId("parameters").replaceChildren(...constants, element("h3", {}, "Of the averages"), definitions(page.parameters.filter(([name]) => name !== "errors of")),
    element("details", {}, element("summary", {}, "Standard errors of each field"), definitions(page.parameters.filter(([name]) => name === "errors of").map(([, text]) => splitAt(text, ": ")))));
}

// Frames first to last of the input, as --frames takes them.
function framesOption(page, first, last) {
  const { stride } = page.commands;
  return ` --frames ${first}:${last}${stride > 1 && last > first ? `:${stride}` : ""}`;
}

function drawCommand(page, look) {
  const { draw, draw_height: height } = page.commands;
  const { name, low, high } = look.quantity ?? {};
  // Colours of the page are those of all frames; without the range they would be those of this one.
  const range = high > low ? ` --range ${low} ${high}` : "";
  const color = look.quantity === null ? "" : ` --color ${name}${name === "pressure" ? height : ""}${range}`;
  return `${draw}${framesOption(page, look.frame.index, look.frame.index)}${color}${look.chains ? " --chains" : ""}${look.network ? " --network" : ""} --out frame.png`;
}

function showCommands(page, look, window) {
  const { average, audit, frames, report, timestep } = page.commands;
  const of = window === null ? null : page.windows[window];
  const lines = [
    ...(look === null ? [] : [["The frame shown above", drawCommand(page, look)]]),
    ...(of === null ? [] : [["The averages of its window", `${average}${framesOption(page, of.first.index, of.last.index)} --out window.csv`]]),
    ...(page.windows.length === 0 ? [] : [["The averages in time", `${average}${frames} --every ${page.every}${timestep} --out windows.csv`]]),
    ["The averages of all frames", `${average}${frames} --out averages.csv`],
    ...(page.audit.impossible ? [] : [["The audit", audit]]),
    ["This page", report],
  ];
  byId("commands").replaceChildren(...lines.flatMap(([text, command]) => [element("div", {}, text), element("pre", {}, command)]));
}

function showLosses(page) {
  const { disc_columns: discs, contact_columns: contacts, stride } = page.scene;
  const rows = [...discs.map((column) => ["discs", column]), ...contacts.map((column) => ["contacts", column])]
    .filter(([, { step, unit }]) => !(step === 1 && unit === ""))
    .map(([of, { name, unit, step }]) => [of, name.replace("_", " "), coarse(step, unit), `\u00b1 ${coarse(step / 2, unit)}`]);
  const thinned = stride > 1 ? [element("p", {}, `The scene has every ${stride}th frame; averages and audit are of all.`)] : [];
  byId("losses").replaceChildren(...thinned,
    element("p", {}, "The values of discs and contacts are rounded to the steps below, and shown only to that resolution. Averages are computed from the unrounded values and given to six digits. Masses and further columns of the files are not on this page."),
    fillTable(element("table", { class: "words" }), ["of", "quantity", "step", "largest error"], rows));
}
