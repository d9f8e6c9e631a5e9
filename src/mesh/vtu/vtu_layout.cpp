#include "mesh/vtu/vtu_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <string_view>
#include <utility>

#include "mesh/vtu/tag_scanner.h"

namespace havs {
namespace {

constexpr std::array<std::pair<std::string_view, NumberType>, 10> kTypes{{{"Int8", NumberType::int8},
                                                                          {"UInt8", NumberType::uint8},
                                                                          {"Int16", NumberType::int16},
                                                                          {"UInt16", NumberType::uint16},
                                                                          {"Int32", NumberType::int32},
                                                                          {"UInt32", NumberType::uint32},
                                                                          {"Int64", NumberType::int64},
                                                                          {"UInt64", NumberType::uint64},
                                                                          {"Float32", NumberType::float32},
                                                                          {"Float64", NumberType::float64}}};

constexpr std::array<std::pair<std::string_view, Compressor>, 3> kCompressors{
    {{"", Compressor::none}, {"vtkZLibDataCompressor", Compressor::zlib}, {"vtkLZ4DataCompressor", Compressor::lz4}}};
constexpr std::array<std::string_view, 6> kVersions{"0.1", "1.0", "2.0", "2.1", "2.2", "2.3"};

std::optional<std::size_t> number(std::string_view text) {
  std::size_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return {};
  return value;
}

/// Walks through the tags; every function is false where the file is none of the plain ones.
class LayoutReader {
 public:
  explicit LayoutReader(const FileBlocks& file) : file_(file), tags_(file) {}

  std::optional<VtuLayout> read() {
    if (!readFileTag() || !enter("UnstructuredGrid") || !readPieces() || !readAppended()) return {};
    return checked() ? std::optional(std::move(layout_)) : std::nullopt;
  }

 private:
  struct Section {
    const char* name;
    bool seen = false;
  };

  bool readFileTag() {
    const auto tag = tags_.next();
    if (!tag || tag->name != "VTKFile" || tag->empty) return false;
    const std::string version = tag->attribute("version", "0.1");
    const std::string header = tag->attribute("header_type", "UInt32");
    const std::string compressor = tag->attribute("compressor");
    layout_.headerBytes = header == "UInt64" ? 8 : 4;
    const auto known = std::ranges::find(kCompressors, compressor, &decltype(kCompressors)::value_type::first);
    if (known == kCompressors.end()) return false;
    layout_.compressor = known->second;
    return tag->attribute("type") == "UnstructuredGrid" && tag->attribute("byte_order") == "LittleEndian" &&
           std::ranges::find(kVersions, version) != kVersions.end() && (header == "UInt32" || header == "UInt64");
  }

  bool enter(const char* name) {
    const auto tag = tags_.next();
    return tag && tag->name == name && !tag->empty && !tag->attributes.contains("TimeValues");
  }

  /// Passes over the element; false when it does not end.
  bool skip(const Tag& element) {
    if (element.empty) return true;
    while (const auto tag = tags_.next())
      if (tag->name == "/" + element.name) return true;
    return false;
  }

  std::size_t behindSpace(std::size_t place) {
    while (std::string_view(" \t\r\n").find(tags_.at(place)) != std::string_view::npos) ++place;
    return place;
  }

  bool readPieces() {
    std::size_t pieces = 0;
    while (const auto tag = tags_.next()) {
      if (tag->name == "/UnstructuredGrid") return pieces == 1;
      if (tag->name == "FieldData") {
        if (!skip(*tag)) return false;
      } else if (tag->name != "Piece" || tag->empty || ++pieces > 1 || !readPiece(*tag)) {
        return false;
      }
    }
    return false;
  }

  bool readPiece(const Tag& piece) {
    const auto points = number(piece.attribute("NumberOfPoints")), cells = number(piece.attribute("NumberOfCells"));
    if (!points || !cells || *points == 0 || *cells == 0) return false;
    layout_.points = *points;
    layout_.cells = *cells;
    while (const auto tag = tags_.next()) {
      if (tag->name == "/Piece") return true;
      if (!readSection(*tag)) return false;
    }
    return false;
  }

  bool readSection(const Tag& section) {
    const auto known = std::ranges::find_if(sections_, [&](const Section& s) { return s.name == section.name; });
    if (known == sections_.end() || std::exchange(known->seen, true)) return false;
    if (section.empty) return true;
    while (const auto tag = tags_.next()) {
      if (tag->name == "/" + section.name) return true;
      if (tag->name != "DataArray") return false;
      VtuArray array;
      if (!readArray(*tag, array) || !keep(section.name, std::move(array))) return false;
    }
    return false;
  }

  bool readArray(const Tag& tag, VtuArray& array) {
    const auto components = number(tag.attribute("NumberOfComponents", "1"));
    const std::string type = tag.attribute("type"), format = tag.attribute("format");
    const auto known = std::ranges::find(kTypes, type, &decltype(kTypes)::value_type::first);
    if (known == kTypes.end() || !components || *components == 0 || *components > 10000) return false;
    if (tag.attributes.contains("TimeStep")) return false;
    array.name = tag.attribute("Name");
    array.type = known->second;
    array.components = *components;
    if (format == "appended") {
      const auto offset = number(tag.attribute("offset"));
      array.begin = offset.value_or(0);
      array.end = 0;  // until the appended data are found
      return offset && skip(tag);
    }
    if ((format != "ascii" && format != "binary") || tag.empty) return false;
    array.coding = format == "ascii" ? DataCoding::ascii : DataCoding::base64;
    array.begin = array.coding == DataCoding::base64 ? behindSpace(tag.end) : tag.end;
    const auto end = tags_.next();  // of the array, or an InformationKey behind its data
    array.end = end ? std::max(end->begin, array.begin) : 0;
    return end && (end->name == "/DataArray" || skip(tag));
  }

  bool keep(const std::string& section, VtuArray array) {
    if (section == "PointData" || section == "CellData") {
      auto& arrays = section == "PointData" ? layout_.pointData : layout_.cellData;
      const bool ghost = array.name == "vtkGhostType" || array.name == "vtkGhostLevels";
      const bool known = std::ranges::find(arrays, array.name, &VtuArray::name) != arrays.end();
      if (array.name.empty() || ghost || known) return false;
      arrays.push_back(std::move(array));
      return true;
    }
    VtuArray* place = section == "Points"            ? &layout_.coordinates
                      : array.name == "connectivity" ? &layout_.connectivity
                      : array.name == "offsets"      ? &layout_.offsets
                      : array.name == "types"        ? &layout_.types
                                                     : nullptr;
    if (!place || !placed_.insert(place).second) return false;
    *place = std::move(array);
    return true;
  }

  /// The appended data begin behind an underscore; what the arrays call offset counts from there.
  bool readAppended() {
    const auto tag = tags_.next();
    if (!tag) return false;
    std::size_t begin = 0;
    const bool base64 = tag->attribute("encoding") == "base64";
    if (tag->name == "AppendedData" && !tag->empty && (base64 || tag->attribute("encoding") == "raw")) {
      begin = behindSpace(tag->end);
      if (tags_.at(begin++) != '_') return false;
    } else if (tag->name != "/VTKFile") {
      return false;
    }
    bool found = true;
    forEach([&](VtuArray& array) {
      if (array.coding != DataCoding::raw) return;
      found = found && begin > 0 && array.begin < file_.size();
      array.begin += begin;
      array.end = file_.size();
      array.coding = base64 ? DataCoding::base64 : DataCoding::raw;
    });
    return found;
  }

  template <class Visit>
  void forEach(const Visit& visit) {
    for (VtuArray* array : {&layout_.coordinates, &layout_.connectivity, &layout_.offsets, &layout_.types})
      visit(*array);
    for (auto* arrays : {&layout_.pointData, &layout_.cellData})
      for (VtuArray& array : *arrays) visit(array);
  }

  bool checked() const {
    const auto whole = [](const VtuArray& a) {
      return a.components == 1 && a.type != NumberType::float32 && a.type != NumberType::float64;
    };
    const NumberType coordinate = layout_.coordinates.type;
    constexpr std::size_t kAll = 4;
    return placed_.size() == kAll && layout_.coordinates.components == 3 &&
           (coordinate == NumberType::float32 || coordinate == NumberType::float64) && whole(layout_.connectivity) &&
           whole(layout_.offsets) && whole(layout_.types);
  }

  const FileBlocks& file_;
  TagScanner tags_;
  VtuLayout layout_;
  std::array<Section, 4> sections_{{{"PointData"}, {"CellData"}, {"Points"}, {"Cells"}}};
  std::set<const VtuArray*> placed_;
};

}  // namespace

std::size_t sizeOf(NumberType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::optional<VtuLayout> vtuLayout(const FileBlocks& file) { return LayoutReader(file).read(); }

}  // namespace havs
