#include "render/gl/lookup_resources.h"

#include "core/parallel.h"
#include "transfer/mean_tables.h"
#include "transfer/packed_curve.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

/// Scale and bias that put 0 on the middle of the first texel of each axis and 1 on the middle of the last.
void addHalfTexel(ResourceTextures& made, const Texture& table) {
  const glm::vec3 size(table.width(), table.height(), table.depth());
  made.uniforms["tableScale"] = (size - 1.0f) / size;
  made.uniforms["tableBias"] = 0.5f / size;
}

void addBufferTexture(ResourceTextures& made, const std::string& name, GLenum format, Buffer buffer) {
  made.buffers.push_back(std::move(buffer));
  made.samplers.emplace(name, Texture::overBuffer(name, format, made.buffers.back()));
}

/// Adds a table under the name of its sampler.
void addTable(ResourceTextures& made, const char* name, Texture texture, const TableFormat& format,
              std::vector<float> rgba) {
  if (format.rounded) parallelFor(0, rgba.size(), 1 << 16, [&](std::size_t i) { rgba[i] = format.rounded(rgba[i]); });
  texture.upload(GL_RGBA, std::span<const float>(rgba));
  if (!format.filteredInShader) texture.filter(GL_LINEAR);
  addHalfTexel(made, texture);
  made.samplers.emplace(name, std::move(texture));
}

ResourceTextures table3dTextures(Table3d table, const TableFormat& format) {
  ResourceTextures made;
  addTable(made, "table3d",
           Texture::image3D("table over front, back and length", format.internalFormat, table.size, table.size,
                            table.lengths),
           format, std::move(table.rgba));
  made.uniforms["lengthScale"] = static_cast<float>(1.0 / table.maximumLength);
  return made;
}

}  // namespace

double meanSegmentLength(const PreparedScene& prepared) {
  double volumes = 0, surfaces = 0;
  for (const Tetrahedron& cell : prepared.mesh.tetrahedra) {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = prepared.points[cell[i]];
    volumes += std::abs(dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6;
    for (std::size_t i = 0; i < 4; ++i) surfaces += length(cross(p[(i + 1) % 4] - p[i], p[(i + 2) % 4] - p[i])) / 2;
  }
  const double mean = 4 * volumes / surfaces;
  return mean > 0 ? mean : prepared.longestEdge;
}

ResourceTextures makeCurveTextures(const ResourceInput& input) {
  const PackedCurve<float> packed = packCurve<float>(withSurfaceColors(input.prepared.curve));
  ResourceTextures made;
  addBufferTexture(made, "curvePieces", GL_RGBA32F, Buffer::of("pieces of the curve", packed.pieces));
  addBufferTexture(made, "curveGuide", GL_R32F, Buffer::of("guide to the pieces", packed.guide));
  made.uniforms["guideCells"] = static_cast<float>(packed.guide.size());
  return made;
}

ResourceTextures makeIntegralTextures(const ResourceInput& input) {
  ResourceTextures made;
  addBufferTexture(
      made, "curveIntegrals", GL_RGBA32F,
      Buffer::of("integrals up to the knots", packCurve<float>(withSurfaceColors(input.prepared.curve)).integrals));
  return made;
}

ResourceTextures makeOpaqueTextures(const ResourceInput& input) {
  std::vector<float> ends;
  for (const auto& [low, high] : input.prepared.curve.opaque) {
    ends.push_back(static_cast<float>(low));
    ends.push_back(static_cast<float>(high));
  }
  ResourceTextures made;
  addBufferTexture(made, "opaqueIntervals", GL_RG32F, Buffer::of("opaque intervals", ends));
  made.uniforms["opaqueCount"] = static_cast<int>(input.prepared.curve.opaque.size());
  return made;
}

ResourceTextures makeTable2dTextures(const ResourceInput& input) {
  MeanTable2d table = buildMeanTable2d(input.seen, input.plan.tableSize, meanSegmentLength(input.prepared));
  // Extinction is scaled to [0, 1], for formats that hold no more.
  const float most = static_cast<float>(input.seen.maximumKappa);
  for (std::size_t i = 3; most > 0 && i < table.rgba.size(); i += 4) table.rgba[i] /= most;
  const TableFormat& format = input.plan.tableFormat;
  ResourceTextures made;
  addTable(made, "table2d",
           Texture::image2D("table over front and back", format.internalFormat, table.size, table.size), format,
           std::move(table.rgba));
  made.uniforms["mostExtinction"] = most;
  return made;
}

ResourceTextures makeTable3dTextures(const ResourceInput& input) {
  return table3dTextures(buildTable3d(input.seen, input.plan.tableSize, input.prepared.longestEdge, input.progress),
                         input.plan.tableFormat);
}

ResourceTextures makeMeanColorTextures(const ResourceInput& input) {
  return table3dTextures(buildMeanColors(input.seen, input.plan.tableSize, input.prepared.longestEdge, input.progress),
                         input.plan.tableFormat);
}

}  // namespace havs
