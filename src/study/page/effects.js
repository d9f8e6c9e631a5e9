// What each effect costs: the picture with it beside the picture without, which were drawn in turn; and the ledger of a run.

const effectsOf = subject => (study.effects ?? []).filter(effect => effect.subject === subject.id);

// What lies with the effect, and what without it: the run of the effect is one of them, the default the other.
function sidesOf(effect) {
  return effect.adds ? {with: effect, without: effect.baseline} : {with: effect.baseline, without: effect};
}

const signed = (value, text) => value == null || isNaN(value) ? kNothing : value < 0 ? "−" + text(-value) : text(value);
const ratioText = value => value == null ? kNothing : value.toFixed(2);
const bytesMore = (a, b) => a == null || b == null ? kNothing : a === b ? "0" : signed(a - b, bytesText);

const kEffectColumns = [
  {title: "without, ms", of: (effect, {without}) => timeText(without?.frame_wall_ms?.median)},
  {title: "with, ms", of: (effect, side) => timeText(side.with?.frame_wall_ms?.median)},
  {title: "times, wall", of: effect => ratioText(effect.wall_ratio?.median), small: effect => effect.wall_ratio && `${ratioText(effect.wall_ratio.least)}–${ratioText(effect.wall_ratio.most)}`},
  {title: "times, CPU", of: effect => ratioText(effect.cpu_ratio?.median), small: effect => effect.cpu_ratio && `${ratioText(effect.cpu_ratio.least)}–${ratioText(effect.cpu_ratio.most)}`},
  {title: "more once, ms", of: (effect, side) => signed((side.with?.prepare_ms ?? NaN) - (side.without?.prepare_ms ?? NaN), timeText)},
  {title: "more kept", of: (effect, side) => bytesMore(side.with?.bytes, side.without?.bytes)},
  {title: "error without, 99.9 %", of: (effect, {without}) => errorText(without?.error?.p999)},
  {title: "error with, 99.9 %", of: (effect, side) => errorText(side.with?.error?.p999)},
];

function effectRow(effect, pick) {
  const side = isMeasured(effect) ? sidesOf(effect) : null;
  const cells = side ? kEffectColumns.map(column => make("td", {}, column.of(effect, side), column.small?.(effect) ? make("small", {}, ` ${column.small(effect)}`) : null))
                     : [make("td", {class: "prose", colspan: kEffectColumns.length}, effect.failed != null ? "failed: " + effect.failed : "not measured yet")];
  return make("tr", {"data-run": effect.id, click: () => pick(effect.id)},
    make("td", {class: "prose", title: effect.description}, make("button", {type: "button"}, effect.label)), cells);
}

function effectsSection(subject) {
  const effects = effectsOf(subject);
  if (!effects.length) return [];
  const slot = make("div", {class: "slot"});
  const table = make("table", {},
    make("thead", {}, make("tr", {}, make("th", {scope: "col", class: "text"}, "picture"), kEffectColumns.map(column => make("th", {scope: "col"}, column.title)))),
    make("tbody", {}, effects.map(effect => effectRow(effect, pickIn(slot)))));
  return [make("p", {}, "Each picture is the default run with one effect more, or with one of its own left out; the two were drawn in turn. Times: a frame with the effect over one without it, the median of the pairs. Once: what is computed before the first picture, and for a view. Kept: memory, as the plan foresees it. Each error is against the reference of that picture. Pick a row to see it and its costs, stage by stage."),
          make("div", {class: "wide", tabindex: 0, role: "region", "aria-label": "What effects cost"}, table), slot];
}

// Milliseconds and bytes of what the plan of a run lists.
function ledgerTable(run) {
  if (!run.ledger?.length) return null;
  const row = stage => make("tr", {}, make("td", {class: "text"}, settingName(stage.stage)), make("td", {}, timeText(stage.ms)), make("td", {}, bytesText(stage.bytes)),
    make("td", {class: "prose"}, stage.items.map(item => item.name).join("; ")));
  return make("details", {class: "ledger"}, make("summary", {}, "Where time and memory go"),
    make("div", {class: "wide"}, make("table", {},
      make("thead", {}, make("tr", {}, ["stage", "wall ms", "bytes", "for"].map((title, i) => make("th", {scope: "col", class: i === 0 || i === 3 ? "text" : null}, title)))),
      make("tbody", {}, run.ledger.map(row)))));
}
