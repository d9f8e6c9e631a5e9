#include "fuzz/fuzz.h"

#include <fstream>
#include <stdexcept>

#include "core/memory_budget.h"
#include "support/temporary_folder.h"

namespace havs::fuzz {
namespace {

void requireSound(const std::vector<Field>& fields, std::size_t tuples) {
  for (const Field& field : fields) {
    require(field.components >= 1, "a field has components");
    require(field.values.size() == tuples * static_cast<std::size_t>(field.components), "a field has all its values");
  }
}

}  // namespace

std::filesystem::path asFile(const std::string& name, std::string_view bytes) {
  static const test::TemporaryFolder folder;
  static const bool limited = (limitMemory(kMemoryLimit), true);
  static_cast<void>(limited);
  const std::filesystem::path file = folder / name;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

void requireSound(const TetMesh& mesh) {
  for (const Tetrahedron& tetrahedron : mesh.tetrahedra)
    for (const Index point : tetrahedron) require(point < mesh.points.size(), "a tetrahedron's points exist");
  requireSound(mesh.pointFields, mesh.points.size());
  requireSound(mesh.cellFields, mesh.tetrahedra.size());
}

void requireSound(const Image& image) {
  require(image.width > 0 && image.height > 0, "a picture has pixels");
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  require(image.rgba.size() == 4 * pixels, "a picture has all its pixels");
}

}  // namespace havs::fuzz
