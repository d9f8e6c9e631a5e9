#pragma once
// What a renderer asks of OpenGL, counted where its functions are loaded: glad's pointers are exchanged for functions
// that count and call on. The program itself knows nothing of it.
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace havs::test {

/// Objects by their labels, with the bytes that were taken for them.
using LabelledBytes = std::map<std::string, std::size_t>;

/// What has been called since the last start.
struct GlCalls {
  std::multiset<std::string> programs;       ///< linked, by their labels
  std::size_t shaders = 0;                   ///< compiled
  std::multiset<std::string> textures;       ///< for which memory was taken, or that lie over a buffer
  std::multiset<std::string> buffers;        ///< for which memory was taken
  LabelledBytes bytes;                       ///< of both
  std::multiset<std::string> uploads;        ///< written to from the program's memory
  std::map<std::string, std::size_t> draws;  ///< by the label of the program drawn with
  /// Calls that take or fill memory in other ways, or run other programs, than the ones above: to be empty.
  std::multiset<std::string> others;

  /// Nothing compiled, taken or written.
  bool madeNothing() const;
};

/// Counts while it lives. A device must be current, and remain so; one at a time.
class GlCallCounter {
 public:
  GlCallCounter();
  ~GlCallCounter();
  GlCallCounter(const GlCallCounter&) = delete;
  GlCallCounter& operator=(const GlCallCounter&) = delete;

  /// What was called since it was made, or since the last call of this.
  GlCalls take();
};

}  // namespace havs::test
