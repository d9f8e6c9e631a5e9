// One axis: its table and, where its values have an order, what they do to the error and to the time.

function axisSection(subject, axis, view, pick) {
  const runs = axisRuns(subject, axis);
  if (!runs.length) return null;
  const series = seriesOf(runs);
  const names = [...new Set(runs.map(series))];
  const lead = [{title: settingName(axis.name), of: run => run.value}];
  if (names.length > 1) lead.push({title: "with", of: series});
  const sorted = names.flatMap(name => runs.filter(run => series(run) === name));
  const heading = make("h3", {}, axis.title || settingName(axis.name));
  const table = make("div", {class: "wide", tabindex: 0, role: "region", "aria-label": axis.title}, runTable(sorted, lead, pick));
  const slot = make("div", {class: "slot"});
  const section = make("div", {class: "axis", "data-axis": axis.name}, heading, table, slot);
  const measured = runs.filter(isMeasured);
  if (axis.ordered && measured.length > 1) {
    const values = axis.values.filter(value => measured.some(run => run.value === value));
    const errors = make("div", {class: "plot"}), times = make("div", {class: "plot"});
    heading.after(make("div", {class: "pair"},
      make("div", {}, make("h4", {}, `Error (${kMeasures[view.measure].title})`), errors), make("div", {}, make("h4", {}, "Time of a frame, milliseconds"), times)));
    section.draw = () => Promise.all([
      showPlot(errors, width => axisErrorSpec(measured, axis, values, series, view, width), pick),
      showPlot(times, width => axisTimeSpec(measured, axis, values, series, width), pick)]);
  }
  return section;
}

const axisScale = values => ({name: "x", type: "point", domain: values, range: "width", padding: .4});
const axisAxis = axis => ({orient: "bottom", scale: "x", title: settingName(axis.name), labelOverlap: true, labelPadding: 4});
const seriesColour = names => ({name: "colour", type: "ordinal", domain: names, range: kColours});

// Lines through the points of each series, and a mark for each run. On it, a run's id shows the tip.
const linesAndPoints = y => [
  {type: "group", from: {facet: {name: "line", data: "runs", groupby: "series"}}, marks: [
    {type: "line", from: {data: "line"}, interactive: false, encode: {enter: {x: {scale: "x", field: "value"}, y: {scale: "y", field: y}, stroke: {scale: "colour", field: "series"}, strokeWidth: {value: 1.4}}}}]},
  {type: "symbol", from: {data: "runs"}, encode: {
    enter: {x: {scale: "x", field: "value"}, y: {scale: "y", field: y}, size: {value: 55}, shape: {field: "shape"}, fill: {scale: "colour", field: "series"}, stroke: {value: "var(--paper)"},
            tooltip: {field: "id"}, cursor: {value: "pointer"}, description: {field: "words"}},
    update: {strokeWidth: {value: .8}}, hover: {strokeWidth: {value: 2.5}}}},
];

function axisErrorSpec(runs, axis, values, series, view, width) {
  const shown = runs.filter(run => run.error[view.measure] != null);
  const range = errorRange(shown.map(run => run.error[view.measure]));
  const rows = shown.map(run => ({id: run.id, value: run.value, series: series(run), y: range.place(run.error[view.measure]),
    shape: run.error[view.measure] === 0 ? "triangle-down" : "circle", words: `${run.value}: ${errorText(run.error[view.measure])}`}));
  const names = [...new Set(rows.map(row => row.series))];
  return {height: 190, data: [{name: "runs", values: rows}], scales: [axisScale(values), errorScale(range), seriesColour(names)],
          axes: [axisAxis(axis), errorAxis(range, null)], legends: seriesLegend(names, width), marks: linesAndPoints("y")};
}

// Wall time by series; where there is one series only, processor time beside it. Bars reach from the least to the most.
function axisTimeSpec(runs, axis, values, series, width) {
  const single = new Set(runs.map(series)).size === 1;
  const rows = (single ? Object.keys(kTimes) : ["frame_wall_ms"]).flatMap(time => runs.filter(run => run[time]?.median != null).map(run => ({
    id: run.id, value: run.value, series: single ? kTimes[time].short : series(run), y: run[time].median, shape: "circle",
    least: run[time].least ?? run[time].median, most: run[time].most ?? run[time].median, words: `${run.value}: ${timeText(run[time].median)} ms`})));
  const names = [...new Set(rows.map(row => row.series))];
  return {height: 190, data: [{name: "runs", values: rows}],
    scales: [axisScale(values), {name: "y", type: "linear", domain: [0, Math.max(...rows.map(row => row.most)) * 1.05 || 1], range: "height", nice: true, zero: true}, seriesColour(names)],
    axes: [axisAxis(axis), {orient: "left", scale: "y", grid: true, domain: false, ticks: false, tickCount: 5, labelPadding: 6}], legends: seriesLegend(names, width),
    marks: [{type: "rule", from: {data: "runs"}, interactive: false, encode: {enter: {x: {scale: "x", field: "value"}, y: {scale: "y", field: "least"}, y2: {scale: "y", field: "most"},
             stroke: {scale: "colour", field: "series"}, strokeWidth: {value: 4}, strokeOpacity: {value: .35}, aria: {value: false}}}}, ...linesAndPoints("y")]};
}
