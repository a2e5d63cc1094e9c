// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/** The parts of the page that the viewer adds: its canvas, and what it is steered by. Text is set as text, never as HTML. */

export function element(name, attributes = {}, ...children) {
  const e = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) e.addEventListener(key.slice(2), value);
    else if (value === true) e.setAttribute(key, "");
    else if (value !== false) e.setAttribute(key, value);
  e.append(...children);
  return e;
}

export function select(id, label, options, onChange) {
  const list = element("select", { id, onchange: (e) => onChange(e.target.value) });
  for (const [value, text] of options) list.append(element("option", { value }, text));
  return element("label", { for: id }, label + " ", list);
}

export function checkbox(id, label, checked, onChange) {
  const box = element("input", { id, type: "checkbox", checked, onchange: (e) => onChange(e.target.checked) });
  return element("label", { for: id, class: "check" }, box, " " + label);
}

export function button(text, title, onClick) {
  return element("button", { type: "button", title, "aria-label": title, onclick: onClick }, text);
}

/** Names with values, as a list. */
export function figures(title, pairs) {
  const list = element("dl");
  for (const [name, value] of pairs)
    if (value !== undefined && value !== null && value !== "")
      list.append(element("div", {}, element("dt", {}, name), element("dd", {}, String(value))));
  return [element("strong", {}, title), list];
}

export function legend({ entries, scale, low, high }) {
  if (scale) {
    const bar = element("span", { class: "scale", style: `background: linear-gradient(90deg, ${scale.join(", ")})` });
    return [low + " ", bar, " " + high];
  }
  return entries.map(({ name, color }) =>
    element("span", { class: "entry" }, color ? element("span", { class: "swatch", style: `background: ${color}` }) : "", name),
  );
}

export function number(x) {
  return x === undefined || x === null ? "" : Number(x.toPrecision(5)).toString();
}
