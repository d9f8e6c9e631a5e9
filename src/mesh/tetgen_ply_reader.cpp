// Stanford's PLY: a text header that describes elements and their properties, then their values as text or binary
// numbers. Of element "vertex" x, y, z are taken, of "face" the list vertex_indices (or vertex_index); the rest is
// passed over.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "mesh/tetgen_binary_file.h"
#include "mesh/tetgen_surface.h"

namespace havs {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type = Type::float32;
  bool isList = false;
  Type countType = Type::uint8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool ascii = false;
  std::vector<Element> elements;
};

Type typeOf(const BinaryFile& in, const std::string& name) {
  constexpr struct {
    const char* names[2];
    Type type;
  } kTypes[] = {{{"char", "int8"}, Type::int8},        {{"uchar", "uint8"}, Type::uint8},
                {{"short", "int16"}, Type::int16},     {{"ushort", "uint16"}, Type::uint16},
                {{"int", "int32"}, Type::int32},       {{"uint", "uint32"}, Type::uint32},
                {{"float", "float32"}, Type::float32}, {{"double", "float64"}, Type::float64}};
  for (const auto& row : kTypes)
    if (name == row.names[0] || name == row.names[1]) return row.type;
  in.fail("the header has a property of unknown type '" + name.substr(0, 40) + "'");
}

Property readProperty(const BinaryFile& in, std::istringstream& words) {
  Property property;
  std::string type, countType;
  words >> type;
  if (type == "list") {
    property.isList = true;
    words >> countType >> type;
    property.countType = typeOf(in, countType);
  }
  property.type = typeOf(in, type);
  if (!(words >> property.name)) in.fail("a property of the header has no name");
  return property;
}

Header readHeader(BinaryFile& in) {
  Header header;
  bool hasFormat = false;
  if (in.line("the word ply") != "ply") in.fail("this is no PLY file: it does not start with the word ply");
  while (true) {
    std::istringstream words(in.line("the header's end"));
    std::string word, format;
    words >> word;
    if (word == "end_header") break;
    if (word == "format") {
      words >> format;
      hasFormat = format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian";
      header.ascii = format == "ascii";
      in.setBigEndian(format == "binary_big_endian");
    } else if (word == "element") {
      Element element;
      if (!(words >> element.name >> element.count)) in.fail("an element of the header has no name or count");
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty()) in.fail("a property of the header belongs to no element");
      header.elements.back().properties.push_back(readProperty(in, words));
    }
  }
  if (!hasFormat) in.fail("the header names no format that is known: ascii, binary_little_endian, binary_big_endian");
  return header;
}

/// Numbers one after another, as text or binary.
class Numbers {
 public:
  Numbers(BinaryFile& in, bool ascii) : in_(in), ascii_(ascii) {}

  double next(Type type, const std::string& wanted) {
    if (ascii_) return nextWord(wanted);
    switch (type) {
      case Type::int8:
        return in_.get<std::int8_t>(wanted);
      case Type::uint8:
        return in_.get<std::uint8_t>(wanted);
      case Type::int16:
        return in_.get<std::int16_t>(wanted);
      case Type::uint16:
        return in_.get<std::uint16_t>(wanted);
      case Type::int32:
        return in_.get<std::int32_t>(wanted);
      case Type::uint32:
        return in_.get<std::uint32_t>(wanted);
      case Type::float32:
        return static_cast<double>(in_.get<float>(wanted));
      case Type::float64:
        return in_.get<double>(wanted);
    }
    return 0;
  }

  /// A count of values that follow; each takes at least one byte.
  std::size_t count(Type type, const std::string& wanted) {
    const double value = next(type, wanted);
    if (!(value >= 0 && value <= static_cast<double>(in_.left() + 1)) || value != std::floor(value))
      in_.fail(fmt::format("{} is {}, but {} bytes follow", wanted, value, in_.left()), "is the file cut short?");
    return static_cast<std::size_t>(value);
  }

 private:
  double nextWord(const std::string& wanted) {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    char c = ' ';
    while (isSpace(c)) c = in_.get<char>(wanted);
    std::string word;
    while (!isSpace(c)) {
      word += c;
      c = in_.left() > 0 ? in_.get<char>(wanted) : ' ';
    }
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || stop != word.data() + word.size())
      in_.fail(fmt::format("'{}' is no number, {} is expected", word.substr(0, 40), wanted), "correct it");
    return value;
  }

  BinaryFile& in_;
  bool ascii_;
};

void skipProperty(Numbers& numbers, const Property& property) {
  const std::size_t values = property.isList ? numbers.count(property.countType, "the length of a list") : 1;
  for (std::size_t i = 0; i < values; ++i) numbers.next(property.type, "a property");
}

void readVertices(const BinaryFile& in, Numbers& numbers, const Element& element, Surface& surface) {
  constexpr const char* kAxes[3] = {"x", "y", "z"};
  for (const char* axis : kAxes)
    if (std::ranges::find(element.properties, axis, &Property::name) == element.properties.end())
      in.fail(std::string("the vertices have no property ") + axis);
  for (std::size_t i = 0; i < element.count; ++i) {
    Vec3 point{std::numeric_limits<double>::quiet_NaN()};
    for (const Property& property : element.properties) {
      const auto axis = std::ranges::find(kAxes, property.name);
      if (axis == std::end(kAxes) || property.isList)
        skipProperty(numbers, property);
      else
        point[static_cast<int>(axis - kAxes)] = numbers.next(property.type, fmt::format("vertex {}", i));
    }
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
      in.fail(fmt::format("vertex {} has a coordinate that is not finite", i), "correct it");
    surface.points.push_back(point);
  }
}

std::vector<int> readCorners(const BinaryFile& in, Numbers& numbers, const Property& list, std::size_t points) {
  std::vector<int> corners(numbers.count(list.countType, "a face's number of corners"));
  if (corners.size() < 3) in.fail(fmt::format("a face has {} corners", corners.size()), "it needs at least 3");
  for (int& corner : corners) {
    const double number = numbers.next(list.type, "a corner's vertex number");
    if (!(number >= 0 && number < static_cast<double>(points)) || number != std::floor(number))
      in.fail(fmt::format("a face has the vertex number {}, out of range: the vertices are 0 to {}", number,
                          static_cast<std::int64_t>(points) - 1),
              "correct it");
    corner = static_cast<int>(number);
  }
  return corners;
}

void readFaces(const BinaryFile& in, Numbers& numbers, const Element& element, Surface& surface) {
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      const bool corners = property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
      if (corners)
        surface.facets.push_back({{readCorners(in, numbers, property, surface.points.size())}, {}, 0});
      else
        skipProperty(numbers, property);
    }
  }
}

}  // namespace

Surface readPlySurface(const std::filesystem::path& file) {
  BinaryFile in(file);
  const Header header = readHeader(in);
  Numbers numbers(in, header.ascii);
  Surface surface;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    if (element.count > in.left())
      in.fail(fmt::format("{} elements '{}' are promised, but {} bytes follow", element.count, element.name, in.left()),
              "is the file cut short?");
    if (element.name == "vertex")
      readVertices(in, numbers, element, surface);
    else if (element.name == "face")
      readFaces(in, numbers, element, surface);
    else
      for (std::size_t i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) skipProperty(numbers, property);
  }
  if (surface.points.empty() || surface.facets.empty()) in.fail("there are no vertices or no faces");
  return surface;
}

}  // namespace havs
