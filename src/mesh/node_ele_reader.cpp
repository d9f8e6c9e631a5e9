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
#include "core/memory_budget.h"
#include "mesh/cells.h"
#include "mesh/formats.h"
#include "mesh/numbered_rows.h"
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

/// Columns that a header announces for each line; `most` guards against nonsense.
std::size_t columns(TextScanner& in, const char* what) {
  constexpr std::int64_t kMost = 10000;
  const std::int64_t n = in.more() ? in.integer(what) : 0;
  if (n < 0 || n > kMost) in.fail(fmt::format("{} is {}", what, n), fmt::format("0 to {} are read", kMost));
  return static_cast<std::size_t>(n);
}

/// Room for what the rows of a table hold. A header that promises more than the rest of the file can hold gets no
/// memory for it: such a table is read into one row, until what is missing is found.
class Rows {
 public:
  Rows(const TextScanner& in, std::size_t count, std::size_t columns, const char* what) {
    constexpr std::size_t kShortest = 2;  // a digit and a space
    fits_ = in.holds(count * columns * kShortest);
    if (fits_) needMemory(sizeof(double) * static_cast<double>(count * columns), fmt::format("{} {}", count, what));
    size_ = fits_ ? count : 1;
  }
  std::size_t size() const { return size_; }
  bool oneRow() const { return !fits_; }
  std::size_t place(std::size_t row) const { return fits_ ? row : 0; }
  void make(std::vector<Field>& fields) const {
    for (Field& field : fields) field.values.resize(size_);
  }

 private:
  bool fits_;
  std::size_t size_;
};

Points readPoints(const fs::path& file, const Progress& progress) {
  TextScanner in(file);
  in.needLine("the header of the points");
  const std::size_t count = in.count("points", 8);  // "0 0 0 0\n" is the shortest line
  if (count == 0) in.fail("there are no points", "a .node file starts with their number");
  const std::int64_t dimension = in.more() ? in.integer("the dimension") : 3;
  if (dimension != 3) in.fail(fmt::format("the points have {} dimensions", dimension), "a volume needs 3");
  const std::size_t attributes = columns(in, "the number of attributes");
  Points points;
  points.hasMarkers = columns(in, "the number of boundary markers") > 0;

  for (std::size_t a = 0; a < attributes; ++a) points.fields.push_back({fmt::format("attribute{}", a), 1, {}});
  const Rows room(in, count, 4 + attributes, "points");
  points.positions.resize(room.size());
  room.make(points.fields);
  const auto read = [&](TextScanner& line, std::size_t index, std::int64_t) {
    const std::size_t i = room.place(index);
    Vec3& position = points.positions[i];
    position.x = line.real("x");
    position.y = line.real("y");
    position.z = line.real("z");
    for (Field& field : points.fields) field.values[i] = line.real("an attribute");
    if (points.hasMarkers) line.integer("a boundary marker");
  };
  const RowsRead rows = readNumberedRows(
      in, {count, room.oneRow(), "point", "points", "a point's number", "read points", read}, progress);
  points.firstNumber = rows.firstNumber;
  points.longLines = rows.longLines;
  return points;
}

/// TetGen puts the mid nodes on the edges 23, 03, 01, 12, 13, 02; VTK on 01, 12, 02, 03, 13, 23.
constexpr std::array<std::size_t, 6> kMidNodes = {2, 3, 5, 1, 4, 0};

struct Cells {
  std::vector<Tetrahedron> corners;
  std::vector<std::array<Index, 6>> midNodes;  // none of linear tetrahedra
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

/// A point's number as the files count, made an index.
Index pointOf(TextScanner& in, const Points& points, std::int64_t tetrahedron) {
  const std::int64_t last = points.firstNumber + static_cast<std::int64_t>(points.positions.size()) - 1;
  const std::int64_t point = in.integer("a point's number");
  if (point < points.firstNumber || point > last)
    in.fail(fmt::format("tetrahedron {} has the point number {}, out of range: the points are {} to {}", tetrahedron,
                        point, points.firstNumber, last),
            "do the .node and the .ele file belong together?");
  return static_cast<Index>(point - points.firstNumber);
}

Cells readCells(const fs::path& file, const Points& points, const Progress& progress) {
  TextScanner in(file);
  in.needLine("the header of the tetrahedra");
  const std::size_t count = in.count("tetrahedra", 10);
  if (count == 0) in.fail("there are no tetrahedra", "an .ele file starts with their number");
  Cells cells;
  const std::int64_t nodes = in.more() ? in.integer("the number of points of a tetrahedron") : 4;
  if (nodes != 4 && nodes != 10) in.fail(fmt::format("tetrahedra have {} points", nodes), "4 and 10 are read");
  cells.fields = attributeFields(columns(in, "the number of attributes"));

  const Rows room(in, count, 1 + static_cast<std::size_t>(nodes) + cells.fields.size(), "tetrahedra");
  cells.corners.resize(room.size());
  if (nodes == 10) cells.midNodes.resize(room.size());
  room.make(cells.fields);
  const auto read = [&](TextScanner& line, std::size_t index, std::int64_t number) {
    const std::size_t i = room.place(index);
    for (Index& corner : cells.corners[i]) corner = pointOf(line, points, number);
    if (nodes == 10)
      for (Index& node : cells.midNodes[i]) node = pointOf(line, points, number);
    for (Field& field : cells.fields) field.values[i] = line.real("an attribute");
  };
  cells.longLines =
      readNumberedRows(
          in, {count, room.oneRow(), "tetrahedron", "tetrahedra", "a tetrahedron's number", "read cells", read},
          progress)
          .longLines;
  return cells;
}

TetMesh linearMesh(Points points, Cells cells) {
  TetMesh mesh;
  mesh.points = std::move(points.positions);
  mesh.pointFields = std::move(points.fields);
  mesh.cellFields = std::move(cells.fields);
  mesh.sourceCells = cells.corners.size();
  mesh.tetrahedra = std::move(cells.corners);
  return mesh;
}

TetMesh quadraticMesh(Points points, const Cells& cells, const std::string& where) {
  constexpr std::uint8_t kQuadraticTetra = 24;
  CellSoup soup;
  soup.points = std::move(points.positions);
  soup.pointFields = std::move(points.fields);
  soup.cellFields = cells.fields;
  soup.types.assign(cells.corners.size(), kQuadraticTetra);
  soup.connectivity.reserve(10 * cells.corners.size());
  for (std::size_t i = 0; i < cells.corners.size(); ++i) {
    soup.connectivity.insert(soup.connectivity.end(), cells.corners[i].begin(), cells.corners[i].end());
    for (const std::size_t node : kMidNodes) soup.connectivity.push_back(cells.midNodes[i][node]);
  }
  for (std::size_t i = 0; i <= soup.types.size(); ++i) soup.offsets.push_back(static_cast<std::int64_t>(10 * i));
  return cutIntoTetrahedra(std::move(soup), where);
}

}  // namespace

TetMesh readNodeEle(const fs::path& file, const ReadOptions& options) {
  const Pair pair = pairOf(file);
  Points points = readPoints(pair.node, options.progress);
  Cells cells = readCells(pair.ele, points, options.progress);
  if (options.progress) options.progress("read cells", 1);
  const bool hasMarkers = points.hasMarkers;
  const std::size_t longLines[2] = {points.longLines, cells.longLines};
  TetMesh mesh = cells.midNodes.empty() ? linearMesh(std::move(points), std::move(cells))
                                        : quadraticMesh(std::move(points), cells, pair.ele.string());
  if (hasMarkers) mesh.notes.push_back("left out the boundary markers of the points");
  for (int i = 0; i < 2; ++i)
    if (longLines[i] > 0)
      mesh.notes.push_back(fmt::format("left out what {} lines of {} hold beyond the columns of its header",
                                       longLines[i], (i == 0 ? pair.node : pair.ele).filename().string()));
  return mesh;
}

}  // namespace havs
