#include "vtk_files.h"

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace havs::bench {
namespace {

struct Encoding {
  const char* name;
  int mode, compressor;
  bool base64;
};

using Writer = vtkXMLWriter;
constexpr Encoding kEncodings[] = {
    {"raw", Writer::Appended, Writer::NONE, false},  {"base64", Writer::Appended, Writer::NONE, true},
    {"zlib", Writer::Appended, Writer::ZLIB, false}, {"base64_zlib", Writer::Appended, Writer::ZLIB, true},
    {"inline", Writer::Binary, Writer::NONE, true},  {"inline_zlib", Writer::Binary, Writer::ZLIB, true},
    {"ascii", Writer::Ascii, Writer::NONE, false},   {"lz4", Writer::Appended, Writer::LZ4, false},
};

}  // namespace

void readByVtk(const std::filesystem::path& file) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
}

void writeEncodings(const std::filesystem::path& file, const std::filesystem::path& folder) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  for (const Encoding& encoding : kEncodings) {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName((folder / (std::string(encoding.name) + ".vtu")).c_str());
    writer->SetInputData(reader->GetOutput());
    writer->SetDataMode(encoding.mode);
    writer->SetCompressorType(encoding.compressor);
    writer->SetEncodeAppendedData(encoding.base64);
    writer->Write();
  }
}

}  // namespace havs::bench
