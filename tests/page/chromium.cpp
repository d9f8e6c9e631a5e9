#include "page/chromium.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace havs::test {
namespace fs = std::filesystem;
using Json = nlohmann::json;
using namespace std::chrono_literals;
namespace {

constexpr int kPatienceMilliseconds = 60000;
// Where Chromium expects its pipe.
constexpr int kCommands = 3, kAnswers = 4;

[[noreturn]] void becomeChromium(int commands, int answers, const std::string& profile) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // ends with a test that crashes
  const int safeCommands = fcntl(commands, F_DUPFD, 10), safeAnswers = fcntl(answers, F_DUPFD, 10);
  dup2(safeCommands, kCommands);
  dup2(safeAnswers, kAnswers);
  const int null = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, stream);
  const std::string folder = "--user-data-dir=" + profile;
  // No sandbox: it refuses root, and containers refuse it. It reads our own file only.
  execlp("chromium", "chromium", "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu",
         "--disable-dev-shm-usage", "--no-first-run", "--disable-background-networking", "--disable-component-update",
         "--disable-extensions", "--proxy-server=127.0.0.1:9", "--host-resolver-rules=MAP * ~NOTFOUND", folder.c_str(),
         "about:blank", nullptr);
  _exit(127);
}

}  // namespace

bool Chromium::isInstalled() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/chromium").c_str(), X_OK) == 0) return true;
  return false;
}

Chromium::Chromium() {
  std::array<int, 2> commands{}, answers{};
  if (pipe2(commands.data(), O_CLOEXEC) != 0 || pipe2(answers.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe for Chromium");
  pid_ = fork();
  if (pid_ == 0) becomeChromium(commands[0], answers[1], profile_.path().string());
  close(commands[0]);
  close(answers[1]);
  toChromium_ = commands[1];
  fromChromium_ = answers[0];
  signal(SIGPIPE, SIG_IGN);
  const std::string target = command("Target.createTarget", {{"url", "about:blank"}})["targetId"];
  session_ = command("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Network", "Log"}) command(std::string(domain) + ".enable");
}

Chromium::~Chromium() {
  try {
    command("Browser.close");
  } catch (const std::exception&) {  // it is gone already
  }
  close(toChromium_);
  close(fromChromium_);
  for (int wait = 0; wait < 100; ++wait) {
    if (waitpid(pid_, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(50ms);
  }
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

Json Chromium::readMessage() {
  std::size_t end = 0;
  while ((end = unread_.find('\0')) == std::string::npos) {
    pollfd ready{fromChromium_, POLLIN, 0};
    if (poll(&ready, 1, kPatienceMilliseconds) <= 0) throw std::runtime_error("Chromium is silent");
    std::array<char, 65536> buffer;
    const ssize_t count = read(fromChromium_, buffer.data(), buffer.size());
    if (count <= 0) throw std::runtime_error("Chromium has ended");
    unread_.append(buffer.data(), static_cast<std::size_t>(count));
  }
  Json message = Json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

void Chromium::note(const Json& event) {
  const std::string method = event.value("method", "");
  if (method == "Network.requestWillBeSent")
    requests_[event["params"]["requestId"]] = event["params"]["request"]["url"];
  if (method == "Network.loadingFailed" && event["params"].value("blockedReason", "") == "csp")
    requests_.erase(event["params"]["requestId"].get<std::string>());
  if (method == "Runtime.exceptionThrown" || method == "Runtime.consoleAPICalled" || method == "Log.entryAdded")
    complaints_.push_back(event["params"].dump());
}

std::vector<std::string> Chromium::requests() const {
  std::vector<std::string> urls;
  for (const auto& [id, url] : requests_) urls.push_back(url);
  return urls;
}

Json Chromium::command(const std::string& method, const Json& parameters) {
  Json message{{"id", ++commands_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = write(toChromium_, text.data() + sent, text.size() - sent);
    if (count <= 0) throw std::runtime_error("Chromium has ended");
    sent += static_cast<std::size_t>(count);
  }
  for (;;) {
    const Json answer = readMessage();
    if (answer.value("id", 0) != commands_) {
      note(answer);
      continue;
    }
    if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
    return answer["result"];
  }
}

Json Chromium::evaluate(const std::string& expression) {
  const Json answer =
      command("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
  return answer["result"].value("value", Json());
}

void Chromium::waitFor(const std::string& expression) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatienceMilliseconds);
  while (std::chrono::steady_clock::now() < end) {
    if (evaluate(expression) == true) return;
    std::this_thread::sleep_for(20ms);
  }
  throw std::runtime_error("never true: " + expression);
}

void Chromium::open(const fs::path& file, const Window& window) {
  command("Emulation.setDeviceMetricsOverride",
          {{"width", window.width}, {"height", window.height}, {"deviceScaleFactor", 1}, {"mobile", window.phone}});
  command("Emulation.setEmulatedMedia",
          {{"features", {{{"name", "prefers-color-scheme"}, {"value", window.dark ? "dark" : "light"}}}}});
  command("Page.navigate", {{"url", "file://" + file.string()}});
  waitFor("location.protocol === 'file:' && document.documentElement?.dataset.ready === 'yes'");
}

void Chromium::mouse(const char* type, double x, double y, int buttons) {
  command("Input.dispatchMouseEvent",
          {{"type", type}, {"x", x}, {"y", y}, {"button", buttons ? "left" : "none"}, {"clickCount", buttons}});
}

void Chromium::movePointer(double x, double y) { mouse("mouseMoved", x, y, 0); }

void Chromium::click(double x, double y) {
  movePointer(x, y);
  mouse("mousePressed", x, y, 1);
  mouse("mouseReleased", x, y, 1);
}

void Chromium::pressKey(const std::string& key) {
  Json event{{"type", "keyDown"}, {"key", key}, {"code", key}};
  if (key == "Enter") event.update({{"text", "\r"}, {"windowsVirtualKeyCode", 13}});
  command("Input.dispatchKeyEvent", event);
  event = {{"type", "keyUp"}, {"key", key}, {"code", key}};
  command("Input.dispatchKeyEvent", event);
}

}  // namespace havs::test
