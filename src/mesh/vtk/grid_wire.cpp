#include "mesh/vtk/grid_wire.h"

#include "core/error.h"
#include "core/memory_budget.h"

namespace havs {
namespace {

enum class Message { end, cells, structured, note };

void put(ByteWriter& out, const std::vector<Field>& fields) {
  out.put(fields.size());
  for (const Field& field : fields) {
    out.put(field.name);
    out.put(field.components);
    out.put(field.values);
  }
}

std::vector<Field> getFields(ByteReader& in) {
  std::vector<Field> fields(in.get<std::size_t>());
  for (Field& field : fields) {
    field.name = in.getString();
    field.components = in.get<int>();
    field.values = in.getVector<double>();
  }
  return fields;
}

CellSoup getCells(ByteReader& in) {
  CellSoup cells;
  cells.points = in.getVector<Vec3>();
  cells.types = in.getVector<std::uint8_t>();
  cells.offsets = in.getVector<std::int64_t>();
  cells.connectivity = in.getVector<std::int64_t>();
  cells.pointFields = getFields(in);
  cells.cellFields = getFields(in);
  return cells;
}

StructuredBlock getStructured(ByteReader& in) {
  StructuredBlock grid;
  grid.size = in.get<std::array<std::size_t, 3>>();
  grid.points = in.getVector<Vec3>();
  grid.blank = in.getVector<int>();
  grid.hiddenCell = in.getVector<std::uint8_t>();
  grid.pointFields = getFields(in);
  grid.cellFields = getFields(in);
  return grid;
}

}  // namespace

void GridWriter::add(CellSoup&& cells) {
  out_.put(Message::cells);
  out_.put(cells.points);
  out_.put(cells.types);
  out_.put(cells.offsets);
  out_.put(cells.connectivity);
  put(out_, cells.pointFields);
  put(out_, cells.cellFields);
}

void GridWriter::add(StructuredBlock&& grid) {
  out_.put(Message::structured);
  out_.put(grid.size);
  out_.put(grid.points);
  out_.put(grid.blank);
  out_.put(grid.hiddenCell);
  put(out_, grid.pointFields);
  put(out_, grid.cellFields);
}

void GridWriter::note(const std::string& text) {
  out_.put(Message::note);
  out_.put(text);
}

std::size_t GridWriter::memoryLimit() const { return havs::memoryLimit(); }

void GridWriter::finish(const std::string& where) {
  if (!failure_.empty())
    failInput("cannot be read: " + failure_, where, "is the file whole, and of the kind its name says?");
  out_.put(Message::end);
}

GridBlocks receiveGrids(ByteReader& in) {
  GridBlocks blocks;
  while (true) {
    switch (in.get<Message>()) {
      case Message::end:
        return blocks;
      case Message::cells:
        blocks.cells.push_back(getCells(in));
        break;
      case Message::structured:
        blocks.structured.push_back(getStructured(in));
        break;
      case Message::note:
        blocks.notes.push_back(in.getString());
        break;
    }
  }
}

}  // namespace havs
