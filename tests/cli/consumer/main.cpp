// Draws a mesh through the installed libraries: consumer MESH PICTURE
#include <cstdio>

#include "core/error.h"
#include "image/image.h"
#include "render/render_scene.h"
#include "scene/scene.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  havs::Scene scene;
  scene.mesh = argv[1];
  scene.width = scene.height = 32;
  scene.tableSize = 16;
  const havs::RenderReport report = havs::renderScene(scene);
  havs::writeImage(report.image, argv[2]);
  std::printf("%zu tetrahedra drawn\n", report.cells);
  return 0;
} catch (const havs::Error& error) {
  std::fprintf(stderr, "consumer: %s\n", error.what());
  return error.exitStatus();
}
