// The study as the page asks for it: the runs of a subject, its front, which settings differ.

const study = JSON.parse(document.getElementById("study").textContent);
const subjects = study.subjects ?? [];
const runById = new Map([...study.runs ?? [], ...study.effects ?? []].map(run => [run.id, run]));

const runsOf = subject => (study.runs ?? []).filter(run => run.subject === subject.id);
const isMeasured = run => run.failed == null && run.error != null && run.frame_wall_ms != null;
const sameSize = (run, subject) => !run.settings?.size || settingText(run.settings.size) === settingText(subject.size);
const timeOf = (run, time) => run[time]?.median;

// The runs that none beats in time and error, fastest first. Times of pictures of another size do not compare.
function frontOf(subject, measure, time) {
  const runs = runsOf(subject).filter(run => isMeasured(run) && sameSize(run, subject) &&
                                             timeOf(run, time) != null && run.error[measure] != null);
  if (measure === "p999" && time === "frame_wall_ms" && runs.some(run => run.on_front))
    return runs.filter(run => run.on_front).sort((a, b) => timeOf(a, time) - timeOf(b, time));
  runs.sort((a, b) => timeOf(a, time) - timeOf(b, time) || a.error[measure] - b.error[measure]);
  let best = Infinity;
  return runs.filter(run => run.error[measure] < best && ((best = run.error[measure]), true));
}

// The settings that are not the same in all of the runs.
function varyingSettings(runs) {
  const keys = new Set(runs.flatMap(run => Object.keys(run.settings ?? {})));
  return [...keys].filter(key => new Set(runs.map(run => settingText(run.settings?.[key]))).size > 1);
}

// Where a run stands on an axis, by its settings; undefined where the settings do not tell.
function valueOn(axis, run) {
  const value = run.settings?.[axis.name.replaceAll("-", "_")];
  if (value == null) return undefined;
  return Array.isArray(value) ? String(Math.max(...value)) : settingText(value);
}

// The runs of an axis in the order of its values. A way to draw that belongs to several axes is measured only once, as the
// default is: so every run counts that differs from it in nothing else, and on an axis that is swept across another (the
// table's size across the lookups) every run that differs from one of the axis in nothing else. What a value brings along
// (each lookup the size of its own table) tells no series apart.
function axisRuns(subject, axis) {
  const others = run => JSON.stringify({...run.settings, [axis.name.replaceAll("-", "_")]: null});
  const all = runsOf(subject);
  const own = all.filter(run => run.axis === axis.name);
  const baseline = all.find(run => run.kind === "baseline");
  const series = new Set([...(axis.across ? own : []), ...(own.length && baseline ? [baseline] : [])].map(others));
  const borrowed = all.filter(run => run.axis !== axis.name && series.has(others(run)) && axis.values.includes(valueOn(axis, run)));
  const isNew = run => !own.some(other => other.value === valueOn(axis, run) && (!axis.across || others(other) === others(run)));
  const place = run => axis.values.includes(run.value) ? axis.values.indexOf(run.value) : axis.values.length;
  return [...own, ...borrowed.filter(isNew).map(run => ({...run, value: valueOn(axis, run)}))].sort((a, b) => place(a) - place(b));
}

// Runs of an axis that differ in more than the axis (say, in lookup too) belong to different series, each with a name.
function seriesOf(runs) {
  const keys = varyingSettings(runs).filter(key => {
    const pairs = new Set(runs.map(run => run.value + "\n" + settingText(run.settings?.[key])));
    return pairs.size > new Set(runs.map(run => run.value)).size;
  });
  return run => keys.map(key => settingText(run.settings?.[key])).join(", ");
}
