#include "render/lookups.h"

#include <glad/gl.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/find_row.h"
#include "render/lookup_resources.h"

namespace havs {
namespace {

constexpr int kMostSamples = 256;
constexpr const char* kNumberMark = ":n";

std::string withoutMark(const std::string& name) {
  return name.ends_with(kNumberMark) ? name.substr(0, name.size() - std::string_view(kNumberMark).size()) : name;
}

int readNumber(const Lookup& row, const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc::result_out_of_range ||
      (error == std::errc{} && last == end && (number < 1 || number > kMostSamples)))
    failInput("lookup '" + withoutMark(row.name) + "' cannot take " + text + " " + row.parameter, "",
              "give a number from 1 to " + std::to_string(kMostSamples));
  if (error != std::errc{} || last != end)
    failInput("lookup '" + withoutMark(row.name) + "' needs a number of " + row.parameter, "",
              "write " + exampleName(row) + ", for example");
  return number;
}

/// To the nearest half float, of a value in [0, 1]. (llvmpipe cuts off what does not fit, docs/llvmpipe.md.)
float roundedToHalf(float value) {
  constexpr float kSmallestNormal = 0x1p-14F, kSmallestStep = 0x1p-24F;
  if (value < kSmallestNormal) return std::nearbyint(value / kSmallestStep) * kSmallestStep;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>((bits + 0xFFF + (bits >> 13 & 1)) & ~std::uint32_t{0x1FFF});
}

/// To the nearest of the numbers 0, 1 / most, ... 1.
template <int most>
float roundedToPart(float value) {
  return static_cast<float>(std::nearbyint(static_cast<double>(value) * most) / most);
}

}  // namespace

std::string exampleName(const Lookup& row) { return withoutMark(row.name) + (row.parameter.empty() ? "" : ":8"); }

std::span<const LookupResource> lookupResources() {
  static const std::vector<LookupResource> rows{
      {.name = "curve", .description = "the transfer function, piece by piece", .make = makeCurve},
      {.name = "few pieces", .description = "extinction where few pieces make it up", .make = makeFewPieces},
      {.name = "integrals",
       .description = "integrals of extinction and light up to each knot of the transfer function",
       .make = makeIntegrals},
      {.name = "opaque intervals", .description = "scalars of opacity 1", .make = makeOpaqueIntervals},
      {.name = "isosurfaces",
       .description = "values, colours and opacities of the isosurfaces",
       .make = makeIsosurfaces},
      {.name = "2d table",
       .description = "mean colour and extinction over front and back scalar, at the mean length",
       .axes = 2,
       .largestSize = 2048,
       .ownSize = 512,
       .make = makeTable2d},
      {.name = "3d table",
       .description = "colour and opacity over front scalar, back scalar and length",
       .axes = 3,
       .largestSize = 512,
       .ownSize = 128,
       .make = makeTable3d},
      {.name = "3d mean colours",
       .description = "mean colour over front scalar, back scalar and length, 2N x 2N x N/4 entries",
       .axes = 3,
       .largestSize = 512,
       .ownSize = 64,
       .make = makeMeanColorTable},
  };
  return rows;
}

std::span<const Lookup> lookups() {
  static const std::vector<Lookup> rows{
      {.name = "3d",
       .description = "pre-integrated table over front scalar, back scalar and length (the paper's)",
       .shader = "lookup/table_3d.glsl",
       .resources = {"3d table"}},
      {.name = "3d-normalised",
       .description = "mean colours over the same in a table of 2N x 2N x N/4; opacity by the integral of extinction",
       .shader = "lookup/normalised_3d.glsl",
       .resources = {"3d mean colours", "curve", "integrals"}},
      {.name = "2d",
       .description = "table over front and back scalar at one length, opacity corrected to the segment's",
       .shader = "lookup/table_2d.glsl",
       .resources = {"2d table"}},
      {.name = "integral",
       .description = "integrals of extinction and light; attenuation inside the segment ignored in its light",
       .shader = "lookup/integral.glsl",
       .resources = {"curve", "integrals"}},
      {.name = "exact",
       .description = "no table: cut at the transfer function's knots, each piece integrated exactly",
       .shader = "lookup/exact.glsl",
       .resources = {"curve"}},
      {.name = "post",
       .description = "transfer function at both ends, trapezoid between them (post-classification)",
       .shader = "lookup/post.glsl",
       .resources = {"curve"}},
      {.name = "riemann:n",
       .description = "transfer function at n samples a segment, opacity 1 - exp(-kappa h)",
       .shader = "lookup/riemann.glsl",
       .resources = {"curve"},
       .parameter = "samples a segment"},
      {.name = "riemann-linear:n",
       .description = "the same with opacity kappa h, at most 1",
       .shader = "lookup/riemann_linear.glsl",
       .resources = {"curve"},
       .parameter = "samples a segment"},
      {.name = "pre",
       .description = "colour and extinction at the vertices, linear between them (projected tetrahedra)",
       .shader = "lookup/pre.glsl",
       .carries = Payload::color},
  };
  return rows;
}

std::span<const TableFormat> tableFormats() {
  static const std::vector<TableFormat> rows{
      {.name = "rgba32f", .description = "32-bit float", .bytesPerEntry = 16, .internalFormat = GL_RGBA32F},
      {.name = "rgba16f",
       .description = "16-bit float",
       .bytesPerEntry = 8,
       .internalFormat = GL_RGBA16F,
       .rounded = roundedToHalf},
      {.name = "rgba16",
       .description = "16 bits a channel, from 0 to 1",
       .bytesPerEntry = 8,
       .internalFormat = GL_RGBA16,
       .rounded = roundedToPart<65535>},
      {.name = "rgba8",
       .description = "8 bits a channel (the paper's), filtered in the shader",
       .bytesPerEntry = 4,
       .internalFormat = GL_RGBA8,
       .filteredInShader = true,
       .rounded = roundedToPart<255>},
  };
  return rows;
}

const LookupResource& lookupResource(const std::string& name) {
  const auto rows = lookupResources();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
  if (found == rows.end()) failRunning("a row of lookups() names '" + name + "', which lookupResources() lacks");
  return *found;
}

Lookup lookup(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string plain = name.substr(0, colon);
  const auto rows = lookups();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Lookup& row) { return withoutMark(row.name) == plain; });
  if (found == rows.end()) return findRow(rows, name, "lookup");  // throws
  Lookup chosen = *found;
  if (!chosen.parameter.empty())
    chosen.number = readNumber(chosen, colon == std::string::npos ? "" : name.substr(colon + 1));
  else if (colon != std::string::npos)
    failInput("lookup '" + plain + "' takes no number", "", "write " + plain);
  chosen.name = name;
  return chosen;
}

const LookupResource* tableOf(const Lookup& lookup) {
  for (const std::string& name : lookup.resources)
    if (const LookupResource& resource = lookupResource(name); resource.axes > 0) return &resource;
  return nullptr;
}

const TableFormat& tableFormat(const std::string& name) { return findRow(tableFormats(), name, "table format"); }

}  // namespace havs
