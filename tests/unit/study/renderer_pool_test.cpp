#include "study/renderer_pool.h"

#include <gtest/gtest.h>

namespace havs {
namespace {

class NoRenderer final : public Renderer {
  Drawing draw(const View&, StageTimes&, const Progress&) override { return {}; }
};

TEST(RendererPool, KeepsWhatFitsAndFindsIt) {
  RendererPool pool(100);
  auto renderer = std::make_unique<NoRenderer>();
  const Renderer* const address = renderer.get();
  pool.offer("a", std::move(renderer), 60, 1);
  EXPECT_EQ(pool.find("a"), address);
  EXPECT_EQ(pool.find("b"), nullptr);
  EXPECT_EQ(pool.bytes(), 60u);
}

TEST(RendererPool, StaysWithinItsBound) {
  RendererPool pool(100);
  for (int i = 0; i < 20; ++i) {
    pool.offer(std::to_string(i), std::make_unique<NoRenderer>(), static_cast<std::size_t>(7 * i % 40), 20 - i);
    EXPECT_LE(pool.bytes(), 100u);
  }
  pool.offer("large", std::make_unique<NoRenderer>(), 101, 1e9);
  EXPECT_EQ(pool.find("large"), nullptr);
}

/// A table that takes long is worth more than targets that are made at once.
TEST(RendererPool, LetsGoWhatIsMadeQuickly) {
  RendererPool pool(100);
  pool.offer("quick", std::make_unique<NoRenderer>(), 50, 1);
  pool.offer("slow", std::make_unique<NoRenderer>(), 50, 1000);
  pool.offer("middle", std::make_unique<NoRenderer>(), 50, 30);
  EXPECT_EQ(pool.find("quick"), nullptr);
  EXPECT_NE(pool.find("slow"), nullptr);
  EXPECT_NE(pool.find("middle"), nullptr);
  pool.offer("quick", std::make_unique<NoRenderer>(), 50, 1);
  EXPECT_EQ(pool.find("quick"), nullptr);
}

}  // namespace
}  // namespace havs
