#pragma once
#include <glad/gl.h>

namespace havs {

/// A mark in the stream of commands.
class Fence {
 public:
  /// Behind all commands given so far, which are sent on their way.
  Fence();
  ~Fence();
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;
  /// Returns once all commands before the mark are done.
  void wait() const;

 private:
  GLsync sync_;
};

}  // namespace havs
