// The run that was picked: its settings and measures, and its picture beside the reference and the difference.

// Pictures wait as text until one is looked at; then the browser decodes it.
function pictureOf(name) {
  const held = name && document.querySelector(`script[data-picture="${CSS.escape(name)}"]`);
  return held ? {uri: held.textContent, reduced: Number(held.dataset.reduced ?? 1), name} : null;
}

function figure(picture, caption, kind) {
  const note = picture?.reduced > 1 ? ` Here at 1/${picture.reduced} of its size; whole in ${picture.name}.` : "";
  return make("figure", {"data-kind": kind},
    picture ? make("img", {src: picture.uri, alt: caption, decoding: "async"}) : make("div", {class: "none"}, "no picture was kept"), make("figcaption", {}, caption + note));
}

function measureRows(run) {
  const without = run.error ?? {}, whole = run.error_with_masked_pixels;
  const line = (title, key, text) => [title, text(without[key]) + (whole && text(whole[key]) !== text(without[key]) ? ` (${text(whole[key])} with the masked pixels)` : "")];
  const psnr = value => value == null ? "infinite" : `${value.toFixed(1)} dB`;
  return [line("99.9th percentile", "p999", errorText), line("Maximum", "max", errorText), line("RMSE", "rmse", errorText), line("PSNR", "psnr", psnr),
          line("SSIM", "ssim", value => value == null ? kNothing : value.toFixed(6)), ["Misordered", run.certificate ? certificateText(run.certificate) : "not counted"]];
}

function timeRows(run) {
  const span = time => time ? `${timeText(time.median)} ms (${timeText(time.least)} to ${timeText(time.most)})` : kNothing;
  return [["Wall", span(run.frame_wall_ms)], ["CPU", span(run.frame_cpu_ms)], ["Table", run.table_ms == null ? kNothing : `${timeText(run.table_ms)} ms`],
          ...(run.prepare_ms == null ? [] : [["Once", `${timeText(run.prepare_ms)} ms`]]), ["Repetitions", countText(run.repetitions)], ["Bytes a pixel", countText(run.bytes_per_pixel)], ...(run.bytes == null ? [] : [["Kept", bytesText(run.bytes)]])];
}

// A run with another effect is another picture, with a reference of its own.
const referenceOf = (run, subject) => pictureOf(run.effect != null ? run.reference : sameSize(run, subject) ? subject.reference?.image : null);

function runPanel(run, subject) {
  const settings = Object.entries(run.settings ?? {}).map(([key, value]) => [settingName(key), settingText(value)]);
  const panel = make("div", {class: "run", id: "run", "data-run": run.id, "aria-live": "polite"}, make("h3", {}, run.label, tagOf(run)));
  if (!isMeasured(run)) panel.append(make("p", {class: "notice"}, run.failed != null ? "This run failed: " + run.failed : "This run has not been measured yet."));
  else panel.append(make("div", {class: "pictures"},
    figure(pictureOf(run.image), "This run.", "image"),
    figure(referenceOf(run, subject), sameSize(run, subject) ? "The reference." : "The reference of this size was not kept.", "reference"),
    figure(pictureOf(run.difference), run.difference ? "Their difference, on the scale of its colour bar." : "Their difference.", "difference")));
  if (isMeasured(run)) panel.append(make("p", {class: "tools"}, make("button", {type: "button", "aria-pressed": "false", click: event => {
    const whole = panel.querySelector(".pictures").classList.toggle("whole");
    event.target.setAttribute("aria-pressed", whole);
  }}, "Pictures pixel by pixel")));
  panel.append(make("div", {class: "columns"}, isMeasured(run) ? [definitions(measureRows(run)), definitions(timeRows(run))] : [], definitions(settings)));
  if (isMeasured(run)) panel.append(...[ledgerTable(run)].filter(Boolean));
  return panel;
}

// The tip beside the pointer.
function showTip(event, id) {
  const tip = byId("tip"), run = runById.get(id);
  tip.hidden = !run;
  if (!run) return;
  const rows = [["Time", `${timeText(run.frame_wall_ms.median)} ms wall, ${timeText(run.frame_cpu_ms?.median)} ms CPU`],
                ["Error", `${errorText(run.error.p999)} (99.9 %), ${errorText(run.error.max)} at most, RMSE ${errorText(run.error.rmse)}`],
                ["Misordered", run.certificate ? certificateText(run.certificate) : "not counted"],
                ["Settings", Object.entries(run.settings ?? {}).filter(([, value]) => value != null).map(([key, value]) => `${settingName(key)} ${settingText(value)}`).join(", ")]];
  tip.replaceChildren(make("strong", {}, run.label + (run.kind === "paper" || run.kind === "baseline" ? ` (${kKinds[run.kind]})` : "")), definitions(rows));
  const box = tip.getBoundingClientRect(), gap = 14;
  const left = event.clientX + gap + box.width > innerWidth ? event.clientX - gap - box.width : event.clientX + gap;
  tip.style.left = `${Math.max(4, Math.min(left, innerWidth - box.width - 4))}px`;
  tip.style.top = `${Math.max(4, Math.min(event.clientY + gap, innerHeight - box.height - 4))}px`;
}
addEventListener("scroll", () => { byId("tip").hidden = true; }, {passive: true});
