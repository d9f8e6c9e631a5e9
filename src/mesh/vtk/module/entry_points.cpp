// The module's two doors. What VTK reports, and any exception, becomes one phrase.
#include <exception>
#include <new>

#include "mesh/vtk/module/conversion.h"
#include "mesh/vtk/module/data_object.h"
#include "mesh/vtk/module/message_log.h"
#include "mesh/vtk/module/vtu_file.h"
#include "mesh/vtk/vtk_module.h"

namespace havs {
namespace {

/// Calls work() and returns what went wrong, empty: nothing.
template <class Work>
std::string failureOf(const Work& work) {
  try {
    const MessageLog log;
    try {
      work(log);
    } catch (const std::bad_alloc&) {
      return "more memory is needed than there is, or a count in the file is wrong";
    } catch (const std::exception& error) {
      return log.firstError().empty() ? error.what() : log.firstError();
    }
    return log.firstError();
  } catch (...) {
    return "VTK failed";
  }
}

void readGrids(const GridRequest& request, GridSink& sink, const MessageLog& log) {
  const auto data = readDataObject(request, sink);
  if (!log.firstError().empty()) return;  // what was read before the error is not to be trusted
  if (!data) throw std::runtime_error("VTK finds no data in it");
  convert(*data, sink);
  for (const std::string& warning : log.warnings()) sink.note("VTK warns: " + warning);
}

}  // namespace
}  // namespace havs

extern "C" {

__attribute__((visibility("default"))) void havsVtkReadGrids(const havs::GridRequest* request, havs::GridSink* sink) {
  const std::string failure =
      havs::failureOf([&](const havs::MessageLog& log) { havs::readGrids(*request, *sink, log); });
  if (!failure.empty()) sink->fail(failure);
}

__attribute__((visibility("default"))) void havsVtkWriteVtu(const havs::TetMesh* mesh, const char* file,
                                                            havs::WriteFailure* failure) {
  failure->what = havs::failureOf([&](const havs::MessageLog&) { havs::writeVtuFile(*mesh, file); });
}
}
