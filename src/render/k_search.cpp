// The smallest k that mends a picture's order, by drawing it with a certificate.
//
// Why halving the interval is right. A buffer of k entries holds the k farthest fragments that have come: what leaves
// is the nearest, and a late fragment, which is nearer than all of them, never stays. So the distance below which the
// next fragment is late, that of the k-th farthest so far, falls as k grows, and a picture without a late fragment at k
// has none at k + 1 either (tests/gl/certificate_test.cpp: NeverGrowsWithK).
//
// Early termination breaks this: with a larger k segments are drawn later, so a pixel looks at more fragments before it
// is done, late ones perhaps. Then every k is tried, from 1 on.
#include "render/k_search.h"

#include <memory>

#include "render/changes_k.h"
#include "render/make_renderer.h"

namespace havs {
namespace {

/// Where a fragment comes does not depend on how a segment is coloured: no table is built for the search, unless pixels
/// are done by their opacity. What fragments carry stays, as targets and tiles depend on it.
Scene sceneForSearch(const Scene& scene) {
  Scene search = scene;
  search.certificate = true;
  search.kAuto = false;
  search.overlays = {};
  if (scene.earlyTermination == 0 && lookupOf(scene).carries == Payload::scalar) search.lookup = "post";
  return search;
}

}  // namespace

bool wantsKSearch(const Scene& scene) {
  return scene.kAuto && mode(scene.mode).gathering == Gathering::composite &&
         visibilityMethod(scene.visibility).maximumK > 0;
}

int searchK(const Scene& scene, const PreparedScene& prepared, const View& view, const Capabilities& capabilities,
            const Progress& progress) {
  Scene search = sceneForSearch(scene);
  StageTimes ignored;
  std::unique_ptr<Renderer> renderer;
  auto isExact = [&](int k) {
    search.k = k;
    const RenderPlan chosen = plan(search, prepared.facts(), capabilities);
    if (auto* same = dynamic_cast<ChangesK*>(renderer.get())) {
      same->changeK(chosen);
    } else {
      renderer.reset();  // its memory first
      renderer = makeRenderer(prepared, chosen, ignored, progress);
    }
    return renderer->draw(view, ignored).certificate->misordered == 0;
  };
  int least = 1, most = largestK(search, capabilities);
  const int tries = most;
  while (least < most) {
    if (progress) progress("searching k", 1.0 - static_cast<double>(most - least) / tries);
    const int k = scene.earlyTermination > 0 ? least : (least + most) / 2;
    if (isExact(k)) {
      most = k;
    } else {
      least = k + 1;
    }
  }
  if (progress) progress("searching k", 1.0);
  return least;
}

}  // namespace havs
