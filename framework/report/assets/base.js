// Numbers of the page, words for them, and the few elements that everything is made of.
const numbers = JSON.parse(document.getElementById("numbers").textContent);
const study = numbers.study || null;
const runs = numbers.runs;

// Okabe & Ito (2008): told apart by people who see colours differently; the yellow is darkened for white paper. Dashes and marks repeat
// the message for grey print.
const palettes = {
  light: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#a6761d", "#3aa0dc", "#6a3d9a", "#555555", "#b2182b", "#1b7837"],
  dark: ["#5ab4e5", "#f08a4b", "#3fd1a2", "#e5a3c8", "#e3b94f", "#9ad8ff", "#b79be0", "#c4c8cd", "#f28080", "#8fd694"],
};
const marks = ["circle", "rect", "triangle", "rectRot", "star", "crossRot", "rectRounded", "cross", "circle", "rect"];
const dashes = [[], [7, 3], [2, 3], [9, 3, 2, 3], [5, 5], [12, 4], [3, 6], [1, 2], [14, 3, 3, 3], [6, 2, 2, 2]];

const cases = study
  ? study.cases.map((one, k) => ({ ...one, index: k, run: runs[k] || {}, path: `cases.${k}` }))
  : [{ name: "this run", index: 0, run: runs[0], reference: false, path: "" }];

function theme() { return document.documentElement.dataset.theme; }
function colour(index) { const list = palettes[theme()]; return list[index % list.length]; }
function css(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "style") Object.assign(made.style, value);
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat()) if (child !== null && child !== undefined) made.append(child);
  return made;
}

// ------------------------------------------------------------------------------------------------------------- words
function known(value) { return typeof value === "number" && Number.isFinite(value); }

function short(value, digits = 3) {
  if (!known(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-3)) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${mantissa} × 10${superscript(Number(exponent))}`;
  }
  return String(Number(value.toPrecision(digits)));
}
function superscript(number) { return String(number).replace(/[-0-9]/g, (c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)]); }
function seconds(value) {
  if (!known(value)) return "–";
  if (value < 120) return `${short(value)} s`;
  if (value < 7200) return `${short(value / 60)} min`;
  return value < 172800 ? `${short(value / 3600)} h` : `${short(value / 86400)} d`;
}
function bytes(value) { return known(value) ? (value < 1e9 ? `${Math.round(value / 1e6)} MB` : `${short(value / 1e9)} GB`) : "–"; }
function percent(value, digits = 2) { return known(value) ? `${Number((100 * value).toPrecision(digits))} %` : "–"; }
function whole(value) { return known(value) ? value.toLocaleString("en").replace(/,/g, "\u202f") : "–"; }

// "6 ± 4 %", "0 to 5 %", as the command says it.
function error_words(e) {
  if (!e || e.value === null || e.value === undefined) return null;
  const at_least = e.lower_bound ? "at least " : "";
  if (e.low <= 0 && e.high > 0) return `0 to ${at_least}${percent(e.high)}`;
  if (e.high === e.low) return percent(e.value);
  return `${Number((100 * e.value).toPrecision(2))} ± ${at_least}${percent((e.high - e.low) / 2)}`;
}
function metric_words(name) { return name.replace(/_/g, " ").replace(/^./, (c) => c.toUpperCase()); }

// -------------------------------------------------------------------------------------------------------------- tables
// `path`: where the number stands in study.json, so that anyone can check the page against it.
function cell(value, words, path) {
  return element("td", known(value) ? { "data-value": String(value), "data-path": path || null } : { class: "none" }, words);
}
// Why a number is missing stands once, under the table.
let gap_notes = [];
function gap_cell(why) {
  if (!why) return element("td", { class: "gap" }, "–");
  if (!gap_notes.includes(why)) gap_notes.push(why);
  return element("td", { class: "gap" }, "none", element("sup", {}, String(gap_notes.indexOf(why) + 1)));
}
function case_head(one) {
  return element("th", { scope: "row" }, element("span", { class: "swatch", style: { background: colour(one.index) }, "data-swatch": one.index }),
    one.name, one.reference ? element("span", { class: "badge" }, "reference") : null);
}
function table(caption, heads, rows, words = []) {
  const notes = gap_notes;
  gap_notes = [];
  return element("div", {}, element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {}, element("caption", {}, caption),
      element("thead", {}, element("tr", {}, heads.map((head, k) => element("th", { scope: "col", class: words.includes(k) ? "words" : null }, head)))),
      element("tbody", {}, rows))), notes.length > 0 ? element("ol", { class: "notes" }, notes.map((why) => element("li", {}, why))) : null);
}

// ------------------------------------------------------------------------------------------------------------ sections
function section(id, name, title, says, ...children) {
  document.getElementById("contents").append(element("a", { href: `#${id}` }, name));
  const made = element("section", { id, "aria-labelledby": `${id}-title` }, element("h2", { id: `${id}-title` }, title),
    says ? element("p", { class: "says" }, says) : null, ...children);
  document.getElementById("main").append(made);
  return made;
}
function chooser(label, options, changed) {
  const select = element("select", { onchange: () => changed(select.value) }, options.map(([value, text]) => element("option", { value }, text)));
  return element("label", {}, label, select);
}
