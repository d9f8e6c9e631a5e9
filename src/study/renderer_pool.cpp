#include "study/renderer_pool.h"

#include <algorithm>
#include <vector>

namespace havs {

Renderer* RendererPool::find(const std::string& name) const {
  const auto found = kept_.find(name);
  return found == kept_.end() ? nullptr : found->second.renderer.get();
}

bool RendererPool::makeRoom(std::size_t bytes, double worth) {
  if (bytes > mostBytes_) return false;
  std::vector<std::map<std::string, Kept>::iterator> cheaper;
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept)
    if (kept->second.worth < worth) cheaper.push_back(kept);
  std::sort(cheaper.begin(), cheaper.end(), [](auto a, auto b) { return a->second.worth < b->second.worth; });
  std::size_t left = bytes_, count = 0;
  while (left + bytes > mostBytes_ && count < cheaper.size()) left -= cheaper[count++]->second.bytes;
  if (left + bytes > mostBytes_) return false;
  for (std::size_t i = 0; i < count; ++i) kept_.erase(cheaper[i]);
  bytes_ = left;
  return true;
}

void RendererPool::offer(const std::string& name, std::unique_ptr<Renderer> renderer, std::size_t bytes,
                         double makeMs) {
  const double worth = makeMs / static_cast<double>(std::max<std::size_t>(1, bytes));
  if (kept_.contains(name) || !makeRoom(bytes, worth)) return;
  kept_[name] = {std::move(renderer), bytes, worth};
  bytes_ += bytes;
}

}  // namespace havs
