// Tables of runs. The button in the first cell, or a click anywhere in the row, picks the run.

const kColumns = [
  {name: "p999", title: "99.9 %", of: run => run.error?.p999, text: errorText},
  {name: "max", title: "maximum", of: run => run.error?.max, text: errorText},
  {name: "rmse", title: "RMSE", of: run => run.error?.rmse, text: errorText},
  {name: "psnr", title: "PSNR", of: run => isMeasured(run) ? run.error.psnr ?? Infinity : null, text: value => value == null ? kNothing : value === Infinity ? "∞" : value.toFixed(1)},
  {name: "wall", title: "wall ms", of: run => run.frame_wall_ms?.median, spread: run => run.frame_wall_ms, text: timeText},
  {name: "cpu", title: "CPU ms", of: run => run.frame_cpu_ms?.median, spread: run => run.frame_cpu_ms, text: timeText},
  {name: "table", title: "table ms", of: run => run.table_ms, text: timeText},
  {name: "bytes", title: "bytes/px", of: run => run.bytes_per_pixel, text: countText},
  {name: "misordered", title: "misordered", of: run => run.certificate?.misordered, text: (value, run) => certificateText(run.certificate)},
];

function cell(column, run) {
  const spread = column.spread?.(run);
  const range = spread && spread.least != null ? make("small", {}, ` ${timeText(spread.least)}–${timeText(spread.most)}`) : null;
  return make("td", {}, column.text(column.of(run), run), range);
}

const tagOf = run => run.kind === "baseline" || run.kind === "paper" ? make("span", {class: "tag"}, kKinds[run.kind]) : null;

// lead: [{title, of(run)}], texts before the numbers; the first one is the button that picks.
function runTable(runs, lead, pick, order) {
  const head = column => make("th", {scope: "col", "aria-sort": order?.by === column.name ? (order.down ? "descending" : "ascending") : null},
                              order ? make("button", {type: "button", click: () => order.change(column.name)}, column.title) : column.title);
  const rows = runs.map((run, i) => make("tr", {"data-run": run.id, click: () => pick(run.id)},
    lead.map((column, c) => make("td", {class: column.long ? "prose" : "text"}, c === 0 ? make("button", {type: "button"}, String(column.of(run, i))) : column.of(run, i), c === lead.length - 1 ? tagOf(run) : null)),
    isMeasured(run) ? kColumns.map(column => cell(column, run))
                    : make("td", {class: "prose", colspan: kColumns.length}, run.failed != null ? "failed: " + run.failed : "not measured yet")));
  return make("table", {},
    make("thead", {}, make("tr", {}, lead.map(column => make("th", {scope: "col", class: "text"}, column.title)), kColumns.map(head))),
    make("tbody", {}, rows));
}

// All runs of a subject, ordered by the column whose heading was pressed last.
function allRunsTable(runs, pick) {
  const place = make("div", {class: "wide", tabindex: 0, role: "region", "aria-label": "All runs"});
  const order = {by: "wall", down: false, change(name) {
    order.down = order.by === name && !order.down;
    order.by = name;
    draw();
    markChosen();
  }};
  const draw = () => {
    const {of} = kColumns.find(column => column.name === order.by);
    const sign = order.down ? -1 : 1;
    const sorted = [...runs].sort((a, b) => sign * ((of(a) ?? Infinity) - (of(b) ?? Infinity) || 0));
    place.replaceChildren(runTable(sorted, [{title: "run", of: run => run.label, long: true}], pick, order));
  };
  draw();
  return place;
}
