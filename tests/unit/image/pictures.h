#pragma once
// Made pictures for the tests of measures.
#include <functional>
#include <random>

#include "image/image.h"

namespace havs::test {

/// value(x, y, channel) everywhere.
inline Image madeImage(int width, int height, const std::function<double(int x, int y, int c)>& value) {
  Image image{width, height,
              std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) image.pixel(x, y)[c] = static_cast<float>(value(x, y, c));
  return image;
}

inline Image constantImage(int width, int height, double value) {
  return madeImage(width, height, [=](int, int, int) { return value; });
}

inline Image noise(int width, int height, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  return madeImage(width, height, [&](int, int, int) { return uniform(generator); });
}

/// The same, each value off by up to `amplitude`.
inline Image disturbed(Image image, double amplitude, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (float& value : image.rgba) value += static_cast<float>(amplitude) * uniform(generator);
  return image;
}

}  // namespace havs::test
