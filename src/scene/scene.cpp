#include "scene/scene.h"

namespace havs {

void applyPaperPreset(Scene& scene) {
  scene.visibility = "kbuffer";
  scene.sort = "centroid";
  scene.k = 6;
  scene.lookup = "3d";
  scene.tableSize = 128;
  scene.tableFormat = "rgba8";
  scene.earlyTermination = 0.99;
  scene.compositeLate = true;
}

}  // namespace havs
