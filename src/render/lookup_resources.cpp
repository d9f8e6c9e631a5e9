#include "render/lookup_resources.h"

#include <algorithm>

#include "core/parallel.h"
#include "transfer/few_pieces.h"
#include "transfer/mean_tables.h"
#include "transfer/packed_curve.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

/// The greatest scalar that a fragment carries at the mesh's boundary (kBelowOne of shaders/payload.glsl): a surface
/// above it would be met by every ray that leaves there.
constexpr float kBelowOne = 0x1.fffffep-1f;
/// What OpenGL's interpolation may be off by where the three corners of a face have one scalar. Surfaces lie so much
/// lower there: else a ray in a region of one value would waver about a surface of that value.
constexpr float kGlRounding = 0x1p-22f;

/// Texels of four numbers, read by their number.
ResourceTable texels(const std::vector<std::array<float, 4>>& list) {
  ResourceTable table{{static_cast<int>(list.size())}, 4, {}};
  table.values.reserve(4 * list.size());
  for (const auto& texel : list) table.values.insert(table.values.end(), texel.begin(), texel.end());
  return table;
}

/// Numbers, read by their number.
ResourceTable numbers(std::vector<float> list) {
  const int count = static_cast<int>(list.size());
  return {{count}, 1, std::move(list)};
}

/// A table to be filtered, its numbers as the plan's format holds them.
ResourceTable filtered(std::vector<int> sizes, std::vector<float> rgba, const TableFormat& format) {
  if (format.rounded) parallelFor(0, rgba.size(), 1 << 16, [&](std::size_t i) { rgba[i] = format.rounded(rgba[i]); });
  return {std::move(sizes), 4, std::move(rgba)};
}

ResourceData table3d(Table3d table, const TableFormat& format) {
  ResourceData made;
  made.tables["table3d"] = filtered({table.size, table.size, table.lengths}, std::move(table.rgba), format);
  made.numbers["lengthScale"] = static_cast<float>(1.0 / table.maximumLength);
  return made;
}

/// Of the knots of [low, high], of which there are, the first of the greatest extinction.
const ExtinctionCurve::Knot& densestBetween(const ExtinctionCurve& curve, double low, double high) {
  const ExtinctionCurve::Knot* densest = nullptr;
  for (const ExtinctionCurve::Knot& k : curve.knots)
    if (k.s >= low && k.s <= high && (densest == nullptr || k.kappa > densest->kappa)) densest = &k;
  return *densest;
}

}  // namespace

std::vector<ResourceData> makeResources(const PreparedScene& prepared, const RenderPlan& plan,
                                        const Progress& progress) {
  const ExtinctionCurve seen = withoutOpaque(prepared.curve);
  std::vector<ResourceData> made;
  for (const LookupResource& resource : plan.resources) made.push_back(resource.make({prepared, seen, plan, progress}));
  return made;
}

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

ResourceData makeCurve(const ResourceInput& input) {
  const PackedCurve<float> packed = packCurve<float>(withSurfaceColors(input.prepared.curve));
  ResourceData made;
  made.tables["curvePieces"] = texels(packed.pieces);
  made.tables["curveGuide"] = numbers(packed.guide);
  made.numbers["guideCells"] = static_cast<float>(packed.guide.size());
  return made;
}

ResourceData makeFewPieces(const ResourceInput& input) {
  const FewPieces pieces = fewPieces(withSurfaceColors(input.prepared.curve));
  ResourceData made;
  made.rows["pieceEnds"].assign(pieces.ends.begin(), pieces.ends.end());
  made.rows["pieceAtZero"].assign(pieces.atZero.begin(), pieces.atZero.end());
  made.rows["pieceHalfSlope"].assign(pieces.halfSlope.begin(), pieces.halfSlope.end());
  return made;
}

ResourceData makeIntegrals(const ResourceInput& input) {
  ResourceData made;
  made.tables["curveIntegrals"] = texels(packCurve<float>(withSurfaceColors(input.prepared.curve)).integrals);
  return made;
}

ResourceData makeOpaqueIntervals(const ResourceInput& input) {
  const auto& opaque = input.prepared.curve.opaque;
  std::vector<float> endsAndColors;
  for (const auto& [low, high] : opaque) {
    const auto add = [&](double number) { endsAndColors.push_back(static_cast<float>(number)); };
    add(low);
    add(high);
    for (const double channel : densestBetween(input.prepared.curve, low, high).color) add(channel);
  }
  ResourceData made;
  made.tables["opaqueIntervals"] = numbers(std::move(endsAndColors));
  made.numbers["opaqueCount"] = static_cast<float>(opaque.size());
  return made;
}

ResourceData makeIsosurfaces(const ResourceInput& input) {
  std::vector<float> values;
  std::vector<std::array<float, 4>> colors;
  for (const auto& [value, scalar, color, opacity] : input.prepared.isosurfaces) {
    const float lowered = input.plan.native ? 0 : kGlRounding;
    values.push_back(std::min(static_cast<float>(scalar), kBelowOne) - lowered);
    colors.push_back({static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]),
                      static_cast<float>(opacity)});
  }
  ResourceData made;
  made.numbers["isosurfaceCount"] = static_cast<float>(values.size());
  made.tables["isosurfaceValues"] = numbers(std::move(values));
  made.tables["isosurfaceColors"] = texels(colors);
  return made;
}

ResourceData makeTable2d(const ResourceInput& input) {
  MeanTable2d table = buildMeanTable2d(input.seen, input.plan.tableSize, meanSegmentLength(input.prepared));
  // Extinction is scaled to [0, 1], for formats that hold no more.
  const float most = static_cast<float>(input.seen.maximumKappa);
  for (std::size_t i = 3; most > 0 && i < table.rgba.size(); i += 4) table.rgba[i] /= most;
  ResourceData made;
  made.tables["table2d"] = filtered({table.size, table.size}, std::move(table.rgba), input.plan.tableFormat);
  made.numbers["mostExtinction"] = most;
  return made;
}

ResourceData makeTable3d(const ResourceInput& input) {
  return table3d(buildTable3d(input.seen, input.plan.tableSize, input.prepared.longestEdge, input.progress),
                 input.plan.tableFormat);
}

ResourceData makeMeanColorTable(const ResourceInput& input) {
  return table3d(buildMeanColors(input.seen, input.plan.tableSize, input.prepared.longestEdge, input.progress),
                 input.plan.tableFormat);
}

}  // namespace havs
