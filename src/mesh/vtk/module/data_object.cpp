#include "mesh/vtk/module/data_object.h"

#include <vtkAlgorithm.h>
#include <vtkCGNSReader.h>
#include <vtkExodusIIReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockPLOT3DReader.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace havs {
namespace {

using Output = vtkSmartPointer<vtkDataObject>;

/// Updates the reader to the last of its time steps, if it has any.
Output lastStep(vtkAlgorithm* reader, GridSink& sink) {
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const int steps = information && information->Has(key) ? information->Length(key) : 0;
  if (steps > 0) {
    const double last = information->Get(key)[steps - 1];
    reader->UpdateTimeStep(last);
    std::ostringstream text;
    text << "read time step " << steps << " of " << steps << " (time " << last << ")";
    if (steps > 1) sink.note(text.str());
  } else {
    reader->Update();
  }
  return reader->GetOutputDataObject(0);
}

Output readLegacy(const GridRequest& request, GridSink& sink) {
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(request.file.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return lastStep(reader, sink);
}

Output readXml(const GridRequest& request, GridSink& sink) {
  vtkNew<vtkXMLGenericDataObjectReader> reader;
  reader->SetFileName(request.file.c_str());
  return lastStep(reader, sink);
}

/// Points as the file gives them: displacements are a field like others.
Output readExodus(const GridRequest& request, GridSink& sink) {
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(request.file.c_str());
  reader->ApplyDisplacementsOff();
  reader->UpdateInformation();
  for (const auto kind : {vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::NODAL}) reader->SetAllArrayStatus(kind, 1);
  for (int block = 0; block < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++block)
    reader->SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, block, 1);
  return lastStep(reader, sink);
}

Output readEnSight(const GridRequest& request, GridSink& sink) {
  vtkNew<vtkGenericEnSightReader> reader;
  reader->SetCaseFileName(request.file.c_str());
  reader->ReadAllVariablesOn();
  return lastStep(reader, sink);
}

Output readCgns(const GridRequest& request, GridSink& sink) {
  vtkNew<vtkCGNSReader> reader;
  reader->SetFileName(request.file.c_str());
  reader->UpdateInformation();
  reader->EnableAllBases();
  reader->EnableAllFamilies();
  reader->EnableAllPointArrays();
  reader->EnableAllCellArrays();
  return lastStep(reader, sink);
}

/// The q file's own fields, and the two that people look at first.
Output readPlot3d(const GridRequest& request, GridSink& sink) {
  constexpr int kPressure = 110;
  constexpr int kVelocity = 200;
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName(request.file.c_str());
  reader->AutoDetectFormatOn();
  reader->RemoveAllFunctions();
  if (!request.solution.empty()) {
    reader->SetQFileName(request.solution.c_str());
    reader->AddFunction(kPressure);
    reader->AddFunction(kVelocity);
  }
  return lastStep(reader, sink);
}

struct VtkFormat {
  const char* extension;
  Output (*read)(const GridRequest&, GridSink&);
};

constexpr VtkFormat kFormats[] = {
    {".vtk", readLegacy}, {".vtu", readXml},      {".pvtu", readXml},   {".vti", readXml},
    {".vts", readXml},    {".vtr", readXml},      {".ex2", readExodus}, {".exo", readExodus},
    {".e", readExodus},   {".case", readEnSight}, {".cgns", readCgns},
};

}  // namespace

vtkSmartPointer<vtkDataObject> readDataObject(const GridRequest& request, GridSink& sink) {
  if (request.plot3d) return readPlot3d(request, sink);
  std::string extension = std::filesystem::path(request.file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto format = std::ranges::find(kFormats, extension, &VtkFormat::extension);
  if (format == std::end(kFormats)) throw std::runtime_error("VTK has no reader for " + extension);
  return format->read(request, sink);
}

}  // namespace havs
