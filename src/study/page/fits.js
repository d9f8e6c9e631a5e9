// Orders of accuracy: error against size on logarithmic axes, with the line that was fitted to the filled points.

function fitSections(subject) {
  const groups = new Map();
  for (const fit of study.fits ?? [])
    if (fit.subject === subject.id && fit.points?.length) {
      const key = `${fit.axis}\n${fit.measure}`;
      groups.set(key, [...(groups.get(key) ?? []), fit]);
    }
  return [...groups.values()].map(fits => {
    const place = make("div", {class: "plot"});
    const measure = kMeasures[fits[0].measure]?.title ?? fits[0].measure;
    const section = make("div", {class: "fit"}, make("h4", {}, `${measure}, against ${sizeName(fits[0])}`), place);
    section.draw = () => showPlot(place, width => fitSpec(fits, measure, width));
    return section;
  });
}

// What is refined: tables, or the samples that some lookups take along a segment.
const sizeName = fit => ({table: "entries along each side of the table", lookup: "samples along a segment"})[fit.axis] ?? settingName(fit.axis);
const fitName = fit => `${fit.lookup ?? settingName(fit.axis)}: ${fit.slope == null ? "no order found" : "slope " + fit.slope.toFixed(2).replace("-", "−")}`;
const inFit = (fit, size) => fit.used != null && size >= fit.used[0] && size <= fit.used[1];

// The line: the slope given, through the middle of the points that it was fitted to.
function fittedLine(fit) {
  const used = fit.points.filter(([size, error]) => inFit(fit, size) && error > 0);
  if (fit.slope == null || used.length < 2) return [];
  const mean = values => values.reduce((sum, value) => sum + value, 0) / values.length;
  const x = mean(used.map(([size]) => Math.log(size))), y = mean(used.map(([, error]) => Math.log(error)));
  const sizes = used.map(([size]) => size);
  return [Math.min(...sizes), Math.max(...sizes)].map(size => ({x: size, y: Math.exp(y + fit.slope * (Math.log(size) - x)), name: fitName(fit)}));
}

function fitSpec(fits, measure, width) {
  const points = fits.flatMap(fit => fit.points.map(([x, error]) => ({x, error, used: inFit(fit, x), name: fitName(fit)})));
  const range = errorRange(points.map(point => point.error));
  const rows = points.map(point => ({...point, y: range.place(point.error), shape: point.error === 0 ? "triangle-down" : "circle"}));
  const sizes = rows.map(row => row.x);
  const domain = [Math.min(...sizes) / 1.2, Math.max(...sizes) * 1.2];
  const at = {x: {scale: "x", field: "x"}, y: {scale: "y", field: "y"}};
  return {
    height: 240,
    data: [{name: "points", values: rows}, {name: "lines", values: fits.flatMap(fittedLine)}],
    scales: [{name: "x", type: "log", domain, range: "width", zero: false, nice: false}, errorScale(range), seriesColour(fits.map(fitName))],
    axes: [{orient: "bottom", scale: "x", title: sizeName(fits[0]), values: [...new Set(sizes)].sort((a, b) => a - b), format: "~r", labelOverlap: true, labelPadding: 4}, errorAxis(range, `error, ${measure}`)],
    legends: [legendFor(fits.map(fitName), width)],
    marks: [
      {type: "group", from: {facet: {name: "line", data: "lines", groupby: "name"}}, marks: [
        {type: "line", from: {data: "line"}, encode: {enter: {...at, stroke: {scale: "colour", field: "name"}, strokeWidth: {value: 1.6}}}}]},
      {type: "symbol", from: {data: "points"}, encode: {enter: {...at, size: {value: 55}, shape: {field: "shape"}, stroke: {scale: "colour", field: "name"}, fill: {scale: "colour", field: "name"}, fillOpacity: {signal: "datum.used ? 1 : 0"}}}},
    ],
  };
}
