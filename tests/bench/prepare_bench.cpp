// What it costs to make a mesh ready, to order its faces and to build tables, stage by stage: wall and processor
// milliseconds (medians after a warm-up; beside other work the least says more) and the memory of the process at the
// stage's peak beyond what it held before, in bytes a tetrahedron, for 1 thread and for 2. Prints JSON.
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench_mesh.h"
#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "render/make_renderer.h"
#include "scene/camera.h"
#include "scene/prepared_scene.h"
#include "sort/face_order.h"
#include "support/resident_memory.h"
#include "transfer/mean_tables.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1.9e-6";
  std::string field = "s";
  std::vector<std::size_t> threads{1, 2};
  std::vector<std::string> transferFunctions{"rainbow", "three-peaks", "shells"};
  std::vector<std::string> only;
  int repeat = 5;
};

/// Runs stages and collects what each took.
class Bench {
 public:
  Bench(const Options& options, std::size_t tetrahedra) : options_(options), tetrahedra_(tetrahedra) {}

  /// Times work(); before each run renew() is called and not counted.
  void stage(const std::string& name, const std::function<void()>& work, const std::function<void()>& renew = {}) {
    const auto& only = options_.only;
    if (!only.empty() && std::none_of(only.begin(), only.end(), [&](const auto& o) { return name.starts_with(o); }))
      return;
    std::vector<double> wall, cpu;
    double memory = 0;
    for (int run = 0; run <= options_.repeat; ++run) {
      if (renew) renew();
      const std::size_t before = test::residentBytes();
      test::resetPeak();
      const double cpuBefore = cpuSeconds();
      const auto start = std::chrono::steady_clock::now();
      work();
      const double took = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      memory = std::max(memory, static_cast<double>(test::peakResidentBytes()) - static_cast<double>(before));
      if (run == 0 && options_.repeat > 0) continue;  // to warm up
      wall.push_back(took);
      cpu.push_back(1e3 * (cpuSeconds() - cpuBefore));
    }
    json_[name] = {{"wall_ms", medianOf(wall)},
                   {"cpu_ms", medianOf(cpu)},
                   {"least_cpu_ms", *std::min_element(cpu.begin(), cpu.end())},
                   {"bytes_a_tetrahedron", memory / static_cast<double>(tetrahedra_)}};
  }
  const nlohmann::ordered_json& json() const { return json_; }

 private:
  Options options_;
  std::size_t tetrahedra_;
  nlohmann::ordered_json json_;
};

void prepareStages(Bench& bench, const TetMesh& original, const Scene& scene, PreparedScene& prepared) {
  TetMesh copy, mended = repairMesh(original);
  const auto renewed = [&] { copy = original; };
  StageTimes times;
  bench.stage("prepare inspect", [&] { inspectMesh(original); });
  bench.stage(
      "prepare repair", [&] { mended = repairMesh(std::move(copy)); }, renewed);
  bench.stage("prepare field", [&] { selectField(mended, scene.field); });
  const LocalFrame frame = localFrame(mended);
  const std::vector<Vec3> points = localPoints(mended, frame);
  bench.stage("prepare frame", [&] { localFrame(mended); });
  bench.stage("prepare points", [&] { localPoints(mended, frame); });
  bench.stage("prepare longest edge", [&] { longestEdge(mended, points); });
  bench.stage("faces", [&] { buildFaces(mended); });
  prepared = {};
  malloc_trim(0);
  bench.stage(
      "prepare and faces, whole", [&] { prepared = prepareScene(scene, std::move(copy), times); },
      [&] {
        prepared = {};
        copy = original;
      });
  if (prepared.points.empty()) prepared = prepareScene(scene, original, times);
}

void orderStages(Bench& bench, const PreparedScene& prepared) {
  const SortInput input{prepared.points, prepared.mesh.tetrahedra, &prepared.faces};
  const SortMethod& method = sortMethod("topological");
  std::unique_ptr<FaceSorter> sorter;
  FaceOrder order;
  Camera camera;
  const auto sort = [&] { sorter->sort(viewPointOf(makeView(camera, prepared.frame, 1024, 1024)), order); };
  bench.stage(
      "sorter", [&] { sorter = method.make(input); }, [&] { sorter.reset(); });
  if (!sorter) sorter = method.make(input);
  bench.stage("order", sort, [&] { camera.azimuth += 20; });
  bench.stage("order, same eye again", sort);
  sorter = sortMethod("centroid").make(input);
  bench.stage("order by centroid", sort, [&] { camera.azimuth += 20; });
}

/// How many faces show the eye their other side when it goes round by so many degrees: the order can only be taken from
/// the last view where there are none.
nlohmann::ordered_json facesThatTurn(const PreparedScene& prepared) {
  const auto turnedBy = [&](double degrees) {
    Camera camera;
    const Vec3 before = makeView(camera, prepared.frame, 1024, 1024).eye;
    camera.azimuth += degrees;
    const Vec3 after = makeView(camera, prepared.frame, 1024, 1024).eye;
    std::size_t count = 0;
    for (const auto& [i, j, k] : prepared.faces.vertices) {
      const Vec3& a = prepared.points[i];
      const Vec3 normal = cross(prepared.points[j] - a, prepared.points[k] - a);
      count += (dot(normal, before - a) > 0) != (dot(normal, after - a) > 0) ? 1 : 0;
    }
    return count;
  };
  nlohmann::ordered_json json;
  for (const char* degrees : {"1e-5", "1e-3", "0.1", "1", "10"}) json[degrees] = turnedBy(std::stod(degrees));
  return json;
}

void tableStages(Bench& bench, const PreparedScene& prepared, const std::vector<std::string>& transferFunctions) {
  for (const std::string& name : transferFunctions) {
    CurveSetting setting;
    const ExtinctionCurve curve = withoutOpaque(makeCurve(loadTransferFunction(name), setting));
    const std::string of = " of " + name + " (" + std::to_string(curve.knots.size()) + " knots)";
    bench.stage("table 3d 128" + of, [&] { buildTable3d(curve, 128, prepared.longestEdge); });
    bench.stage("table 3d-normalised 64" + of, [&] { buildMeanColors(curve, 64, prepared.longestEdge); });
    bench.stage("table 2d 512" + of, [&] { buildMeanTable2d(curve, 512, prepared.longestEdge); });
  }
}

nlohmann::ordered_json measure(const Options& options) {
  TetMesh mesh = benchMesh(options.mesh, options.switches);
  Scene scene;
  scene.field = options.field;
  nlohmann::ordered_json json{{"mesh", options.mesh},
                              {"points", mesh.points.size()},
                              {"tetrahedra", mesh.tetrahedra.size()},
                              {"repeat", options.repeat}};
  for (const std::size_t threads : options.threads) {
    const ThreadLimit limit(threads);
    Bench bench(options, mesh.tetrahedra.size());
    PreparedScene prepared;
    prepareStages(bench, mesh, scene, prepared);
    orderStages(bench, prepared);
    tableStages(bench, prepared, options.transferFunctions);
    json["threads"][std::to_string(threads)] = bench.json();
    json["faces"] = prepared.faces.size();
    json["faces_that_turn_by_degrees"] = facesThatTurn(prepared);
  }
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  // What is freed goes back to the system, so that each stage pays for its memory as the first does.
  mallopt(M_MMAP_THRESHOLD, 1 << 18);
  mallopt(M_TRIM_THRESHOLD, 1 << 18);
  havs::Options options;
  CLI::App app("What it costs to prepare, to order and to build tables; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--field", options.field, "a field of the mesh")->capture_default_str();
  app.add_option("--threads", options.threads, "numbers of threads")->capture_default_str();
  app.add_option("--tf", options.transferFunctions, "transfer functions of the tables")->capture_default_str();
  app.add_option("--only", options.only, "only stages whose names begin so");
  app.add_option("--repeat", options.repeat, "counted runs")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_prepare: " << error.what() << '\n';
    return error.exitStatus();
  }
}
