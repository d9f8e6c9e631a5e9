// Effects of the made study: one added, one left out, one that failed. Their pictures are those of other runs.
#include <algorithm>

#include "page/study_fixture.h"

namespace havs::test {
namespace {

using Json = nlohmann::json;

const Json& runOf(const Json& runs, const std::string& id) {
  return *std::find_if(runs.begin(), runs.end(), [&](const Json& run) { return run["id"] == id; });
}

Json spread(double median) { return {{"median", median}, {"least", 0.9 * median}, {"most", 1.2 * median}}; }

Json effect(const Json& runs, const std::string& subject, const std::string& name, bool adds, double ratio) {
  const Json& baseline = runOf(runs, subject + "/baseline");
  const double time = baseline["frame_wall_ms"]["median"];
  Json one = runOf(runs, subject + "/k=1");
  for (const char* key : {"axis", "value", "on_front"}) one.erase(key);
  one["kind"] = "effect";
  one["id"] = subject + (adds ? "/with " : "/without ") + name;
  one["label"] = (adds ? "with " : "without ") + name;
  one["effect"] = name;
  one["description"] = "what " + name + " does";
  one["adds"] = adds;
  one["also"] = Json::array();
  one["settings"] = baseline["settings"];
  one["frame_wall_ms"] = spread(adds ? time * ratio : time / ratio);
  one["wall_ratio"] = spread(ratio);
  one["cpu_ratio"] = spread(1.1 * ratio);
  one["prepare_ms"] = 60.0;
  one["bytes"] = 3 << 20;
  one["reference"] = runOf(runs, subject + "/paper")["image"];
  one["ledger"] = {
      {{"stage", "upload_mesh"},
       {"ms", 1.25},
       {"bytes", 2048},
       {"items", {{{"kind", "vertex data"}, {"name", "place <and> scalar"}, {"bytes", 2048}}}}},
      {{"stage", "draw"}, {"ms", 40.5}, {"bytes", 0}, {"items", {{{"kind", "pass"}, {"name", "draw"}, {"bytes", 0}}}}}};
  one["baseline"] = {
      {"id", baseline["id"]}, {"frame_wall_ms", spread(time)}, {"frame_cpu_ms", spread(2 * time)}, {"prepare_ms", 20.0},
      {"bytes", 1 << 20},     {"error", baseline["error"]}};
  return one;
}

}  // namespace

Json effectsFixture(const Json& runs, const std::string& subject) {
  Json effects{effect(runs, subject, "lighting", true, 2.5), effect(runs, subject, "clipping", false, 0.5)};
  effects.push_back({{"id", subject + "/with shadows"},
                     {"subject", subject},
                     {"kind", "effect"},
                     {"label", "with shadows"},
                     {"effect", "shadows"},
                     {"adds", true},
                     {"settings", Json::object()},
                     {"failed", "no memory for <shadows>"}});
  return effects;
}

}  // namespace havs::test
