// What is measured, in words: the measures, the columns of the tables, and how numbers are written.

const kMeasures = {
  p999: {title: "99.9th percentile", means: "Of all pixels, one in a thousand is further from the reference than this. A pixel's error is that of its worst channel; 1 is the whole range from black to white."},
  max: {title: "maximum", means: "The error of the worst pixel."},
  rmse: {title: "RMSE", means: "Root of the mean squared error over all pixels and channels. Averages hide a few pixels that are very wrong; the two measures above do not."},
};

const kTimes = {
  frame_wall_ms: {title: "wall time of a frame", short: "wall"},
  frame_cpu_ms: {title: "processor time of a frame", short: "CPU"},
};

const kKinds = {axis: "one setting varied", front: "settings combined", baseline: "default", paper: "the paper's choice"};

const kGlossary = [
  ["Error", "Difference from the reference picture in red, green, blue and opacity, as linear floating-point numbers. The reference is computed in double precision without tables or sorting shortcuts."],
  ["99.9th percentile", kMeasures.p999.means],
  ["Maximum", kMeasures.max.means],
  ["RMSE", kMeasures.rmse.means],
  ["PSNR", "20 log10(1 / RMSE), in decibels. Infinite where the pictures are equal."],
  ["SSIM", "Structural similarity, 1 where the pictures are equal."],
  ["Wall, CPU", "Milliseconds for one frame (order, upload, draw, flush) by the clock, and summed over all processors. Medians; in small print the least and the most."],
  ["Table", "Milliseconds to build the lookup table, once before the first frame. Not part of the frame."],
  ["Once", "Milliseconds before the first picture: preparing the mesh after it has been read, what is computed at its points, the table, uploads; and what is computed for a view, as shadows are."],
  ["Kept", "Memory that the plan of the run foresees."],
  ["Bytes a pixel", "What the frame buffers hold for one pixel."],
  ["Misordered", "The order certificate: fragments that came too late to be composited in their place. Zero means that the order of this picture is exact."],
  ["Masked pixels", "Pixels whose centre lies within 1/128 pixel of the outline. A rasteriser may put them on either side, so no method is charged for them: the measures leave them out unless it says otherwise."],
  ["Front", "The runs that no other run beats in both time and error."],
  ["The paper's choice", "k = 6, 8-bit table of 128 x 128 x 128, faces ordered by their centroids."],
];

const kNothing = "–";

const errorText = value => value == null ? kNothing : value === 0 ? "0" : value.toExponential(2).replace("e+", "e");

function timeText(value) {
  if (value == null) return kNothing;
  const digits = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3;
  return value.toLocaleString("en", {minimumFractionDigits: digits, maximumFractionDigits: digits});
}

const countText = value => value == null ? kNothing : value.toLocaleString("en");

function bytesText(value) {
  if (!value) return kNothing;
  const power = Math.min(4, Math.floor(Math.log2(value) / 10));
  return `${(value / 1024 ** power).toLocaleString("en", {maximumFractionDigits: power ? 1 : 0})} ${["bytes", "KiB", "MiB", "GiB", "TiB"][power]}`;
}

function settingText(value) {
  if (value == null) return kNothing;
  if (Array.isArray(value)) return value.join(" x ");
  if (typeof value === "boolean") return value ? "yes" : "no";
  return String(value);
}

const settingName = key => key.replaceAll("_", " ");

function certificateText(certificate) {
  if (!certificate) return kNothing;
  return certificate.misordered === 0 ? "0" : `${countText(certificate.misordered)} in ${countText(certificate.pixels)} px`;
}
