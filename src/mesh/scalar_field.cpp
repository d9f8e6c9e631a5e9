#include "mesh/scalar_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/parallel.h"
#include "mesh/weld.h"

namespace havs {
namespace {

constexpr int kMagnitude = -1;

/// What a name means: a field of the mesh and one of its components, or its magnitude.
struct Choice {
  const Field* field = nullptr;
  Centering centering = Centering::point;
  int component = 0;
};

const Field* find(const std::vector<Field>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// The point field of that name, else the cell field, if the centering allows.
std::optional<Choice> findField(const TetMesh& mesh, std::string_view name, std::optional<Centering> only) {
  if (only != Centering::cell)
    if (const Field* field = find(mesh.pointFields, name)) return Choice{field, Centering::point};
  if (only != Centering::point)
    if (const Field* field = find(mesh.cellFields, name)) return Choice{field, Centering::cell};
  return std::nullopt;
}

int componentOf(const Field& field, std::string_view component, const std::string& asked) {
  if (component == "magnitude") return kMagnitude;
  int number = -1;
  if (component.size() == 1 && component[0] >= 'x' && component[0] <= 'z') {
    number = component[0] - 'x';
  } else {
    const auto [stop, error] = std::from_chars(component.data(), component.data() + component.size(), number);
    if (error != std::errc{} || stop != component.data() + component.size()) number = -1;
  }
  if (number < 0 || number >= field.components)
    failInput(fmt::format("the field '{}' has no component '{}', it has {}", field.name, component, field.components),
              fmt::format("field '{}'", asked), "x, y, z, a number from 0, or magnitude");
  return number;
}

[[noreturn]] void failUnknown(const TetMesh& mesh, const std::string& asked) {
  std::vector<std::string> names;
  for (const Field& field : mesh.pointFields) names.push_back(field.name);
  for (const Field& field : mesh.cellFields)
    names.push_back((find(mesh.pointFields, field.name) ? "cell:" : "") + field.name);
  failInput(fmt::format("there is no field '{}'", asked), "", didYouMean(asked, names));
}

Choice parsed(const TetMesh& mesh, const std::string& asked) {
  std::string_view name = asked;
  std::optional<Centering> only;
  if (auto whole = findField(mesh, name, only)) {  // a name may hold colons of its own
    whole->component = whole->field->components == 1 ? 0 : kMagnitude;
    return *whole;
  }
  if (name.starts_with("point:")) only = Centering::point;
  if (name.starts_with("cell:")) only = Centering::cell;
  if (only) name.remove_prefix(name.find(':') + 1);
  if (auto whole = findField(mesh, name, only)) {
    whole->component = whole->field->components == 1 ? 0 : kMagnitude;
    return *whole;
  }
  const std::size_t colon = name.rfind(':');
  auto choice = colon == std::string_view::npos ? std::nullopt : findField(mesh, name.substr(0, colon), only);
  if (!choice) failUnknown(mesh, asked);
  choice->component = componentOf(*choice->field, name.substr(colon + 1), asked);
  return *choice;
}

Choice chosenByDefault(const TetMesh& mesh) {
  const auto first = [](const std::vector<Field>& fields, bool scalar) -> const Field* {
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const Field& field) { return (field.components == 1) == scalar; });
    return found == fields.end() ? nullptr : &*found;
  };
  if (const Field* field = first(mesh.pointFields, true)) return {field, Centering::point, 0};
  if (const Field* field = first(mesh.pointFields, false)) return {field, Centering::point, kMagnitude};
  if (const Field* field = first(mesh.cellFields, true)) return {field, Centering::cell, 0};
  if (const Field* field = first(mesh.cellFields, false)) return {field, Centering::cell, kMagnitude};
  failInput("the mesh carries no field to draw", "", "give it one, for example from an expression in x, y and z");
}

std::vector<double> valuesOf(const Choice& choice) {
  const auto n = static_cast<std::size_t>(choice.field->components);
  const std::vector<double>& from = choice.field->values;
  if (n == 1 && choice.component == 0) return from;
  std::vector<double> values(choice.field->tuples());
  parallelFor(0, values.size(), kGrain, [&](std::size_t i) {
    if (choice.component != kMagnitude) {
      values[i] = from[i * n + static_cast<std::size_t>(choice.component)];
      return;
    }
    values[i] = magnitudeAt(*choice.field, i);
  });
  return values;
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Of all that visit(i, range) includes for i in [0, count).
template <class Visit>
Range rangeOver(std::size_t count, const Visit& visit) {
  return parallelReduce(
      0, count, kGrain, Range{},
      [&](std::size_t first, std::size_t last) {
        Range range;
        for (std::size_t i = first; i < last; ++i) visit(i, range);
        return range;
      },
      [](const Range& a, const Range& b) {
        return Range{std::min(a.low, b.low), std::max(a.high, b.high)};
      });
}

void setRange(const TetMesh& mesh, ScalarField& field) {
  const Range range = field.centering == Centering::cell
                          ? rangeOver(field.values.size(), [&](std::size_t i, Range& r) { r.include(field.values[i]); })
                          : rangeOver(mesh.tetrahedra.size(), [&](std::size_t i, Range& r) {
                              for (const Index point : mesh.tetrahedra[i]) r.include(field.values[point]);
                            });
  if (range.low > range.high)
    failInput(fmt::format("the field '{}' has no finite value", field.name), "", "choose another field");
  field.minimum = range.low;
  field.maximum = range.high;
}

}  // namespace

double magnitudeAt(const Field& field, std::size_t tuple) {
  const auto n = static_cast<std::size_t>(field.components);
  double length = 0;
  for (std::size_t c = 0; c < n; ++c) length = std::hypot(length, field.values[tuple * n + c]);
  return length;
}

ScalarField selectField(const TetMesh& mesh, const std::string& name) {
  const Choice choice = name.empty() ? chosenByDefault(mesh) : parsed(mesh, name);
  ScalarField field;
  field.name = name.empty() ? choice.field->name : name;
  const bool saysMagnitude = field.name.ends_with(":magnitude");
  if (choice.component == kMagnitude && !saysMagnitude) field.name += ":magnitude";
  field.centering = choice.centering;
  field.values = valuesOf(choice);
  setRange(mesh, field);
  return field;
}

std::size_t withoutHoles(TetMesh& mesh, ScalarField& field) {
  const std::size_t before = mesh.tetrahedra.size();
  std::vector<char> keep(before);
  parallelFor(0, before, kGrain, [&](std::size_t i) {
    const Tetrahedron& t = mesh.tetrahedra[i];
    keep[i] = field.centering == Centering::cell
                  ? std::isfinite(field.values[i])
                  : std::all_of(t.begin(), t.end(), [&](Index point) { return std::isfinite(field.values[point]); });
  });
  const auto holes = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
  if (holes == 0) return 0;
  if (holes == before)
    failInput(fmt::format("the field '{}' is finite in no cell", field.name), "", "choose another field");
  std::size_t to = 0;
  for (std::size_t i = 0; i < before; ++i)
    if (keep[i]) mesh.tetrahedra[to++] = mesh.tetrahedra[i];
  mesh.tetrahedra.resize(to);
  for (Field& cellField : mesh.cellFields) keepTuples(keep, cellField);
  if (field.centering == Centering::cell) {
    Field values{field.name, 1, std::move(field.values)};
    keepTuples(keep, values);
    field.values = std::move(values.values);
  }
  setRange(mesh, field);
  return holes;
}

}  // namespace havs
