// Small helpers that make elements. Text goes in as text, never as HTML.

const byId = id => document.getElementById(id);

// make("td", {class: "text"}, "words", anotherElement): attributes that are functions are listeners.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value != null && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter(child => child != null));
  return element;
}

const definitions = (pairs, attributes = {}) =>
  make("dl", attributes, pairs.flatMap(([term, text]) => [make("dt", {}, term), make("dd", {}, text)]));

// A row of radio buttons; choose(value) is called with the one picked.
function radios(name, title, options, chosen, choose) {
  return make("fieldset", {}, make("legend", {}, title), Object.entries(options).map(([value, text]) =>
    make("label", {}, make("input", {type: "radio", name, value, checked: value === chosen, change: () => choose(value)}), text)));
}

// Saves text or a data URI as a file.
function saveAs(name, uri) {
  make("a", {href: uri, download: name}).click();
}
