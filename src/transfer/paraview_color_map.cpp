#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <vector>

#include "core/error.h"
#include "transfer/color_space.h"
#include "transfer/interpolate.h"
#include "transfer/json_text.h"
#include "transfer/transfer_files.h"

namespace havs {
namespace {

using Json = nlohmann::json;

/// A node of ParaView's opacity function: towards the next, half the way in value is done at `midpoint`, in a step for
/// sharpness 1.
struct OpacityNode {
  double scalar = 0;
  double opacity = 0;
  double midpoint = 0.5;
  double sharpness = 0;
};

struct ColorMap {
  std::string name;
  std::string space = "RGB";
  std::vector<ControlPoint> colors;  // opacities not used
  std::vector<OpacityNode> opacities;
};

using Line = std::vector<ControlPoint>;

template <class Node>
void sortByScalar(std::vector<Node>& nodes) {
  std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.scalar < b.scalar; });
}

/// Share of the way in value, the fraction t of the way in scalar: VTK's piecewise function, a Hermite curve bent by
/// midpoint and sharpness.
double bend(const OpacityNode& node, double t) {
  double s = t < node.midpoint ? 0.5 * t / node.midpoint : 0.5 + 0.5 * (t - node.midpoint) / (1 - node.midpoint);
  const double power = 1 + 10 * node.sharpness;
  s = s < 0.5 ? 0.5 * std::pow(2 * s, power) : 1 - 0.5 * std::pow(2 * (1 - s), power);
  const double smooth = s * s * (3 - 2 * s);
  return std::clamp(smooth + (1 - node.sharpness) * (s - smooth), 0.0, 1.0);
}

Line opacityLine(const std::vector<OpacityNode>& nodes) {
  constexpr int kPieces = 64;
  Line line;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const OpacityNode& a = nodes[i];
    line.push_back({a.scalar, {}, a.opacity});
    if (i + 1 == nodes.size() || nodes[i + 1].scalar == a.scalar) continue;
    const OpacityNode& b = nodes[i + 1];
    const double middle = std::lerp(a.scalar, b.scalar, a.midpoint);
    if (a.sharpness > 0.99) {
      line.push_back({middle, {}, a.opacity});
      line.push_back({middle, {}, b.opacity});
    } else if (a.sharpness < 0.01) {
      if (a.midpoint != 0.5) line.push_back({middle, {}, std::midpoint(a.opacity, b.opacity)});
    } else {
      for (int k = 1; k < kPieces; ++k) {
        const double t = static_cast<double>(k) / kPieces;
        line.push_back({std::lerp(a.scalar, b.scalar, t), {}, std::lerp(a.opacity, b.opacity, bend(a, t))});
      }
    }
  }
  return line;
}

/// The line's value just below or just above a scalar.
ControlPoint besides(const Line& line, double scalar, bool above) {
  const auto next = above ? std::upper_bound(line.begin(), line.end(), scalar,
                                             [](double x, const ControlPoint& p) { return x < p.scalar; })
                          : std::lower_bound(line.begin(), line.end(), scalar,
                                             [](const ControlPoint& p, double x) { return p.scalar < x; });
  if (next == line.begin()) return line.front();
  const ControlPoint& last = *std::prev(next);
  if (next == line.end()) return last;
  const Shares shares = Shares::ofData(last.scalar, next->scalar, scalar);
  return {scalar, shares.mix(last.color, next->color), shares.mix(last.opacity, next->opacity)};
}

/// Colours of one line and opacities of the other, with all knots and steps of both.
Line merge(const Line& colors, const Line& opacities) {
  std::vector<double> scalars;
  for (const Line* line : {&colors, &opacities}) {
    for (const ControlPoint& p : *line) scalars.push_back(p.scalar);
  }
  std::sort(scalars.begin(), scalars.end());
  scalars.erase(std::unique(scalars.begin(), scalars.end()), scalars.end());
  Line merged;
  for (double s : scalars) {
    const ControlPoint below{s, besides(colors, s, false).color, besides(opacities, s, false).opacity};
    const ControlPoint above{s, besides(colors, s, true).color, besides(opacities, s, true).opacity};
    merged.push_back(below);
    if (above.color != below.color || above.opacity != below.opacity) merged.push_back(above);
  }
  return merged;
}

/// Stretches scalars to [0, 1], as ParaView does when it applies a preset to data.
void normalise(Line& line, const std::string& file) {
  const double low = line.front().scalar;
  const double high = line.back().scalar;
  if (!(low < high)) failInput("all points of the colour map lie at one scalar", file);
  for (ControlPoint& p : line) p.scalar = Shares::ofData(low, high, p.scalar).upper;
}

TransferFunction transferFunction(ColorMap map, const std::string& file) {
  const auto space = colorSpaceNamed(map.space);
  if (!space)
    failInput(fmt::format("colour space '{}' is not known", map.space), file,
              "known: RGB, HSV, HSVNoWrap, Lab, Diverging, Step");
  if (map.colors.empty())
    failInput("the colour map has no colours", file, "maps of IndexedColors (categories) cannot be used");
  for (std::size_t i = 0; i < map.colors.size(); ++i) {
    if (!std::isfinite(map.colors[i].scalar))
      failInput("a scalar is not finite", fmt::format("{}, point {}", file, i + 1));
  }
  for (std::size_t i = 0; i < map.opacities.size(); ++i) {
    const OpacityNode& n = map.opacities[i];
    if (!(std::isfinite(n.scalar) && n.midpoint >= 0 && n.midpoint <= 1 && n.sharpness >= 0 && n.sharpness <= 1)) {
      failInput("opacity point out of range", fmt::format("{}, opacity point {}", file, i + 1),
                "midpoint and sharpness lie in [0, 1]");
    }
  }
  sortByScalar(map.colors);
  if (map.opacities.empty()) map.opacities = {{map.colors.front().scalar, 0}, {map.colors.back().scalar, 1}};
  sortByScalar(map.opacities);

  TransferFunction function;
  function.name = map.name;
  function.meaning = OpacityMeaning::extinction;
  function.points = merge(resampleToRgb(*space, map.colors), opacityLine(map.opacities));
  normalise(function.points, file);
  checkTransferFunction(function, file);
  return function;
}

void checkOneMap(std::size_t count, const std::string& file) {
  if (count != 1) failInput(fmt::format("holds {} colour maps", count), file, "keep the one to use");
}

/// The numbers of a flat list, `width` to an entry.
std::vector<double> numbers(const Json& map, const char* key, std::size_t width, const std::string& file) {
  if (!map.contains(key)) return {};
  const Json& list = map[key];
  if (!list.is_array() || list.size() % width != 0)
    failInput(fmt::format("'{}' is no list of {} numbers a point", key, width), file);
  std::vector<double> values;
  for (const Json& value : list) {
    if (!value.is_number())
      failInput(fmt::format("'{}' holds '{}', no number", key, quoted(value)),
                fmt::format("{}, point {}", file, values.size() / width + 1));
    values.push_back(value.get<double>());
  }
  return values;
}

double attribute(const pugi::xml_node& node, const char* name, const std::string& where) {
  const char* text = node.attribute(name).value();
  double value = 0;
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), value);
  if (error != std::errc{} || *end != '\0') failInput(fmt::format("'{}' is '{}', no number", name, text), where);
  return value;
}

}  // namespace

bool isParaViewJson(std::string_view text, const std::string& file) {
  const Json json = parseJson<Json>(text, file);
  return json.is_array() || (json.is_object() && (json.contains("RGBPoints") || json.contains("ColorSpace") ||
                                                  json.contains("IndexedColors")));
}

TransferFunction readParaViewJson(std::string_view text, const std::string& file) {
  const Json list = parseJson<Json>(text, file);
  if (list.is_array()) checkOneMap(list.size(), file);
  const Json& json = list.is_array() ? list[0] : list;
  if (!json.is_object()) failInput("a colour map is a JSON object", file);
  ColorMap map;
  if (json.contains("Name") && json["Name"].is_string()) map.name = json["Name"].get<std::string>();
  if (json.contains("ColorSpace"))
    map.space = json["ColorSpace"].is_string() ? json["ColorSpace"].get<std::string>() : quoted(json["ColorSpace"]);
  const std::vector<double> rgb = numbers(json, "RGBPoints", 4, file);
  for (std::size_t i = 0; i < rgb.size(); i += 4)
    map.colors.push_back({rgb[i], {rgb[i + 1], rgb[i + 2], rgb[i + 3]}, 0});
  const std::vector<double> points = numbers(json, "Points", 4, file);
  for (std::size_t i = 0; i < points.size(); i += 4)
    map.opacities.push_back({points[i], points[i + 1], points[i + 2], points[i + 3]});
  return transferFunction(std::move(map), file);
}

TransferFunction readParaViewXml(std::string_view text, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) failInput(result.description(), fmt::format("{}, byte {}", file, result.offset), "it is no valid XML");
  const auto maps = document.select_nodes("/ColorMaps/ColorMap | /ColorMap");
  if (maps.empty()) failInput("has no <ColorMap>", file, "only ParaView's colour maps are read from XML");
  checkOneMap(maps.size(), file);
  const pugi::xml_node node = maps.begin()->node();

  ColorMap map;
  map.name = node.attribute("name").value();
  map.space = node.attribute("space").as_string("RGB");
  for (const pugi::xml_node& point : node.children("Point")) {
    const std::string where = fmt::format("{}, point {}", file, map.colors.size() + 1);
    const double x = attribute(point, "x", where);
    map.colors.push_back(
        {x, {attribute(point, "r", where), attribute(point, "g", where), attribute(point, "b", where)}, 0});
    if (point.attribute("o")) map.opacities.push_back({x, attribute(point, "o", where)});
  }
  // ParaView writes opacity 1 throughout where a map holds colours alone.
  if (std::all_of(map.opacities.begin(), map.opacities.end(), [](const OpacityNode& n) { return n.opacity == 1; }))
    map.opacities.clear();
  return transferFunction(std::move(map), file);
}

}  // namespace havs
