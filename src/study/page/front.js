// The front: error against time of all runs of a subject, and the table of the runs that none beats.

// Runs as the plot's rows: where each lies, how it is marked and what it is called.
function frontRows(subject, view, front) {
  const drawn = runsOf(subject).filter(run => isMeasured(run) && timeOf(run, view.time) > 0 && run.error[view.measure] != null);
  const range = errorRange(drawn.map(run => run.error[view.measure]));
  const groups = [...new Set(drawn.map(run => groupOf(run, view)))];
  const rows = drawn.map(run => {
    const error = run.error[view.measure];
    const place = front.findIndex(other => other.id === run.id);
    const special = run.kind === "paper" || run.kind === "baseline";
    const shape = error === 0 ? "triangle-down" : run.kind === "paper" ? "diamond" : run.kind === "baseline" ? "square" : "circle";
    return {
      id: run.id, x: timeOf(run, view.time), y: range.place(error), group: groups.indexOf(groupOf(run, view)) < 7 ? groupOf(run, view) : "others",
      shape, size: special ? 150 : 75, onFront: place >= 0, comparable: sameSize(run, subject),
      text: [place >= 0 ? String(place + 1) : "", special ? run.kind.replace("baseline", "default") : ""].filter(Boolean).join(" "),
      words: `${run.label}: ${timeText(timeOf(run, view.time))} ms, error ${errorText(error)}`,
    };
  });
  return {rows: rows.sort((a, b) => a.onFront - b.onFront || a.size - b.size), range};
}

const groupOf = (run, view) => view.colour === "kind" ? kKinds[run.kind] ?? run.kind : settingText(run.settings?.[view.colour]);

function frontSpec(subject, view, width) {
  const front = frontOf(subject, view.measure, view.time);
  const {rows, range} = frontRows(subject, view, front);
  const times = rows.map(row => row.x);
  const domain = times.length ? [Math.min(...times) / 1.15, Math.max(...times) * 1.15] : [1, 10];
  const colours = [...new Set(rows.map(row => row.group))].sort((a, b) => a.localeCompare(b, "en", {numeric: true}));
  const steps = front.map(run => ({x: timeOf(run, view.time), y: range.place(run.error[view.measure])}));
  if (steps.length) steps.unshift({x: steps[0].x, y: range.domain[1]});
  if (steps.length) steps.push({x: domain[1], y: steps.at(-1).y});
  const at = {x: {scale: "x", field: "x"}, y: {scale: "y", field: "y"}};
  return {
    height: 430,
    data: [{name: "runs", values: rows}, {name: "named", source: "runs", transform: [{type: "filter", expr: "datum.text"}]}, {name: "steps", values: steps}],
    signals: [{name: "picked", value: view.run ?? null}],
    scales: [
      {name: "x", type: "log", domain, range: "width", zero: false, nice: false}, errorScale(range),
      {name: "colour", type: "ordinal", domain: colours, range: kColours},
    ],
    axes: [
      {orient: "bottom", scale: "x", grid: true, values: logTicks(...domain, 7), title: `${kTimes[view.time].title}, milliseconds`, format: "~r", labelOverlap: true, labelPadding: 4},
      errorAxis(range, `error, ${kMeasures[view.measure].title}`),
    ],
    legends: [legendFor(colours, width)],
    marks: [
      {type: "line", from: {data: "steps"}, interactive: false, encode: {enter: {...at, interpolate: {value: "step-after"}, stroke: {value: "var(--accent)"}, strokeWidth: {value: 1.6}, strokeOpacity: {value: .8}}}},
      {type: "symbol", name: "points", from: {data: "runs"}, encode: {
        enter: {...at, shape: {field: "shape"}, size: {field: "size"}, fill: {scale: "colour", field: "group"}, stroke: [{test: "datum.onFront || datum.size > 100", value: "var(--ink)"}, {scale: "colour", field: "group"}],
                fillOpacity: {signal: "!datum.comparable ? 0.08 : datum.onFront || datum.size > 100 ? 0.95 : 0.45"}, tooltip: {field: "id"}, description: {field: "words"}, cursor: {value: "pointer"}},
        update: {strokeWidth: {value: 1.2}}, hover: {strokeWidth: {value: 3}}}},
      {type: "symbol", name: "ring", from: {data: "runs"}, interactive: false, encode: {
        enter: {...at, size: {value: 420}, fill: {value: null}, stroke: {value: "var(--ink)"}, strokeWidth: {value: 1.8}, aria: {value: false}}, update: {opacity: {signal: "datum.id === picked ? 1 : 0"}}}},
      {type: "symbol", name: "anchors", from: {data: "named"}, interactive: false, encode: {enter: {...at, size: {value: 200}, opacity: {value: 0}, aria: {value: false}}}},
      {type: "text", from: {data: "anchors"}, interactive: false, encode: {enter: {text: {field: "datum.text"}, fontSize: {value: 11.5}, fontWeight: {value: 600}, fill: {value: "var(--ink)"}}},
       transform: [{type: "label", size: {signal: "[width, height]"}, anchor: ["top-right", "right", "bottom-left", "top", "left", "bottom", "bottom-right", "top-left"], offset: [1], avoidMarks: ["points"]}]},
    ],
  };
}

// What the plot cannot show by itself.
function frontNotes(subject, view) {
  const runs = runsOf(subject);
  const measured = runs.filter(isMeasured);
  const count = (some, one, many) => some.length ? `${some.length} ${some.length === 1 ? one : many}` : null;
  const failed = count(runs.filter(run => run.failed != null), "run failed and is listed below", "runs failed and are listed below");
  return [
    "Numbers name the runs on the front, as in the table; a square is the default, a diamond the paper's choice.",
    count(measured.filter(run => run.error[view.measure] === 0), "run has an error of exactly 0: the triangle at the bottom, where a logarithmic axis has no place for it.", "runs have an error of exactly 0: the triangles at the bottom, where a logarithmic axis has no place for them."),
    count(measured.filter(run => !sameSize(run, subject)), "run drew a picture of another size (pale): its time does not compare.", "runs drew pictures of another size (pale): their times do not compare."),
    count(measured.filter(run => run.error[view.measure] == null || !(timeOf(run, view.time) > 0)), "run has no such measure and is not drawn.", "runs have no such measure and are not drawn."),
    failed && failed + ".",
  ].filter(Boolean).join(" ");
}
