#include "render/gl/lookup_textures.h"

#include <array>
#include <vector>

#include "core/error.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

constexpr GLuint kTableUnit = 0, kCurveUnit = 1, kOpaqueUnit = 2;
/// Samples of the transfer function along the scalar. A step is smeared over one of them.
constexpr int kCurveSamples = 4096;

/// Scale and bias that put 0 on the middle of the first of `size` texels and 1 on the middle of the last.
glm::vec2 halfTexel(int size) { return {static_cast<float>((size - 1.0) / size), static_cast<float>(0.5 / size)}; }

}  // namespace

LookupTextures::LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress) {
  const ExtinctionCurve seen = withoutOpaque(prepared.curve);
  if (plan.lookup.table == LookupTable::table3d) makeTable(seen, prepared.longestEdge, plan, progress);
  if (plan.needsCurveTexture) makeCurve(prepared.curve, seen);
  if (!prepared.curve.opaque.empty()) makeOpaque(prepared.curve);
}

void LookupTextures::makeTable(const ExtinctionCurve& seen, double longestEdge, const RenderPlan& plan,
                               const Progress& progress) {
  const Table3d table = buildTable3d(seen, plan.tableSize, longestEdge, progress);
  lengthScale_ = static_cast<float>(1.0 / table.maximumLength);
  const bool eightBits = plan.tableFormat.eightBits;
  table_ =
      Texture::image3D("pre-integrated table", eightBits ? GL_RGBA8 : GL_RGBA32F, table.size, table.size, table.size);
  if (eightBits) {
    table_->upload(GL_RGBA, std::span<const std::uint8_t>(toRgba8(table)));
  } else {
    table_->upload(GL_RGBA, std::span<const float>(table.rgba));
    table_->filter(GL_LINEAR);
  }
}

void LookupTextures::makeCurve(const ExtinctionCurve& curve, const ExtinctionCurve& seen) {
  std::vector<float> texels;
  texels.reserve(4 * kCurveSamples);
  for (int i = 0; i < kCurveSamples; ++i) {
    const double s = static_cast<double>(i) / (kCurveSamples - 1);
    for (const double channel : curve.at(s).color) texels.push_back(static_cast<float>(channel));
    texels.push_back(static_cast<float>(seen.at(s).kappa));
  }
  curve_ = Texture::image2D("transfer function", GL_RGBA32F, kCurveSamples, 1);
  curve_->upload(GL_RGBA, std::span<const float>(texels));
  curve_->filter(GL_LINEAR);
}

void LookupTextures::makeOpaque(const ExtinctionCurve& curve) {
  std::vector<float> texels;
  for (const auto& [low, high] : curve.opaque) {
    texels.push_back(static_cast<float>(low));
    texels.push_back(static_cast<float>(high));
  }
  opaque_ = Texture::image2D("opaque intervals", GL_RG32F, static_cast<int>(curve.opaque.size()), 1);
  opaque_->upload(GL_RG, std::span<const float>(texels));
}

void LookupTextures::bind(const Program& program) const {
  if (table_) {
    table_->bind(kTableUnit);
    program.set("preintegrated", static_cast<int>(kTableUnit));
    program.set("tableScaleBias", halfTexel(table_->width()));
    program.set("lengthScale", lengthScale_);
  }
  if (curve_) {
    curve_->bind(kCurveUnit);
    program.set("curve", static_cast<int>(kCurveUnit));
    program.set("curveScaleBias", halfTexel(kCurveSamples));
  }
  if (opaque_) {
    opaque_->bind(kOpaqueUnit);
    program.set("opaqueIntervals", static_cast<int>(kOpaqueUnit));
    program.set("opaqueCount", opaque_->width());
  }
}

}  // namespace havs
