#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace havs {

/// Errors and messages of high severity that the driver has given and nobody has asked for yet.
struct DebugLog {
  std::vector<std::string> messages;
};
/// Has the current context write its messages to the log returned, which must outlive the context.
std::unique_ptr<DebugLog> startDebugLog();

/// Throws Error{running} if the current context has met an error since the last call; `doing` says what was being done
/// ("allocating texture 'k-buffer 2'"). Out of memory has a text of its own.
void checkGl(std::string_view doing);

}  // namespace havs
