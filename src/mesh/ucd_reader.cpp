// AVS UCD, ASCII. A header line
//   points cells point-values cell-values model-values
// then a line a point (number x y z), a line a cell (number material type points...), then, where there are any, the
// data of the points and of the cells: a line of component counts, a line "name, unit" a field, a line a point (number
// values...). Numbers of points and cells may be any integers.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "core/memory_budget.h"
#include "mesh/cells.h"
#include "mesh/formats.h"
#include "mesh/text_scanner.h"

namespace havs {
namespace {

/// From the numbers in the file to positions in our arrays; quick when they run in order, as they mostly do.
class Numbering {
 public:
  explicit Numbering(const char* what) : what_(what) {}

  void append(const TextScanner& in, std::int64_t number) {
    if (size_ == 0) first_ = number;
    const bool follows = positions_.empty() && fromFirst(number) == size_;
    if (!follows) insertAll();
    if (!follows && !positions_.emplace(number, size_).second)
      in.fail(fmt::format("{} number {} comes twice", what_, number), "give each its own number");
    ++size_;
  }
  std::optional<std::size_t> find(std::int64_t number) const {
    if (!positions_.empty()) {
      const auto found = positions_.find(number);
      return found == positions_.end() ? std::nullopt : std::optional(found->second);
    }
    return fromFirst(number) < size_ ? std::optional(static_cast<std::size_t>(fromFirst(number))) : std::nullopt;
  }
  std::size_t position(const TextScanner& in, std::int64_t number) const {
    if (const auto found = find(number)) return *found;
    in.fail(fmt::format("there is no {} number {}, it is out of range", what_, number), "correct it");
  }
  const char* what() const { return what_; }
  std::size_t size() const { return size_; }

 private:
  /// Modulo 2^64, so huge for a number below the first.
  std::uint64_t fromFirst(std::int64_t number) const {
    return static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(first_);
  }
  void insertAll() {
    if (!positions_.empty()) return;
    for (std::size_t i = 0; i < size_; ++i) positions_.emplace(first_ + static_cast<std::int64_t>(i), i);
  }

  const char* what_;
  std::int64_t first_ = 0;
  std::size_t size_ = 0;
  std::unordered_map<std::int64_t, std::size_t> positions_;  // empty while the numbers run in order
};

struct UcdCell {
  std::string_view name;
  std::uint8_t vtkType;
  std::vector<int> vtkOrder;  ///< UCD counts from the top of a cell, VTK from its base
};

const UcdCell* ucdCell(std::string_view name) {
  static const std::vector<UcdCell> cells = {{"pt", 1, {0}},
                                             {"line", 3, {0, 1}},
                                             {"tri", 5, {0, 1, 2}},
                                             {"quad", 9, {0, 1, 2, 3}},
                                             {"tet", 10, {0, 1, 2, 3}},
                                             {"hex", 12, {4, 5, 6, 7, 0, 1, 2, 3}},
                                             {"prism", 13, {3, 4, 5, 0, 1, 2}},
                                             {"pyr", 14, {1, 2, 3, 4, 0}}};
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const UcdCell& cell) { return cell.name == name; });
  return found == cells.end() ? nullptr : &*found;
}

struct Header {
  std::size_t points, cells;
  bool pointData, cellData;
};

Header readHeader(TextScanner& in) {
  in.needLine("the header of the mesh");
  Header header{};
  header.points = in.count("points", 8);
  if (!in.more())
    in.fail("the header holds one number only",
            "of the UCD formats, the one without time steps is read: points, cells, "
            "point values, cell values, model values");
  header.cells = in.count("cells", 8);
  if (header.points == 0 || header.cells == 0) in.fail("there are no points or no cells", "check the header");
  header.pointData = in.more() && in.integer("the number of values at a point") > 0;
  header.cellData = in.more() && in.integer("the number of values at a cell") > 0;
  return header;
}

void readPoints(TextScanner& in, std::size_t count, CellSoup& soup, Numbering& numbering) {
  needMemory(sizeof(Vec3) * static_cast<double>(count), fmt::format("{} points", count));
  soup.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    in.needLine(fmt::format("point {} of {}", i + 1, count));
    numbering.append(in, in.integer("a point's number"));
    const double x = in.real("x");
    const double y = in.real("y");
    soup.points.emplace_back(x, y, in.real("z"));
    in.refuseDecimalCommas();
  }
}

void readCell(TextScanner& in, const Numbering& points, CellSoup& soup, Field& material) {
  const bool hasMaterial = !std::isalpha(static_cast<unsigned char>(in.peek()));  // some writers leave it out
  material.values.push_back(hasMaterial ? in.real("a cell's material") : 0);
  const std::string_view name = in.word("a cell's type");
  const UcdCell* cell = ucdCell(name);
  if (!cell)
    in.fail(fmt::format("'{}' is no type of cell", name.substr(0, 40)),
            "known: pt, line, tri, quad, tet, hex, prism, pyr");
  std::array<std::int64_t, 8> corners{};
  for (std::size_t i = 0; i < cell->vtkOrder.size(); ++i)
    corners[i] = static_cast<std::int64_t>(points.position(in, in.integer("a point's number")));
  if (in.more())
    in.fail(fmt::format("a {} has more than {} points", name, cell->vtkOrder.size()),
            "cells with mid nodes are not read");
  for (const int i : cell->vtkOrder) soup.connectivity.push_back(corners[static_cast<std::size_t>(i)]);
  soup.types.push_back(cell->vtkType);
  soup.offsets.push_back(static_cast<std::int64_t>(soup.connectivity.size()));
}

void readCells(TextScanner& in, std::size_t count, const Numbering& points, CellSoup& soup, Numbering& numbering) {
  Field material{"material", 1, {}};
  soup.offsets.push_back(0);
  for (std::size_t i = 0; i < count; ++i) {
    in.needLine(fmt::format("cell {} of {}", i + 1, count));
    numbering.append(in, in.integer("a cell's number"));
    readCell(in, points, soup, material);
  }
  const auto differs = [&](double value) { return value != material.values.front(); };
  if (std::any_of(material.values.begin(), material.values.end(), differs)) soup.cellFields.push_back(material);
}

/// The label lines may hold "name, unit", "name," or a name alone.
std::string fieldName(TextScanner& in, std::size_t number) {
  std::string_view label = in.wholeLine("the name of a field");
  label = label.substr(0, label.find(','));
  while (!label.empty() && label.back() == ' ') label.remove_suffix(1);
  return label.empty() ? fmt::format("data{}", number) : std::string(label);
}

std::vector<Field> readFields(TextScanner& in, const Numbering& numbering) {
  in.needLine("the number of fields");
  const std::size_t count = in.count("fields", 2);
  std::vector<Field> fields(count);
  for (Field& field : fields) {
    const std::size_t components = in.count("components", 1);
    if (components < 1 || components > 1000)
      in.fail(fmt::format("a field has {} components", components), "1 to 1000 are read");
    field.components = static_cast<int>(components);
  }
  for (std::size_t i = 0; i < count; ++i) fields[i].name = fieldName(in, i);
  const std::size_t total = std::accumulate(
      fields.begin(), fields.end(), std::size_t{0},
      [](std::size_t sum, const Field& field) { return sum + static_cast<std::size_t>(field.components); });
  if (!in.holds(2 * total * numbering.size()))
    in.fail(fmt::format("the values of {} {}s, {} each, are promised, but the rest of the file is too short for them",
                        numbering.size(), numbering.what(), total),
            "is the file cut short?");
  needMemory(sizeof(double) * static_cast<double>(total * numbering.size()),
             fmt::format("{} values of each of {} {}s", total, numbering.size(), numbering.what()));

  std::vector<char> seen(numbering.size(), 0);
  for (std::size_t i = 0; i < numbering.size(); ++i) {
    in.needLine(fmt::format("the values of {} {} of {}", numbering.what(), i + 1, numbering.size()));
    const std::int64_t number = in.integer("a number");
    const std::size_t at = numbering.position(in, number);
    if (seen[at]++) in.fail(fmt::format("{} number {} gets values twice", numbering.what(), number), "correct it");
    for (Field& field : fields) {
      const auto n = static_cast<std::size_t>(field.components);
      if (field.values.empty()) field.values.resize(numbering.size() * n);
      for (std::size_t c = 0; c < n; ++c) field.values[at * n + c] = in.real("a value");
    }
  }
  return fields;
}

}  // namespace

TetMesh readUcd(const std::filesystem::path& file, const ReadOptions&) {
  TextScanner in(file);
  const Header header = readHeader(in);
  CellSoup soup;
  Numbering points("point");
  Numbering cells("cell");
  readPoints(in, header.points, soup, points);
  readCells(in, header.cells, points, soup, cells);
  if (header.pointData) soup.pointFields = readFields(in, points);
  if (header.cellData) {
    std::vector<Field> fields = readFields(in, cells);
    soup.cellFields.insert(soup.cellFields.begin(), fields.begin(), fields.end());
  }
  return cutIntoTetrahedra(std::move(soup), file.string());
}

}  // namespace havs
