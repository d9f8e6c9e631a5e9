// What the way from a file to a picture's file costs beside drawing. Prints JSON: wall and processor milliseconds
// (medians, processes that reading starts included) of reading meshes, in turn with VTK's own reader in this process
// and with VTK's module in a child process, and of writing pictures as PNG. --make writes the encodings of .vtu that
// writers use, and .node with .ele, of one mesh.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "image/image.h"
#include "mesh/formats.h"
#include "mesh/read.h"
#include "vtk_files.h"

namespace havs {
namespace {
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> meshes, pictures;
  fs::path make;  ///< folder for the encodings of the first mesh
  int repeat = 5;
  std::size_t threads = 0;
  bool onlyOurs = false;
};

double childrensCpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double childrensPeakBytes() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

struct Way {
  std::string name;
  std::function<void()> work;
};

/// Each way once to warm up, then `repeat` times in turn.
nlohmann::ordered_json timeInTurn(const std::vector<Way>& ways, int repeat) {
  std::map<std::string, std::vector<double>> wall, cpu;
  for (int i = 0; i <= repeat; ++i)
    for (const Way& way : ways) {
      const double before = cpuSeconds() + childrensCpuSeconds();
      const auto start = std::chrono::steady_clock::now();
      way.work();
      const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
      if (i == 0) continue;
      wall[way.name].push_back(time.count());
      cpu[way.name].push_back(1e3 * (cpuSeconds() + childrensCpuSeconds() - before));
    }
  nlohmann::ordered_json json;
  for (const Way& way : ways)
    json[way.name] = {{"wall_ms", medianOf(wall[way.name])}, {"cpu_ms", medianOf(cpu[way.name])}};
  return json;
}

std::vector<Way> waysToRead(const fs::path& file, const Options& options) {
  std::vector<Way> ways{{"havs", [file] { readMesh(file); }}};
  if (file.extension() != ".vtu" || options.onlyOurs) return ways;
  ways.push_back({"vtk_module", [file] { readWithVtk(file, {}); }});
  ways.push_back({"vtk_in_process", [file] { bench::readByVtk(file); }});
  return ways;
}

nlohmann::ordered_json measureReading(const fs::path& file, const Options& options) {
  std::size_t points = 0, tetrahedra = 0;
  const double before = static_cast<double>(peakMemoryBytes());
  {
    const TetMesh mesh = readMesh(file);
    points = mesh.points.size();
    tetrahedra = mesh.tetrahedra.size();
  }
  const double own = static_cast<double>(peakMemoryBytes()), child = childrensPeakBytes();
  nlohmann::ordered_json json = {
      {"file", file.filename()}, {"bytes", fs::file_size(file)}, {"points", points}, {"tetrahedra", tetrahedra}};
  json["peak_bytes_a_tetrahedron"] = {{"before_reading", before / static_cast<double>(tetrahedra)},
                                      {"process", own / static_cast<double>(tetrahedra)},
                                      {"child", child / static_cast<double>(tetrahedra)}};
  json["read"] = timeInTurn(waysToRead(file, options), options.repeat);
  return json;
}

nlohmann::ordered_json measureWriting(const fs::path& file, const Options& options) {
  const Image image = readImage(file);
  const fs::path output = fs::temp_directory_path() / (file.stem().string() + "-bench.png");
  ImageFileOptions opaque;
  opaque.background = {{1, 1, 1}};
  ImageFileOptions transparent;
  transparent.background = std::nullopt;
  ImageFileOptions wide = opaque;
  wide.pngBits = 16;
  nlohmann::ordered_json json = {{"picture", file.filename()}, {"size", {image.width, image.height}}};
  const std::pair<const char*, ImageFileOptions> kinds[] = {{"rgb", opaque}, {"rgba", transparent}, {"rgb16", wide}};
  for (const auto& [name, kind] : kinds) {
    json[name] =
        timeInTurn({{"write", [&image, &output, &k = kind] { writeImage(image, output, k); }}}, options.repeat);
    json[name]["bytes"] = fs::file_size(output);
  }
  fs::remove(output);
  return json;
}

nlohmann::ordered_json measure(const Options& options) {
  const ThreadLimit limit(options.threads);
  nlohmann::ordered_json json = {{"threads", threadCount()}, {"repeat", options.repeat}};
  for (const fs::path& file : options.meshes) json["meshes"].push_back(measureReading(file, options));
  for (const fs::path& file : options.pictures) json["pictures"].push_back(measureWriting(file, options));
  return json;
}

void makeFiles(const Options& options) {
  const TetMesh mesh = readMesh(options.meshes.at(0));
  fs::create_directories(options.make);
  writeMesh(mesh, options.make / "cube.node");
  writeMesh(mesh, options.make / "cube.vtu");
  bench::writeEncodings(options.make / "cube.vtu", options.make);
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What reading meshes and writing pictures costs; prints JSON");
  app.add_option("meshes", options.meshes, "meshes; peak memory is that of the first");
  app.add_option("--pictures", options.pictures, "pictures (.pfm, .exr, .png) to write as PNG");
  app.add_option("--make", options.make, "write the first mesh in every encoding into this folder, and end");
  app.add_option("--repeat", options.repeat, "counted runs")->capture_default_str();
  app.add_option("--threads", options.threads, "0: all cores")->capture_default_str();
  app.add_flag("--only-ours", options.onlyOurs, "do not read with VTK in turn");
  CLI11_PARSE(app, argc, argv);
  try {
    if (!options.make.empty())
      havs::makeFiles(options);
    else
      std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_files: " << error.what() << '\n';
    return error.exitStatus();
  }
}
