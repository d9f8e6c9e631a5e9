// Puts the page together, and again when another subject, measure or time is chosen.

const vegaTransforms = ["vega-transforms", "vega-view-transforms", "vega-encode", "vega-label"];
Object.assign(vega["vega-dataflow"].transforms, ...vegaTransforms.map(name => vega[name]));

const view = {subject: subjects[0], measure: "p999", time: "frame_wall_ms", colour: "lookup", run: null};
const meshName = subject => subject.mesh?.split("/").at(-1) ?? subject.id;

function subjectTitle(subject) {
  const same = subjects.filter(other => meshName(other) === meshName(subject));
  const parts = [meshName(subject)];
  if (new Set(same.map(other => other.field)).size > 1) parts.push(subject.field);
  if (new Set(same.map(other => other.transfer_function)).size > 1) parts.push(subject.transfer_function);
  const title = parts.join(", ");
  return same.length > 1 && parts.length < 3 ? `${title} (${subject.id})` : title;
}

function showHead() {
  const title = "Accuracy against time: " + [...new Set(subjects.map(meshName))].join(", ");
  document.title = title;
  const runs = study.runs ?? [], effects = study.effects ?? [], failed = [...runs, ...effects].filter(run => run.failed != null).length;
  const date = study.created ? new Date(study.created) : null;
  byId("head").append(make("h1", {}, title), make("code", {class: "command"}, study.command ?? ""),
    make("p", {class: "facts"}, [
      `${runs.length} runs${effects.length ? `, ${effects.length} effects` : ""}${failed ? `, ${failed} of them failed` : ""}`, date && !isNaN(date) ? date.toISOString().slice(0, 16).replace("T", " ") + " UTC" : null,
      study.machine?.cpu && `${study.machine.cpu}, ${study.machine.threads ?? "?"} threads`, study.machine?.renderer, study.machine?.havs && `havs ${study.machine.havs}`].filter(Boolean).join(" · ")));
  if (study.complete === false) byId("head").append(make("p", {class: "notice"}, "This study is not finished: the same command goes on with it. What is shown is what has been measured so far."));
  const missing = document.querySelector("#missing-pictures")?.textContent;
  if (missing) byId("head").append(make("p", {class: "notice"}, missing));
}

function subjectFacts(subject) {
  const pixels = subject.size ? subject.size[0] * subject.size[1] : null;
  return make("p", {class: "facts", id: "subject-facts"}, [
    `${subject.mesh}: ${countText(subject.points)} points, ${countText(subject.cells)} cells, ${countText(subject.faces)} faces`, `field ${subject.field}`, `transfer function ${subject.transfer_function}`,
    `${settingText(subject.size)} pixels`, subject.masked_pixels != null && `${countText(subject.masked_pixels)} of ${countText(pixels)} masked`,
    subject.reference?.wall_ms != null && `the reference took ${timeText(subject.reference.wall_ms)} ms (${timeText(subject.reference.cpu_ms)} ms CPU)`].filter(Boolean).join(" · "));
}

function showSubjects() {
  if (subjects.length > 1)
    byId("subjects").replaceChildren(radios("subject", "Drawn:", Object.fromEntries(subjects.map(subject => [subject.id, subjectTitle(subject)])), view.subject.id, id => {
      view.subject = subjects.find(subject => subject.id === id);
      view.run = null;
      showSubject();
    }));
}

function showChoices() {
  const keys = ["kind", ...varyingSettings(runsOf(view.subject).filter(isMeasured))];
  const change = key => value => { view[key] = value; showSubject(); };
  const select = make("select", {id: "colour", change: event => { view.colour = event.target.value; showFront(); }},
    keys.map(key => make("option", {value: key, selected: key === view.colour}, key === "kind" ? "kind of run" : settingName(key))));
  byId("front-choices").replaceChildren(
    radios("measure", "Error:", Object.fromEntries(Object.entries(kMeasures).map(([key, {title}]) => [key, title])), view.measure, change("measure")),
    radios("time", "Time:", Object.fromEntries(Object.entries(kTimes).map(([key, {short}]) => [key, short])), view.time, change("time")),
    make("label", {}, "Colour: ", select));
}

async function showFront() {
  byId("measure-note").textContent = kMeasures[view.measure].means;
  byId("front-note").textContent = frontNotes(view.subject, view);
  byId("front-table").replaceChildren(runTable(frontOf(view.subject, view.measure, view.time),
    [{title: "", of: (run, i) => i + 1}, {title: "run", of: run => run.label, long: true}], pickIn(byId("front-slot"))));
  markChosen();
  await showPlot(byId("front-plot"), width => frontSpec(view.subject, view, width), pickIn(byId("front-slot")));
}

// Picks a run and shows it in the slot of the section where it was picked.
const pickIn = slot => id => {
  const run = runById.get(id);
  if (!run) return;
  view.run = id;
  byId("run")?.remove();
  slot.append(runPanel(run, view.subject));
  markChosen();
  shownPlots.get(byId("front-plot"))?.view.signal("picked", id).runAsync();
};

function markChosen() {
  for (const row of document.querySelectorAll("tr[data-run]")) row.classList.toggle("chosen", row.dataset.run === view.run);
}

function fill(section, title, ...content) {
  forgetPlots(section);
  section.replaceChildren(...(content.length ? [title && make("h2", {}, title), ...content].filter(Boolean) : []));
}

async function showSubject() {
  const subject = view.subject, runs = runsOf(subject);
  byId("subject-facts")?.remove();
  byId("front").before(subjectFacts(subject));
  if (view.colour !== "kind" && !varyingSettings(runs).includes(view.colour)) view.colour = "kind";
  showChoices();
  const shown = [];
  const axes = (study.axes ?? []).map(axis => {
    const section = axisSection(subject, axis, view, id => pickIn(section.querySelector(".slot"))(id));
    return section;
  }).filter(Boolean);
  const fits = fitSections(subject);
  const failed = [...runs, ...effectsOf(subject)].filter(run => run.failed != null);
  fill(byId("axes"), "One setting at a time", ...(axes.length ? [make("p", {}, "Everything else as in the default run. Pick a row to see its pictures."), ...axes] : []));
  fill(byId("fits"), "Order of accuracy", ...(fits.length ? [make("p", {},
    "How fast the error falls as a table gets more entries, or a segment more samples: the slope of the line through the filled points, on logarithmic axes. −2 means that twice as many leave a quarter of the error. Hollow points were not used: there other errors dominate, or the order has not set in yet."),
    make("div", {class: "pair"}, fits)] : []));
  fill(byId("effects"), "What effects cost", ...effectsSection(subject));
  const skipped = study.skipped ?? [];
  const skippedList = skipped.length ? [make("p", {}, "Left out of the study:"), make("ul", {}, skipped.map(text => make("li", {}, text)))] : [];
  fill(byId("failed"), failed.length ? "Runs that failed" : "What was left out", ...skippedList, ...(failed.length ? [make("div", {class: "wide"}, make("table", {},
    make("thead", {}, make("tr", {}, make("th", {class: "text", scope: "col"}, "run"), make("th", {class: "text", scope: "col"}, "reason"))),
    make("tbody", {}, failed.map(run => make("tr", {}, make("td", {class: "text"}, run.label), make("td", {class: "prose"}, run.failed))))))] : []));
  const slot = make("div", {class: "slot"});
  fill(byId("all"), null, make("details", {}, make("summary", {}, `All ${runs.length} runs`), allRunsTable(runs, pickIn(slot)), slot));
  shown.push(showFront(), ...axes.map(section => section.draw?.()), ...fits.map(section => section.draw()));
  const first = runs.find(run => run.id === view.run)?.id ?? (runs.find(run => run.kind === "baseline" && isMeasured(run)) ?? runs.find(isMeasured) ?? runs[0])?.id;
  pickIn(byId("front-slot"))(first);
  await Promise.all(shown);
}

// Arrow keys on the plot go from run to run in the order of time.
byId("front-plot").addEventListener("keydown", event => {
  const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
  if (!step) return;
  event.preventDefault();
  const runs = runsOf(view.subject).filter(isMeasured).sort((a, b) => timeOf(a, view.time) - timeOf(b, view.time));
  const next = runs.findIndex(run => run.id === view.run) + step;
  pickIn(byId("front-slot"))(runs[Math.max(0, Math.min(next, runs.length - 1))]?.id);
});

async function saveFront(kind) {
  const plot = shownPlots.get(byId("front-plot")).view;
  const name = `front-${view.subject.id}-${view.measure}.${kind}`;
  const svg = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(await plotAsSvg(plot));
  if (kind === "svg") return saveAs(name, svg);
  const picture = make("img", {src: svg});
  await picture.decode();
  const canvas = make("canvas", {width: 3 * picture.width, height: 3 * picture.height});
  canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
  saveAs(name, canvas.toDataURL());
}
byId("save-svg").addEventListener("click", () => saveFront("svg"));
byId("save-png").addEventListener("click", () => saveFront("png"));

function showEnd() {
  byId("words").append(make("h2", {}, "Words"), definitions(kGlossary, {class: "words"}));
  const machine = Object.entries(study.machine ?? {}).map(([key, value]) => [settingName(key.replace("_bytes", "")), key === "memory_bytes" ? bytesText(value) : settingText(value)]);
  if (machine.length) byId("machine").append(make("h2", {}, "Machine and versions"), definitions(machine));
  const held = [...document.querySelectorAll("script[data-picture]")];
  const bytes = held.reduce((sum, script) => sum + script.textContent.length * 3 / 4, 0);
  byId("foot").append(make("p", {}, `This page is one file: ${held.length} pictures (${bytesText(bytes)}) and the plots, drawn by Vega 5, are in it; it loads nothing. The numbers are in study.json and study.csv beside it.`));
}

showHead();
if (subjects.length) {
  showSubjects();
  await showSubject();
} else {
  byId("front").replaceChildren(make("p", {class: "notice"}, "Nothing has been measured yet."));
}
showEnd();
document.documentElement.dataset.ready = "yes";
