#pragma once
// oneTBB's library is not instrumented, so that the thread sanitizer cannot see what it synchronises. A parallel loop
// says so: its blocks come after what was before the loop, and what follows the loop comes after its blocks. The blocks
// among each other stay unordered, so a race between two of them is found.
#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace havs {

/// Lives as long as a parallel loop. Empty unless the build is under the thread sanitizer.
class LoopOrder {
 public:
  LoopOrder() { started(); }
  ~LoopOrder() { finished(); }
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;

  /// What comes after started() on one thread may be seen by the blocks that begin later: for tasks that are added
  /// while others run. finished(): all blocks until now are over.
  void started() { release(start_); }
  void finished() { acquire(finish_); }

  /// Lives as long as a block of the loop.
  class Block {
   public:
    explicit Block(LoopOrder& loop) : loop_(loop) { loop_.acquire(loop_.start_); }
    ~Block() { loop_.release(loop_.finish_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

   private:
    LoopOrder& loop_;
  };

 private:
#ifdef __SANITIZE_THREAD__
  static void acquire(char& event) { __tsan_acquire(&event); }
  static void release(char& event) { __tsan_release(&event); }
#else
  static void acquire(char&) {}
  static void release(char&) {}
#endif

  char start_ = 0;
  char finish_ = 0;
};

}  // namespace havs
