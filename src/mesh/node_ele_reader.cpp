// TetGen's .node and .ele files. A header line of counts, then one line a point:
//   number x y z attributes... [boundary marker]
// or one a tetrahedron:
//   number p0 p1 p2 p3 [six mid nodes] attributes...
// All numbers start at 0 or at 1, as the first point's does.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "mesh/cells.h"
#include "mesh/formats.h"
#include "mesh/text_scanner.h"

namespace havs {
namespace {
namespace fs = std::filesystem;

/// The point file and the cell file, whichever of them was named.
struct Pair {
  fs::path node;
  fs::path ele;
};

Pair pairOf(const fs::path& file) {
  std::string extension = file.extension().string();
  const bool upper = extension.size() > 1 && extension[1] < 'a';
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  const bool isNode = extension == ".node";
  const char* kOther[2] = {isNode ? ".ele" : ".node", isNode ? ".ELE" : ".NODE"};
  for (const bool wanted : {upper, !upper}) {
    fs::path other = file;
    other.replace_extension(kOther[wanted ? 1 : 0]);
    std::error_code ignored;
    if (fs::is_regular_file(other, ignored)) return isNode ? Pair{file, other} : Pair{other, file};
  }
  fs::path missing = file;
  missing.replace_extension(kOther[upper ? 1 : 0]);
  failInput("not found beside " + file.filename().string(), missing.string(),
            "a TetGen mesh is a .node and an .ele file of one name");
}

struct Points {
  std::vector<Vec3> positions;
  std::vector<Field> fields;
  std::int64_t firstNumber = 0;
  bool hasMarkers = false;
  std::size_t longLines = 0;  // with more than the header says
};

/// The number at the head of a line; TetGen's files number consecutively, and a gap means a line is lost.
void checkNumber(const TextScanner& in, std::int64_t number, std::int64_t wanted, const char* what) {
  if (number != wanted)
    in.fail(fmt::format("{} number {} stands where {} is expected", what, number, wanted),
            "number them one after the other, from 0 or from 1");
}

/// Columns that a header announces for each line; `most` guards against nonsense.
std::size_t columns(TextScanner& in, const char* what) {
  constexpr std::int64_t kMost = 10000;
  const std::int64_t n = in.more() ? in.integer(what) : 0;
  if (n < 0 || n > kMost) in.fail(fmt::format("{} is {}", what, n), fmt::format("0 to {} are read", kMost));
  return static_cast<std::size_t>(n);
}

Points readPoints(const fs::path& file) {
  TextScanner in(file);
  in.needLine("the header of the points");
  const std::size_t count = in.count("points", 8);  // "0 0 0 0\n" is the shortest line
  if (count == 0) in.fail("there are no points", "a .node file starts with their number");
  const std::int64_t dimension = in.more() ? in.integer("the dimension") : 3;
  if (dimension != 3) in.fail(fmt::format("the points have {} dimensions", dimension), "a volume needs 3");
  const std::size_t attributes = columns(in, "the number of attributes");
  Points points;
  points.hasMarkers = columns(in, "the number of boundary markers") > 0;

  points.positions.reserve(count);
  for (std::size_t a = 0; a < attributes; ++a) points.fields.push_back({fmt::format("attribute{}", a), 1, {}});
  for (std::size_t i = 0; i < count; ++i) {
    if (!in.nextLine())
      in.fail(fmt::format("the file ends after {} of {} points", i, count), "is it cut short, or its header wrong?");
    const std::int64_t number = in.integer("a point's number");
    if (i == 0 && number != 0 && number != 1)
      in.fail(fmt::format("the first point's number is {}", number), "start at 0 or at 1");
    if (i == 0) points.firstNumber = number;
    checkNumber(in, number, points.firstNumber + static_cast<std::int64_t>(i), "point");
    const double x = in.real("x");
    const double y = in.real("y");
    points.positions.emplace_back(x, y, in.real("z"));
    for (Field& field : points.fields) field.values.push_back(in.real("an attribute"));
    if (points.hasMarkers) in.integer("a boundary marker");
    points.longLines += in.more() ? 1 : 0;
  }
  return points;
}

/// TetGen puts the mid nodes on the edges 23, 03, 01, 12, 13, 02; VTK on 01, 12, 02, 03, 13, 23.
constexpr std::array<std::size_t, 10> kVtkFromTetgen = {0, 1, 2, 3, 6, 7, 9, 5, 8, 4};

struct Cells {
  std::size_t nodes = 4;
  std::vector<std::int64_t> connectivity;
  std::vector<Field> fields;
  std::size_t longLines = 0;
};

/// The last attribute is the region's number, as TetGen's switch -A appends it.
std::vector<Field> attributeFields(std::size_t attributes) {
  std::vector<Field> fields;
  for (std::size_t a = 0; a + 1 < attributes; ++a) fields.push_back({fmt::format("attribute{}", a), 1, {}});
  if (attributes > 0) fields.push_back({"region", 1, {}});
  return fields;
}

Cells readCells(const fs::path& file, const Points& points) {
  TextScanner in(file);
  in.needLine("the header of the tetrahedra");
  const std::size_t count = in.count("tetrahedra", 10);
  if (count == 0) in.fail("there are no tetrahedra", "an .ele file starts with their number");
  Cells cells;
  const std::int64_t nodes = in.more() ? in.integer("the number of points of a tetrahedron") : 4;
  if (nodes != 4 && nodes != 10) in.fail(fmt::format("tetrahedra have {} points", nodes), "4 and 10 are read");
  cells.nodes = static_cast<std::size_t>(nodes);
  cells.fields = attributeFields(columns(in, "the number of attributes"));

  const auto pointCount = static_cast<std::int64_t>(points.positions.size());
  const std::int64_t last = points.firstNumber + pointCount - 1;
  cells.connectivity.reserve(count * cells.nodes);
  std::int64_t firstNumber = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!in.nextLine())
      in.fail(fmt::format("the file ends after {} of {} tetrahedra", i, count),
              "is it cut short, or its header wrong?");
    const std::int64_t number = in.integer("a tetrahedron's number");
    if (i == 0) firstNumber = number;
    checkNumber(in, number, firstNumber + static_cast<std::int64_t>(i), "tetrahedron");
    for (std::size_t n = 0; n < cells.nodes; ++n) {
      const std::int64_t point = in.integer("a point's number");
      if (point < points.firstNumber || point > last)
        in.fail(fmt::format("tetrahedron {} has the point number {}, out of range: the points are {} to {}", number,
                            point, points.firstNumber, last),
                "do the .node and the .ele file belong together?");
      cells.connectivity.push_back(point - points.firstNumber);
    }
    for (Field& field : cells.fields) field.values.push_back(in.real("an attribute"));
    cells.longLines += in.more() ? 1 : 0;
  }
  return cells;
}

TetMesh linearMesh(Points points, Cells cells) {
  TetMesh mesh;
  mesh.points = std::move(points.positions);
  mesh.pointFields = std::move(points.fields);
  mesh.cellFields = std::move(cells.fields);
  mesh.sourceCells = cells.connectivity.size() / 4;
  mesh.tetrahedra.resize(mesh.sourceCells);
  for (std::size_t i = 0; i < cells.connectivity.size(); ++i)
    mesh.tetrahedra[i / 4][i % 4] = static_cast<Index>(cells.connectivity[i]);
  return mesh;
}

TetMesh quadraticMesh(Points points, const Cells& cells, const std::string& where) {
  constexpr std::uint8_t kQuadraticTetra = 24;
  CellSoup soup;
  soup.points = std::move(points.positions);
  soup.pointFields = std::move(points.fields);
  soup.cellFields = cells.fields;
  soup.types.assign(cells.connectivity.size() / 10, kQuadraticTetra);
  soup.connectivity.resize(cells.connectivity.size());
  for (std::size_t i = 0; i < soup.connectivity.size(); ++i)
    soup.connectivity[i] = cells.connectivity[i - i % 10 + kVtkFromTetgen[i % 10]];
  for (std::size_t i = 0; i <= soup.types.size(); ++i) soup.offsets.push_back(static_cast<std::int64_t>(10 * i));
  return cutIntoTetrahedra(std::move(soup), where);
}

}  // namespace

TetMesh readNodeEle(const fs::path& file, const ReadOptions&) {
  const Pair pair = pairOf(file);
  Points points = readPoints(pair.node);
  Cells cells = readCells(pair.ele, points);
  const bool hasMarkers = points.hasMarkers;
  const std::size_t longLines[2] = {points.longLines, cells.longLines};
  TetMesh mesh = cells.nodes == 4 ? linearMesh(std::move(points), std::move(cells))
                                  : quadraticMesh(std::move(points), cells, pair.ele.string());
  if (hasMarkers) mesh.notes.push_back("left out the boundary markers of the points");
  for (int i = 0; i < 2; ++i)
    if (longLines[i] > 0)
      mesh.notes.push_back(fmt::format("left out what {} lines of {} hold beyond the columns of its header",
                                       longLines[i], (i == 0 ? pair.node : pair.ele).filename().string()));
  return mesh;
}

}  // namespace havs
