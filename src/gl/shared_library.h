#pragma once
#include <span>
#include <string>

namespace havs {

/// A library opened while running. Its symbols stay its own (libOSMesa and libGL define the same ones). Never closed
/// again: drivers leave threads and thread-local data behind.
class SharedLibrary {
 public:
  /// Opens the first of `names` that can be had. Throws Error{running} with the linker's words and `tryThis`.
  SharedLibrary(std::span<const char* const> names, const std::string& tryThis);

  /// The function of this name; `F` is its type. Throws Error{running} where the library has none.
  template <class F>
  F* function(const char* name) const {
    return reinterpret_cast<F*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  std::string name_;
  void* handle_ = nullptr;
};

}  // namespace havs
