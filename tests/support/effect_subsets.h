#pragma once
// Scenes with every subset of the rows of effects() up to pairs, for tests that iterate the table.
#include <string>
#include <vector>

#include "render/effects.h"

namespace havs::test {

/// Has the scene ask for a row, where it does not yet (some imply others).
inline void ask(Scene& scene, const Effect& effect, const EffectData& data = {}) {
  if (!effect.wanted(scene)) effect.add(scene, data);
}

using EffectSubset = std::vector<const Effect*>;

/// None, each alone, each pair once.
inline std::vector<EffectSubset> subsetsUpToPairs() {
  std::vector<EffectSubset> subsets{{}};
  const auto rows = effects();
  for (const Effect& a : rows) subsets.push_back({&a});
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i + 1; j < rows.size(); ++j) subsets.push_back({&rows[i], &rows[j]});
  return subsets;
}

inline std::string nameOf(const EffectSubset& subset) {
  std::string name;
  for (const Effect* effect : subset) name += (name.empty() ? "" : " and ") + effect->name;
  return name.empty() ? "no effect" : name;
}

inline Scene with(Scene scene, const EffectSubset& subset, const EffectData& data = {}) {
  for (const Effect* effect : subset) ask(scene, *effect, data);
  return scene;
}

}  // namespace havs::test
