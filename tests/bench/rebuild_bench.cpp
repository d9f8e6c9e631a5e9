// What bringing a table up to date costs after one control point has changed, against building it anew: the 3D table,
// the mean colours, the 2D table; the point at an end or in the middle of the scalar. CPU milliseconds, medians, in
// turn in one run after a warm-up; prints JSON.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "transfer/curve_change.h"
#include "transfer/mean_tables.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

constexpr double kLongest = 0.1;  // of the table, local units

ExtinctionCurve curveOf(const TransferFunction& function) { return withoutOpaque(makeCurve(function, {})); }

/// Times of `full` and `partial`, in turn.
nlohmann::ordered_json compare(int repeat, const std::function<void()>& full, const std::function<void()>& partial) {
  std::vector<double> times[2];
  for (int i = 0; i <= repeat; ++i)
    for (int which = 0; which < 2; ++which) {
      const double start = cpuSeconds();
      (which == 0 ? full : partial)();
      if (i > 0) times[which].push_back(1e3 * (cpuSeconds() - start));
    }
  const double whole = medianOf(times[0]), part = medianOf(times[1]);
  return {{"full_cpu_ms", whole}, {"rebuild_cpu_ms", part}, {"ratio", part / whole}};
}

nlohmann::ordered_json measure(const std::string& preset, std::size_t point, int size, int repeat) {
  TransferFunction function = loadTransferFunction(preset);
  const ExtinctionCurve before = curveOf(function);
  if (point >= function.points.size()) failInput("'" + preset + "' has no point " + std::to_string(point), "--points");
  function.points[point].opacity = 0.5 * function.points[point].opacity + 0.1;
  const ExtinctionCurve after = curveOf(function);
  const TouchedLines touched = touchedLines(before, after, size);
  Table3d colors = buildTable3d(before, size, kLongest), means = buildMeanColors(before, size / 2, kLongest);
  MeanTable2d flat = buildMeanTable2d(before, 4 * size, kLongest);
  nlohmann::ordered_json json;
  json["transfer_function"] = preset;
  json["scalar"] = function.points[point].scalar;
  json["touched_lines"] = {touched.first, touched.last};
  json["3d"] = compare(
      repeat, [&] { buildTable3d(after, size, kLongest); }, [&] { rebuildTable3d(colors, before, after); });
  json["3d-normalised"] = compare(
      repeat, [&] { buildMeanColors(after, size / 2, kLongest); }, [&] { rebuildMeanColors(means, before, after); });
  json["2d"] = compare(
      repeat, [&] { buildMeanTable2d(after, 4 * size, kLongest); }, [&] { rebuildMeanTable2d(flat, before, after); });
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  std::string preset = "viridis";
  std::vector<std::size_t> points{0, 1, 5, 8, 9};
  int size = 128, repeat = 5;
  CLI::App app("What bringing a table up to date costs; prints JSON");
  app.add_option("--tf", preset, "transfer function")->capture_default_str();
  app.add_option("--points", points, "control points to change, one at a time")->capture_default_str();
  app.add_option("--table", size, "entries of the 3D table along each axis")->capture_default_str();
  app.add_option("--repeat", repeat, "counted builds")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    nlohmann::ordered_json json{{"table", size}, {"repeat", repeat}, {"edits", nlohmann::json::array()}};
    for (const std::size_t point : points) json["edits"].push_back(havs::measure(preset, point, size, repeat));
    std::cout << json.dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_rebuild: " << error.what() << '\n';
    return error.exitStatus();
  }
}
