#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/output_file.h"
#include "mesh/formats.h"

namespace havs {
namespace {

using Text = fmt::memory_buffer;

template <class... Values>
void print(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

/// Numbers from 1, as TetGen does; {} writes the shortest text that reads back as the same double.
Text nodeText(const TetMesh& mesh) {
  Text text;
  std::size_t attributes = 0;
  for (const Field& field : mesh.pointFields) attributes += static_cast<std::size_t>(field.components);
  print(text, "{} 3 {} 0\n", mesh.points.size(), attributes);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    print(text, "{} {} {} {}", i + 1, mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    for (const Field& field : mesh.pointFields) {
      const auto n = static_cast<std::size_t>(field.components);
      for (std::size_t c = 0; c < n; ++c) print(text, " {}", field.values[i * n + c]);
    }
    text.push_back('\n');
  }
  return text;
}

Text eleText(const TetMesh& mesh) {
  Text text;
  const auto region = std::find_if(mesh.cellFields.begin(), mesh.cellFields.end(),
                                   [](const Field& field) { return field.components == 1; });
  const bool hasRegion = region != mesh.cellFields.end();
  print(text, "{} 4 {}\n", mesh.tetrahedra.size(), hasRegion ? 1 : 0);
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    const Tetrahedron& t = mesh.tetrahedra[i];
    print(text, "{} {} {} {} {}", i + 1, t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
    if (hasRegion) print(text, " {}", region->values[i]);
    text.push_back('\n');
  }
  return text;
}

void writeText(OutputFile& file, const Text& text) { file.write(std::as_bytes(std::span(text.data(), text.size()))); }

}  // namespace

void writeNodeEle(const TetMesh& mesh, const std::filesystem::path& file) {
  std::filesystem::path node = file, ele = file;
  OutputFile nodeFile(node.replace_extension(".node"));
  OutputFile eleFile(ele.replace_extension(".ele"));
  writeText(nodeFile, nodeText(mesh));
  writeText(eleFile, eleText(mesh));
  nodeFile.commit();
  eleFile.commit();
}

}  // namespace havs
