#include "study/fingerprint.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <span>

#include "core/error.h"

namespace havs {
namespace {

class Fnv1a {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* const from = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) hash_ = (hash_ ^ from[i]) * 0x100000001b3u;
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.data(), values.size() * sizeof(T));
  }
  std::string digits() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::string fingerprintOf(const PreparedScene& prepared) {
  Fnv1a hash;
  hash.add(prepared.points);
  hash.add(prepared.mesh.tetrahedra);
  hash.add(prepared.scalars);
  hash.add(prepared.curve.knots);
  hash.add(prepared.curve.opaque);
  hash.add(prepared.isosurfaces);
  return hash.digits();
}

std::string fingerprintOf(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) failInput("no such file", file.string());
  if (std::filesystem::is_directory(file, error)) failInput("is a directory, not a mesh", file.string());
  std::ifstream stream(file, std::ios::binary);
  Fnv1a hash;
  std::array<char, 65536> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
    hash.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  if (!stream.eof()) failInput("cannot be read", file.string());
  return hash.digits();
}

}  // namespace havs
