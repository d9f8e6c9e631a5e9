#include "core/error.h"

namespace havs {
namespace {
std::string joined(const std::string& what, const std::string& where, const std::string& tryThis) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!tryThis.empty()) text += "; " + tryThis;
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t')
      c = ' ';
    else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '?';
  return text;
}
}  // namespace

Error::Error(ErrorKind kind, const std::string& what, const std::string& where, const std::string& tryThis)
    : std::runtime_error(joined(what, where, tryThis)), kind_(kind) {}

void failInput(const std::string& what, const std::string& where, const std::string& tryThis) {
  throw Error(ErrorKind::input, what, where, tryThis);
}
void failRunning(const std::string& what, const std::string& where, const std::string& tryThis) {
  throw Error(ErrorKind::running, what, where, tryThis);
}

}  // namespace havs
