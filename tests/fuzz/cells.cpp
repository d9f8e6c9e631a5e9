// Cells of any type on their way to tetrahedra, as a broken file hands them over: mixed, out of range, polyhedra with
// any face stream. Each byte of the input is a small number: points, fields, then cells (type, length, numbers).
#include "mesh/cells.h"

#include "fuzz/fuzz.h"

namespace {

/// Takes the input byte by byte; zeros behind its end.
struct Bytes {
  const std::uint8_t* at;
  std::size_t left;
  int take() {
    if (left == 0) return 0;
    --left;
    return *at++;
  }
};

havs::CellSoup soupOf(Bytes bytes) {
  havs::CellSoup soup;
  const int points = bytes.take() % 32;
  for (int i = 0; i < points; ++i) {
    const double x = bytes.take(), y = bytes.take();
    soup.points.emplace_back(x, y, bytes.take());
  }
  const int components = bytes.take() % 4;
  soup.pointFields.push_back({"p", components, std::vector<double>(static_cast<std::size_t>(components * points), 1)});
  soup.offsets.push_back(0);
  while (bytes.left > 0) {
    soup.types.push_back(static_cast<std::uint8_t>(bytes.take()));
    for (int n = bytes.take() % 64; n > 0; --n) soup.connectivity.push_back(bytes.take() - 1);
    // Now and then one that does not follow.
    const int jump = bytes.take() % 16 == 15 ? bytes.take() - 128 : 0;
    soup.offsets.push_back(static_cast<std::int64_t>(soup.connectivity.size()) + jump);
  }
  soup.cellFields.push_back({"c", 1, std::vector<double>(soup.types.size(), 2)});
  return soup;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace havs;
  fuzz::readOrRefuse([&] { fuzz::requireSound(cutIntoTetrahedra(soupOf({data, size}), "cells")); });
  return 0;
}
