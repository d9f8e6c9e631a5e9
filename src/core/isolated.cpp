#include "core/isolated.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <thread>
#include <utility>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/sanitized.h"

namespace havs {
namespace {

/// How the work ended, in a page that both processes see.
struct Verdict {
  enum class State { died, done, failed };
  State state;
  ErrorKind kind;
  char message[4000];
};

class SharedVerdict {
 public:
  SharedVerdict() {
    void* page = mmap(nullptr, sizeof(Verdict), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) failRunning("out of memory");
    verdict_ = new (page) Verdict{};
  }
  ~SharedVerdict() { munmap(verdict_, sizeof(Verdict)); }
  SharedVerdict(const SharedVerdict&) = delete;
  SharedVerdict& operator=(const SharedVerdict&) = delete;
  Verdict* operator->() const { return verdict_; }

  void fail(ErrorKind kind, const char* message) const {
    verdict_->kind = kind;
    std::snprintf(verdict_->message, sizeof verdict_->message, "%s", message);
    verdict_->state = Verdict::State::failed;
  }

 private:
  Verdict* verdict_;
};

int memoryFile(const char* name) {
  const int file = memfd_create(name, MFD_CLOEXEC);
  if (file < 0) failRunning(std::string("no file in memory can be had: ") + std::strerror(errno));
  return file;
}

/// `parent`: which it must not outlive.
void limitChild(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it has died before
  std::set_terminate(std::abort);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) signal(fault, SIG_DFL);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
#ifndef HAVS_SANITIZED
  const rlim_t most = memoryLimit();
  const rlimit memory{most, most};
  setrlimit(RLIMIT_DATA, &memory);
#endif
}

[[noreturn]] void runChild(const std::function<void(ByteWriter&)>& work, int reply, int printed,
                           const SharedVerdict& verdict, pid_t parent) {
  limitChild(parent);
  dup2(printed, STDOUT_FILENO);
  dup2(printed, STDERR_FILENO);
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // or what was printed before a crash would be lost
  try {
    ByteWriter writer(reply);
    work(writer);
    writer.flush();
    verdict->state = Verdict::State::done;
  } catch (const Error& error) {
    verdict.fail(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    verdict.fail(ErrorKind::running, "out of memory");
  } catch (const std::exception& error) {
    verdict.fail(ErrorKind::running, error.what());
  }
  std::fflush(nullptr);
  _exit(0);
}

int waitFor(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string describeDeath(int status) {
  if (WIFSIGNALED(status)) return strsignal(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

std::string readStart(int file) {
  std::string text(1 << 16, '\0');
  const ssize_t length = pread(file, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
  return text;
}

#ifdef HAVS_SANITIZED
bool othersSleep() {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    if (task.path().filename() == std::to_string(gettid())) continue;
    std::ifstream file(task.path() / "stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.find(") R ") != std::string::npos) return false;
  }
  return true;
}
#endif

/// The sanitizers' own allocator, that of g++ 12 at least, is forked with its locks as they are: held for ever in the
/// child, where another thread was asking for memory. glibc's is not.
void waitForOtherThreads() {
#ifdef HAVS_SANITIZED
  constexpr int kQuiet = 3, kMost = 1000;  // in a row; milliseconds
  for (int quiet = 0, tried = 0; quiet < kQuiet && tried < kMost; ++tried) {
    quiet = othersSleep() ? quiet + 1 : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
#endif
}

}  // namespace

IsolatedRun runIsolated(const std::function<void(ByteWriter&)>& work) {
  const SharedVerdict verdict;
  ByteReader reply(memoryFile("havs-reply"));
  const ByteReader printed(memoryFile("havs-printed"));
  std::fflush(nullptr);  // or the child would print it again
  waitForOtherThreads();
  const pid_t parent = getpid(), child = fork();
  if (child < 0) failRunning(std::string("no process can be started: ") + std::strerror(errno));
  if (child == 0) runChild(work, reply.file(), printed.file(), verdict, parent);
  const int status = waitFor(child);

  if (verdict->state == Verdict::State::failed) throw Error(verdict->kind, verdict->message);
  const std::string death = verdict->state == Verdict::State::done ? std::string() : describeDeath(status);
  reply.rewind();
  return {std::move(reply), death, readStart(printed.file())};
}

void ByteWriter::put(const std::string& text) {
  put(text.size());
  write(std::as_bytes(std::span(text)));
}

void ByteWriter::write(std::span<const std::byte> bytes) {
  if (buffer_.size() + bytes.size() > kBufferBytes) flush();
  if (bytes.size() <= kBufferBytes) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return;
  }
  writeThrough(bytes);
}

void ByteWriter::flush() {
  writeThrough(buffer_);
  buffer_.clear();
}

void ByteWriter::writeThrough(std::span<const std::byte> bytes) const {
  needMemory(static_cast<double>(bytes.size()), "what a child process hands back");
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) failRunning("out of memory");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

ByteReader::ByteReader(int file) : file_(file) {}

ByteReader::ByteReader(ByteReader&& other) noexcept
    : file_(std::exchange(other.file_, -1)), position_(other.position_), size_(other.size_) {}

ByteReader::~ByteReader() {
  if (file_ >= 0) close(file_);
}

void ByteReader::rewind() {
  struct stat status {};
  fstat(file_, &status);
  size_ = static_cast<std::size_t>(status.st_size);
  position_ = 0;
}

std::string ByteReader::getString() {
  std::string text(checkedCount(get<std::size_t>(), 1), '\0');
  read(std::as_writable_bytes(std::span(text)));
  return text;
}

void ByteReader::read(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t length = pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(position_));
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) failRunning("a child process handed back less than it announced");
    position_ += static_cast<std::size_t>(length);
    bytes = bytes.subspan(static_cast<std::size_t>(length));
  }
}

std::size_t ByteReader::checkedCount(std::size_t count, std::size_t bytesEach) const {
  if (count > (size_ - position_) / bytesEach) failRunning("a child process handed back less than it announced");
  needMemory(static_cast<double>(count) * static_cast<double>(bytesEach), "what a child process read");
  return count;
}

}  // namespace havs
