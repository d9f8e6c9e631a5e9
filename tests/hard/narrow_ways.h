#pragma once
// Drawing with too few entries: k-buffers of few entries on both devices, and faces in orders of a test's own.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "hard/hard_case.h"
#include "render/devices.h"
#include "support/meshes.h"

namespace havs::test {

/// The native device and OpenGL's k-buffer, with each k.
inline std::vector<HardWay> narrowWays(const std::string& sort, const std::vector<int>& ks = {1, 2, 3}) {
  std::vector<HardWay> ways;
  for (const int k : ks) {
    const std::string setting = " k " + std::to_string(k) + " " + sort;
    ways.push_back({"native" + setting, "native", kNativeDevice, "kbuffer", sort, k});
    ways.push_back({"k-buffer" + setting, "k-buffer", "osmesa", "kbuffer", sort, k});
  }
  return ways;
}

inline TetMesh withSmoothPoints(TetMesh mesh) {
  mesh.pointFields = {Field{"s", 1, smoothField(mesh.points)}};
  return mesh;
}

/// Face order[i] becomes face i, so that the order `none` takes them in that order.
inline void renumberFaces(Faces& faces, std::span<const Index> order) {
  Faces before = faces;
  std::vector<Index> numberOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    faces.vertices[i] = before.vertices[order[i]];
    faces.cells[i] = before.cells[order[i]];
    numberOf[order[i]] = static_cast<Index>(i);
  }
  for (auto& ofCell : faces.ofCell)
    for (Index& face : ofCell) face = numberOf[face];
}

inline std::vector<Index> randomOrder(std::size_t count, std::uint32_t seed) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  std::mt19937 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

inline std::size_t latePixels(const havs::Drawing& drawing) { return drawing.certificate->pixels; }

/// Most of a(channel) - b(channel) over the pixels that the certificate does not name and `mask` leaves.
inline double mostOff(const havs::Drawing& drawing, const Image& other, const std::vector<unsigned char>& mask = {}) {
  double most = 0;
  for (std::size_t c = 0; c < other.rgba.size(); ++c) {
    if (drawing.certificate->count[c / 4] > 0 || (!mask.empty() && mask[c / 4] != 0)) continue;
    most = std::max(most, std::abs(double{drawing.image.rgba[c]} - double{other.rgba[c]}));
  }
  return most;
}

}  // namespace havs::test
