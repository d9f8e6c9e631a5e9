#pragma once
// Where a .vtu file keeps what: the XML part of it, without the numbers.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/file_blocks.h"

namespace havs {

enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of a number.
std::size_t sizeOf(NumberType type);

/// How blocks of an array are packed.
enum class Compressor { none, zlib, lz4 };

enum class DataCoding { ascii, base64, raw };

/// A DataArray and where in the file its data begin.
struct VtuArray {
  std::string name;
  NumberType type = NumberType::float64;
  std::size_t components = 1;
  DataCoding coding = DataCoding::raw;
  std::size_t begin = 0;
  std::size_t end = 0;  ///< of data inside the element; of appended data the end of the file
};

struct VtuLayout {
  std::size_t points = 0;
  std::size_t cells = 0;
  std::size_t headerBytes = 4;  ///< of a number in the header of an array
  Compressor compressor = Compressor::none;
  VtuArray coordinates, connectivity, offsets, types;
  std::vector<VtuArray> pointData, cellData;
};

/// The layout of a file of one piece, little endian, without ghosts, time steps and arrays that are not numeric, its
/// numbers plain or compressed by zlib or LZ4: what nearly all .vtu files are. Nothing for any other file, broken ones
/// included. Source: "VTK XML Formats", Kitware, and vtkXMLUnstructuredGridWriter.
std::optional<VtuLayout> vtuLayout(const FileBlocks& file);

}  // namespace havs
