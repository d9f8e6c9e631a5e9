// What all plots share: Vega with an interpreter in place of compiled code, colours that follow the page (style.css), ticks
// of logarithmic axes, and a plot that keeps the width of its place.

const kFont = 'system-ui, "Segoe UI", "DejaVu Sans", sans-serif';
const kConfig = {
  font: kFont,
  axis: {domainColor: "var(--muted)", tickColor: "var(--muted)", gridColor: "var(--grid)", labelColor: "var(--ink)",
         titleColor: "var(--ink)", titleFontWeight: 600, labelFont: kFont, titleFont: kFont, labelFontSize: 11, titleFontSize: 11.5, titlePadding: 8},
  legend: {labelColor: "var(--ink)", titleColor: "var(--muted)", labelFont: kFont, titleFont: kFont, labelFontSize: 11, titleFontSize: 11,
           titleFontWeight: 600, labelLimit: 320},
};
const kColours = [0, 1, 2, 3, 4, 5, 6, 7].map(i => `var(--c${i})`);

// Ticks of a logarithmic axis: 1, 2, 5 of each decade, fewer where there are many decades, finer where there is hardly one.
function logTicks(least, most, room) {
  const decades = Math.log10(most / least);
  const ticks = [];
  if (decades < 1) {
    const step = [1, 2, 5, 10].map(s => s * 10 ** Math.floor(Math.log10((most - least) / room))).find(s => (most - least) / s <= room);
    for (let i = Math.ceil(least / step); i * step <= most; ++i) ticks.push(Number((i * step).toPrecision(6)));
    return ticks;
  }
  const each = [[1, 2, 5], [1, 3], [1]].find(digits => decades * digits.length <= room) ?? [1];
  const stride = Math.max(1, Math.ceil(decades / room));
  for (let power = Math.floor(Math.log10(least)); power <= Math.log10(most); ++power)
    if (power % stride === 0) for (const digit of each) ticks.push(Number(`${digit}e${power}`));
  return ticks.filter(tick => tick >= least * 0.999 && tick <= most * 1.001);
}

// A logarithmic axis for errors. Zero has no place on it: it gets one of its own below the others, labelled 0.
function errorRange(values) {
  const positive = values.filter(value => value > 0);
  const least = positive.length ? Math.min(...positive) : 1e-6, most = positive.length ? Math.max(...positive) : 1;
  const hasZero = values.some(value => value === 0);
  const zero = 10 ** (Math.floor(Math.log10(least)) - 1);
  const bottom = hasZero ? zero * 0.7 : least / 1.5;
  const top = most * 1.6;
  const ticks = logTicks(hasZero ? zero * 3 : bottom, top, 8);
  return {domain: [bottom, top], ticks: hasZero ? [zero, ...ticks] : ticks, zero: hasZero ? zero : null, place: value => value === 0 ? zero : value};
}

// The axis and its scale for errorRange().
const errorScale = range => ({name: "y", type: "log", domain: range.domain, range: "height", zero: false, nice: false});
const errorAxis = (range, title) => ({
  orient: "left", scale: "y", values: range.ticks, grid: true, title, domain: false, ticks: false, labelPadding: 6, zindex: 0,
  encode: {labels: {update: {text: {signal: `datum.value === ${range.zero} ? '0' : replace(format(datum.value, '~e'), '+', '')`}}}},
});

// The colours' legend above a plot of this width: as many columns as its longest name lets it have.
function legendFor(names, width) {
  const longest = Math.max(...names.map(name => name.length), 1);
  return {fill: "colour", orient: "top", direction: "horizontal", columns: Math.max(1, Math.floor((width - 70) / (34 + 6.6 * longest))),
          symbolType: "circle", symbolSize: 75, offset: 12, columnPadding: 14};
}
const seriesLegend = (names, width) => names.length > 1 ? [legendFor(names, width)] : [];

function makeView(spec) {
  const parts = vega["vega-parser"].parse({autosize: {type: "fit-x", contains: "padding"}, padding: 2, ...spec}, kConfig, {ast: true});
  return new vega["vega-view"].View(parts, {renderer: "svg", expr: vega["vega-interpreter"].expressionInterpreter, logLevel: 1});
}

const shownPlots = new Map();  // place -> {view, width, again}

// Draws a plot into its place, as wide as that: makeSpec(width) gives its specification. Hovered marks with a run's id show the
// tip, clicked ones are picked.
async function showPlot(place, makeSpec, pick) {
  const width = Math.max(200, place.clientWidth);
  shownPlots.get(place)?.view.finalize();
  place.replaceChildren();
  const view = makeView({...makeSpec(width), width});
  shownPlots.set(place, {view, width, again: () => showPlot(place, makeSpec, pick)});
  view.tooltip((handler, event, item, id) => showTip(event, id));
  if (pick) view.addEventListener("click", (event, item) => item?.datum?.id && pick(item.datum.id));
  await view.initialize(place).hover().runAsync();
  return view;
}

function forgetPlots(within) {
  for (const [place, {view}] of shownPlots)
    if (within.contains(place)) { view.finalize(); shownPlots.delete(place); }
}

const refit = () => shownPlots.forEach((plot, place) => place.clientWidth && Math.max(200, place.clientWidth) !== plot.width && plot.again());
let refitSoon = 0;
addEventListener("resize", () => { clearTimeout(refitSoon); refitSoon = setTimeout(refit, 80); });

// The plot as a file of its own: the page's colours written out, on white.
async function plotAsSvg(view) {
  const light = {paper: "#ffffff", ink: "#1b1f23", muted: "#5b6570", grid: "#e8ebee", accent: "#0b5cad",
                 c0: "#0b6fbf", c1: "#d1660a", c2: "#1f8a4c", c3: "#8e4bb8", c4: "#b8860b", c5: "#c2386b", c6: "#13868f", c7: "#6b6f76"};
  const svg = (await view.toSVG()).replace(/var\(--(\w+)\)/g, (whole, name) => light[name] ?? whole);
  return svg.replace(/(<svg[^>]*>)/, `$1<rect width="100%" height="100%" fill="${light.paper}"/>`);
}
