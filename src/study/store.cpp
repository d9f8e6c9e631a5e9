#include "study/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "core/error.h"
#include "core/stopping.h"
#include "study/records_json.h"
#include "transfer/json_text.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTryRestart = "--restart begins anew";

/// Kinds of lines by the key that names them: a new one is one row.
using Reader = std::function<void(StudyRecords&, const Json&)>;
const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> table{
      {"subject", [](StudyRecords& r, const Json& j) { r.subjects.push_back(subjectFrom(j)); }},
      {"reference", [](StudyRecords& r, const Json& j) { r.references.push_back(referenceFrom(j)); }},
      {"visit", [](StudyRecords& r, const Json& j) { r.visits.push_back(visitFrom(j)); }},
      {"device", [](StudyRecords& r, const Json& j) { r.device = deviceFrom(j); }},
  };
  return table;
}

std::string nowUtc() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

[[noreturn]] void failOpening(const fs::path& path) {
  failInput(std::string("cannot write there: ") + std::strerror(errno), path.string(), "choose another place");
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    failInput("cannot make the folder: " + (error ? error.message() : "something else is there"), folder.string(),
              "choose another place");
}

void checkIdentity(const StudyIdentity& stored, const StudyIdentity& wanted, const fs::path& folder) {
  for (const auto& [key, value] : wanted) {
    const auto found = stored.find(key);
    if (found == stored.end() || found->second != value)
      failInput(fmt::format("a study with another {} was begun there ({}; now: {})", key,
                            found == stored.end() ? "none" : found->second, value),
                folder.string(), fmt::format("choose another folder; {}", kTryRestart));
  }
}

/// A process that was killed may hold its lock for a moment more, until its memory is freed.
bool lock(int descriptor) {
  constexpr int kTries = 30;
  for (int i = 0; i < kTries; ++i) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

/// The records of the whole lines; returns how many bytes they take.
std::size_t readLines(const std::string& content, const fs::path& file, const StudyIdentity& identity,
                      StudyRecords& records) {
  std::size_t begin = 0, number = 1;
  for (std::size_t end; (end = content.find('\n', begin)) != std::string::npos; begin = end + 1, ++number) {
    try {
      const Json json = parsedOrDiscarded<Json>(std::string_view(content).substr(begin, end - begin));
      if (!json.is_object() || json.size() != 1) throw std::invalid_argument("one object with one name");
      if (number == 1) {
        records.created = json.at("study").at("created");
        checkIdentity(json.at("study").at("identity").get<StudyIdentity>(), identity, file.parent_path());
      } else {
        readers().at(json.begin().key())(records, json.begin().value());
      }
    } catch (const Error&) {
      throw;
    } catch (const std::exception&) {
      failInput("the line cannot be read", fmt::format("{}:{}", file.string(), number), kTryRestart);
    }
  }
  return begin;
}

}  // namespace

StudyStore::StudyStore(const fs::path& folder, const StudyIdentity& identity, bool restart)
    : file_(folder / "runs.jsonl") {
  makeFolder(folder);
  descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) failOpening(file_);
  if (!lock(descriptor_)) {
    close(descriptor_);
    failInput("another study is running there", folder.string(), "wait for it, or choose another folder");
  }
  try {
    std::ifstream stream(file_, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::size_t whole = restart ? 0 : readLines(content, file_, identity, records_);
    if (ftruncate(descriptor_, static_cast<off_t>(whole)) != 0) failOpening(file_);
    if (whole == 0) begin(identity);
    makeFolder(folder / "images");
    tellKept();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

StudyStore::~StudyStore() { close(descriptor_); }

void StudyStore::begin(const StudyIdentity& identity) {
  records_.created = nowUtc();
  append(textOf({{"study", {{"version", 1}, {"created", records_.created}, {"identity", identity}}}}));
}

void StudyStore::tellKept() const {
  noteKept(fmt::format("{} drawings are kept in {}: the same command (without --restart) goes on from there",
                       records_.visits.size(), file_.string()));
}

void StudyStore::append(const std::string& line) {
  const std::string text = line + "\n";
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      failRunning(std::string("writing failed: ") + std::strerror(errno), file_.string(), "is the disk full?");
    written += static_cast<std::size_t>(count);
  }
  if (fdatasync(descriptor_) != 0)
    failRunning(std::string("writing failed: ") + std::strerror(errno), file_.string(), "is the disk full?");
}

void StudyStore::add(const SubjectRecord& record) {
  records_.subjects.push_back(record);
  append(textOf({{"subject", toJson(record)}}));
}

void StudyStore::add(const ReferenceRecord& record) {
  records_.references.push_back(record);
  append(textOf({{"reference", toJson(record)}}));
}

void StudyStore::addIfNew(const ReferenceRecord& record) {
  for (const ReferenceRecord& one : records_.references)
    if (one.subject == record.subject && one.width == record.width && one.height == record.height) return;
  add(ReferenceRecord(record));
}

void StudyStore::add(const VisitRecord& record) {
  records_.visits.push_back(record);
  append(textOf({{"visit", toJson(record)}}));
  tellKept();
}

void StudyStore::add(const DeviceRecord& record) {
  records_.device = record;
  append(textOf({{"device", toJson(record)}}));
}

}  // namespace havs
