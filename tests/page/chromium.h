#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace havs::test {

/// A window to be opened.
struct Window {
  int width = 1000, height = 900;
  bool phone = false, dark = false;
};

/// A headless Chromium of its own, cut off from the network and driven through the DevTools protocol, which it speaks
/// on a pipe. One page at a time. Everything throws std::runtime_error when Chromium ends, is silent for a minute or
/// refuses.
class Chromium {
 public:
  Chromium();
  ~Chromium();
  Chromium(const Chromium&) = delete;
  Chromium& operator=(const Chromium&) = delete;

  /// Whether the program is on the PATH.
  static bool isInstalled();

  /// Opens a study's page from disk and waits until it says that it is ready.
  void open(const std::filesystem::path& file, const Window& window = {});
  /// The value of a JavaScript expression, a promise's once it is kept.
  nlohmann::json evaluate(const std::string& expression);
  /// Waits until the expression is true.
  void waitFor(const std::string& expression);
  void movePointer(double x, double y);
  void click(double x, double y);
  void pressKey(const std::string& key);

  /// Addresses that were asked for, by all pages opened; without what the page's own rule (CSP) stopped.
  std::vector<std::string> requests() const;
  const std::vector<std::string>& complaints() const { return complaints_; }  ///< errors and warnings of the console

 private:
  nlohmann::json command(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  nlohmann::json readMessage();
  void note(const nlohmann::json& event);
  void mouse(const char* type, double x, double y, int buttons);

  TemporaryFolder profile_;
  pid_t pid_ = -1;
  int toChromium_ = -1, fromChromium_ = -1;
  int commands_ = 0;
  std::string session_, unread_;
  std::map<std::string, std::string> requests_;  // by Chromium's name of the request
  std::vector<std::string> complaints_;
};

}  // namespace havs::test
