#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "scene/renderer.h"

namespace havs {

/// Keeps renderers between visits within a bound of memory: those that take longest to make for the memory they hold.
class RendererPool {
 public:
  explicit RendererPool(std::size_t mostBytes) : mostBytes_(mostBytes) {}

  /// The renderer kept under this name; null: none.
  Renderer* find(const std::string& name) const;
  /// Keeps it if it fits, for which others that are worth less may have to go; else lets it go. `makeMs`: what it cost.
  void offer(const std::string& name, std::unique_ptr<Renderer> renderer, std::size_t bytes, double makeMs);
  std::size_t bytes() const { return bytes_; }

 private:
  struct Kept {
    std::unique_ptr<Renderer> renderer;
    std::size_t bytes = 0;
    double worth = 0;  ///< milliseconds a byte
  };
  bool makeRoom(std::size_t bytes, double worth);

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::map<std::string, Kept> kept_;
};

}  // namespace havs
