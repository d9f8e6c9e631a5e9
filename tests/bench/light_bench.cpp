// What the data of lighting cost a mesh, and how far gradients and the table of scattering are off: wall and processor
// milliseconds, medians after a warm-up, for 1 thread and for 2; prints JSON.
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
#include "light/ambient_scattering.h"
#include "light/point_gradients.h"
#include "mesh/defects.h"
#include "mesh/local_frame.h"
#include "mesh/spatial_order.h"
#include "unit/light/gradient_errors.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1e-5";
  std::string transferFunction = "rainbow";
  std::vector<std::size_t> threads{1, 2};
  double g = 0.6;
  int repeat = 5;
};

nlohmann::ordered_json timed(int repeat, const std::function<void()>& work) {
  std::vector<double> wall, cpu;
  for (int run = 0; run <= repeat; ++run) {
    const double cpuBefore = cpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    work();
    if (run == 0) continue;  // to warm up
    wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    cpu.push_back(1e3 * (cpuSeconds() - cpuBefore));
  }
  return {{"wall_ms", medianOf(wall)}, {"cpu_ms", medianOf(cpu)}};
}

/// The mesh in its local frame, as a scene has it.
TetMesh localMesh(const Options& options) {
  const TetMesh mended = repairMesh(benchMesh(options.mesh, options.switches));
  TetMesh mesh = renumbered(mended, spatialNumbers(mended.points, mended.tetrahedra));
  mesh.points = localPoints(mesh, localFrame(mesh));
  return mesh;
}

nlohmann::ordered_json gradientErrors(const TetMesh& mesh, const PointCells& around) {
  const std::vector<double> values = test::smoothField(mesh.points);
  const auto json = [&](const std::vector<Vec3>& gradients) {
    const test::GradientErrors errors = test::errorsOf(mesh, gradients);
    return nlohmann::ordered_json{{"rms_inside", errors.inside}, {"rms", errors.all}};
  };
  return {{"mean_of_cells", json(pointGradients(mesh.points, mesh.tetrahedra, around, values, false))},
          {"least_squares", json(test::leastSquares(mesh, values, 0))},
          {"least_squares_by_distance", json(test::leastSquares(mesh, values, 2))}};
}

/// Root mean square over the sphere of the difference between two seeds, over sqrt(2) and the mean.
double relativeError(const Options& options, double albedo, double tau) {
  const ScatteringTable one({options.g, 32768, 1}), two({options.g, 32768, 2});
  double squares = 0, sum = 0;
  constexpr int kSteps = 500;
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = -1 + 2 * (i + 0.5) / kSteps;
    const double a = one.sum(albedo, tau, cosine), b = two.sum(albedo, tau, cosine);
    squares += (a - b) * (a - b) / 2 / (a * b);
    sum += 1;
  }
  return std::sqrt(squares / sum);
}

nlohmann::ordered_json measure(const Options& options) {
  const TetMesh mesh = localMesh(options);
  const Faces faces = buildFaces(mesh);
  const ExtinctionCurve curve = makeCurve(loadTransferFunction(options.transferFunction), {{0, 1}, 2, 1, 1e-4});
  const std::vector<double> scalars = test::smoothField(mesh.points);
  const Medium medium{mesh.points, mesh.tetrahedra, faces, scalars, false, curve};
  const MeshTracer tracer(medium);
  const PointCells around(mesh.points.size(), mesh.tetrahedra);
  const Light light{Light::Kind::directional, {0.3, 1, 0.5}};
  nlohmann::ordered_json json{{"mesh", options.mesh},
                              {"points", mesh.points.size()},
                              {"tetrahedra", mesh.tetrahedra.size()},
                              {"knots", curve.knots.size()},
                              {"repeat", options.repeat}};
  for (const std::size_t threads : options.threads) {
    const ThreadLimit limit(threads);
    auto& stages = json["threads"][std::to_string(threads)];
    const auto stage = [&](const char* name, const std::function<void()>& work) {
      stages[name] = timed(options.repeat, work);
    };
    stage("cells around points", [&] { PointCells(mesh.points.size(), mesh.tetrahedra); });
    stage("gradients", [&] { pointGradients(mesh.points, mesh.tetrahedra, around, scalars, false); });
    stage("tracer", [&] { MeshTracer{medium}; });
    stage("shadow, directional", [&] { shadows(tracer, light); });
    stage("shadow, point light", [&] { shadows(tracer, {Light::Kind::point, {0.5, 2, 0.7}}); });
    stage("ambient occlusion, 64 directions, R 0.1", [&] { ambientOcclusion(tracer); });
    stage("the same and optical radii", [&] { ballValues(tracer); });
    stage("scattering table", [&] { ScatteringTable({options.g, 32768, 1}); });
    const ScatteringTable table({options.g, 32768, 1});
    stage("sum for one albedo", [&] { ScatteredLight(table, 0.9); });
    const ScatteredLight scattered(table, 0.9);
    const std::vector<Light> lights{light};
    const ScatteringData data = scatteringData(tracer, ballValues(tracer).opticalRadius, 0.1, lights);
    stage("scattered light, one view", [&] {
      ambientScattering(data, lights, scattered, mesh.points, {false, {1, 2, 3}});
    });
  }
  json["gradient_errors"] = gradientErrors(mesh, around);
  for (const double albedo : {0.9, 1.0})
    for (const double tau : {0.1, 1.0, 4.0, 12.0})
      json["scattering_relative_error"].push_back(
          {{"albedo", albedo}, {"tau", tau}, {"rms", relativeError(options, albedo, tau)}});
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What the data of lighting cost; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--tf", options.transferFunction, "transfer function")->capture_default_str();
  app.add_option("--threads", options.threads, "numbers of threads")->capture_default_str();
  app.add_option("--g", options.g, "asymmetry of scattering")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted runs")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_light: " << error.what() << '\n';
    return error.exitStatus();
  }
}
