// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of the page. Texts become text nodes and attributes, never markup.

function byId(id) {
  return document.getElementById(id);
}

function withChildren(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function element(name, attributes = {}, ...children) {
  return withChildren(document.createElement(name), attributes, children);
}

function drawn(name, attributes = {}, ...children) {
  return withChildren(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

function setOptions(select, texts) {
  select.replaceChildren(...texts.map((text, i) => element("option", { value: i }, text)));
}

// Rows of texts or elements, the first of them as head.
function fillTable(table, head, rows) {
  const line = (cells, kind) => element("tr", {}, ...cells.map((cell) => element(kind, {}, cell)));
  table.replaceChildren(element("thead", {}, line(head, "th")), element("tbody", {}, ...rows.map((row) => line(row, "td"))));
  return table;
}

function definitions(pairs) {
  return element("dl", {}, ...pairs.flatMap(([name, text]) => [element("dt", {}, name), element("dd", {}, text)]));
}
