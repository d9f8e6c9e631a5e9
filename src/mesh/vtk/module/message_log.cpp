#include "mesh/vtk/module/message_log.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace havs {
namespace {

class CollectingWindow : public vtkOutputWindow {
 public:
  static CollectingWindow* New();
  vtkTypeMacro(CollectingWindow, vtkOutputWindow);
  CollectingWindow(const CollectingWindow&) = delete;
  void operator=(const CollectingWindow&) = delete;

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { errors.emplace_back(text); }
  void DisplayGenericWarningText(const char* text) override { warnings.emplace_back(text); }
  void DisplayWarningText(const char* text) override { warnings.emplace_back(text); }

  std::vector<std::string> errors;
  std::vector<std::string> warnings;

 protected:
  CollectingWindow() = default;
};
vtkStandardNewMacro(CollectingWindow);

CollectingWindow& window() { return *static_cast<CollectingWindow*>(vtkOutputWindow::GetInstance()); }

/// "ERROR: In vtkFoo.cxx, line 7\nvtkFoo (0x55): Cannot\n  read\n\n" becomes "Cannot read".
std::string phrase(std::string text) {
  if (const std::size_t end = text.find("): "); end != std::string::npos) text.erase(0, end + 3);
  std::string result;
  for (const char c : text) {
    const bool space = static_cast<unsigned char>(c) <= ' ';
    if (!space)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  while (!result.empty() && (result.back() == ' ' || result.back() == '.')) result.pop_back();
  constexpr std::size_t kLongest = 300;
  if (result.size() > kLongest) result = result.substr(0, kLongest) + "...";
  return result;
}

}  // namespace

MessageLog::MessageLog() { vtkOutputWindow::SetInstance(vtkSmartPointer<CollectingWindow>::New()); }
MessageLog::~MessageLog() { vtkOutputWindow::SetInstance(nullptr); }

std::string MessageLog::firstError() const { return window().errors.empty() ? "" : phrase(window().errors.front()); }

std::vector<std::string> MessageLog::warnings() const {
  std::vector<std::string> different;
  for (const std::string& text : window().warnings) {
    const std::string warning = phrase(text);
    if (std::ranges::find(different, warning) == different.end()) different.push_back(warning);
  }
  return different;
}

}  // namespace havs
