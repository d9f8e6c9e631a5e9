#include "app/render_report.h"

#include <fmt/format.h>

#include "app/mesh_report.h"
#include "app/overlay_options.h"
#include "app/plan_report.h"
#include "core/memory.h"
#include "render/certificate_picture.h"
#include "render/k_search.h"
#include "render/lookups.h"
#include "render/order_advice.h"
#include "render/plan.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

std::string nameOf(OpacityMeaning meaning) { return meaning == OpacityMeaning::perUnit ? "per_unit" : "extinction"; }

/// What one frame costs once mesh and table stand.
double frameMilliseconds(const StageTimes& stages) {
  double sum = 0;
  for (const char* stage : {"order", "upload", "draw", "flush", "layers", "outline"}) sum += stages.median(stage);
  return sum;
}

/// Every stage of a frame, 0 for one that this drawing did without, and whatever else was timed; of the reference, what
/// was timed.
Json stagesAsJson(const RenderReport& report) {
  Json json;
  if (!report.reference)
    for (const char* stage : {"read", "faces", "order", "upload", "table", "draw", "flush", "readback", "total"})
      json[stage] = report.stages.median(stage);
  for (const auto& [stage, milliseconds] : report.stages.medians()) json[stage] = milliseconds;
  return json;
}

/// As scene files have them, each with its colour.
Json isosurfacesAsJson(const RenderReport& report) {
  Json json = Json::array();
  for (const ShownIsosurface& s : report.isosurfaces)
    json.push_back({{"value", s.value}, {"color", s.color}, {"opacity", s.opacity}});
  return json;
}

/// As scene files have it.
Json backgroundAsJson(const std::optional<Background>& background) {
  if (!background) return nullptr;
  if (!background->isGradient()) return background->bottom;
  return {{"bottom", background->bottom}, {"top", background->top}};
}

/// As scene files have it.
void addClipping(const Scene& scene, Json& json) {
  json["clip_plane"] = json["clip_box"] = json["cut_box"] = Json::array();
  for (const auto& [p, n] : scene.clipPlanes) json["clip_plane"].push_back({p.x, p.y, p.z, n.x, n.y, n.z});
  for (const auto& [low, high, keepsInside] : scene.clipBoxes)
    json[keepsInside ? "clip_box" : "cut_box"].push_back({low.x, high.x, low.y, high.y, low.z, high.z});
  json["threshold"] = scene.threshold ? Json(*scene.threshold) : Json();
}

/// Light, as scene files have it; null for what the scene does without.
void addLight(const Scene& scene, Json& json) {
  json["lighting"] = json["occlusion"] = json["scattering"] = Json();
  if (const auto& l = scene.lighting)
    json["lighting"] = {{"ambient", l->ambient},
                        {"diffuse", l->diffuse},
                        {"specular", l->specular},
                        {"shininess", l->shininess},
                        {"silhouettes", l->silhouettes}};
  json["lights"] = scene.lights.size();
  json["shadows"] = scene.shadows;
  if (scene.occlusion)
    json["occlusion"] = {{"radius", scene.occlusion->radius}, {"directions", scene.occlusion->directions}};
  if (const auto& s = scene.scattering)
    json["scattering"] = {{"albedo", s->albedo}, {"anisotropy", s->anisotropy}, {"radius", s->radius}};
  json["modulation"] = scene.modulation;
}

Json settingsAsJson(const Scene& scene, const RenderReport& report) {
  Json json;
  json["transfer_function"] = {{"name", report.transferFunction},
                               {"opacity", nameOf(report.meaning)},
                               {"unit_length", report.unitLength},
                               {"domain", report.domain}};
  json["isosurfaces"] = isosurfacesAsJson(report);
  json["outline"] = overlayAsJson(scene.overlays.outline);
  json["surface"] = overlayAsJson(scene.overlays.surface);
  json["wireframe"] = overlayAsJson(scene.overlays.wireFrame);
  addClipping(scene, json);
  addLight(scene, json);
  json["camera"] = Json::parse(report.camera);
  json["size"] = {scene.width, scene.height};
  json["background"] = backgroundAsJson(scene.background);
  json["mode"] = scene.mode;
  const bool ordered = mode(scene.mode).gathering == Gathering::composite;
  json["visibility"] = ordered ? Json(scene.visibility) : Json();
  const VisibilityMethod& method = visibilityMethod(scene.visibility);
  json["k"] = ordered && method.maximumK > 0 ? Json(report.k) : Json();
  json["k_auto"] = wantsKSearch(scene);
  json["sort"] = ordered && method.needsOrder ? Json(scene.sort) : Json();
  json["lookup"] = usesLookup(mode(scene.mode)) && !report.reference ? Json(report.lookup) : Json();
  json["table"] = report.tableSize > 0 ? Json(report.tableSize) : Json();
  json["table_format"] = scene.tableFormat;
  json["target_format"] = scene.targetFormat;
  json["early_termination"] = scene.earlyTermination;
  json["composite_late"] = scene.compositeLate;
  json["threads"] = scene.threads;
  json["repeat"] = scene.repeat;
  return json;
}

/// Without the method's, which the reference does not heed.
Json settingsOfReference(const Json& all) {
  Json json;
  for (const char* key :
       {"transfer_function", "isosurfaces", "outline",  "surface",    "wireframe", "clip_plane", "clip_box",
        "cut_box",           "threshold",   "lighting", "lights",     "shadows",   "occlusion",  "scattering",
        "modulation",        "camera",      "size",     "background", "mode",      "threads",    "repeat"})
    json[key] = all[key];
  return json;
}

Json deviceAsJson(const Scene& scene, const RenderReport& report) {
  if (report.reference) return {{"name", "reference"}, {"tiles", report.tiles}};
  return {{"name", scene.device},
          {"renderer", report.renderer},
          {"version", report.glVersion},
          {"ordering", report.ordering},
          {"bytes_per_pixel", report.bytesPerPixel},
          {"target_bytes", report.targetBytes},
          {"fragments", report.fragments},
          {"fragment_bytes", report.fragmentBytes},
          {"tiles", report.tiles}};
}

Json certificateAsJson(const Certificate& certificate) {
  return {{"misordered", certificate.misordered},
          {"pixels", certificate.pixels},
          {"most_of_a_pixel", mostMisordered(certificate)},
          {"fragments", certificate.fragments}};
}

}  // namespace

Json reportAsJson(const Scene& scene, const RenderReport& report, const std::vector<std::filesystem::path>& outputs) {
  Json json;
  json["mesh"] = {{"file", scene.mesh.string()},
                  {"points", report.points},
                  {"cells", report.cells},
                  {"faces", report.faces},
                  {"boundary_faces", report.boundaryFaces},
                  {"drawn_cells", report.drawnCells}};
  json["field"] = {{"name", report.field}, {"centering", report.centering}, {"range", report.fieldRange}};
  json["settings"] = settingsAsJson(scene, report);
  if (report.reference) json["settings"] = settingsOfReference(json["settings"]);
  json["device"] = deviceAsJson(scene, report);
  if (!report.reference) json["cycles"] = report.cycles;
  if (report.certificate) json["certificate"] = certificateAsJson(*report.certificate);
  json["stages_ms"] = stagesAsJson(report);
  json["frame_ms"] = frameMilliseconds(report.stages);
  if (!report.reference) json["ledger"] = ledgerAsJson(report.plan, report.stages);
  json["cpu_ms"] = report.cpuMilliseconds;
  json["peak_memory_bytes"] = peakMemoryBytes();
  json["defects"] = defectsAsJson(report.defects);
  json["notes"] = report.notes;
  json["outputs"] = Json::array();
  for (const auto& output : outputs) json["outputs"].push_back(output.string());
  return json;
}

namespace {

std::string describeTransfer(const RenderReport& report) {
  const char* meaning = report.meaning == OpacityMeaning::perUnit ? "opacity is that of a slab {:.6g} mesh units thick"
                                                                  : "extinction is opacity / {:.6g} mesh units";
  return fmt::format("{} over {:.6g} to {:.6g}; ", report.transferFunction, report.domain[0], report.domain[1]) +
         fmt::format(fmt::runtime(meaning), report.unitLength);
}

std::string describeIsosurfaces(const RenderReport& report) {
  std::string text;
  for (const ShownIsosurface& s : report.isosurfaces)
    text += fmt::format("{}{:.6g}{}", text.empty() ? "" : ", ", s.value,
                        s.opacity < 1 ? fmt::format(" (opacity {:.6g})", s.opacity) : "");
  return text;
}

std::string describeMethod(const Scene& scene, const RenderReport& report) {
  const Mode& shown = mode(scene.mode);
  if (report.reference)
    return fmt::format("{}by the reference: every cell of every ray, exactly in double",
                       usesLookup(shown) ? "" : shown.name + " ");
  if (shown.gathering != Gathering::composite)
    return fmt::format("{}, in any order, on {} ({})", shown.name, scene.device, report.renderer);
  const LookupResource* made = usesLookup(shown) ? tableOf(lookup(report.lookup)) : nullptr;
  const std::string table = made ? fmt::format(" ({}^{}, {})", report.tableSize, made->axes, scene.tableFormat) : "";
  const VisibilityMethod& method = visibilityMethod(scene.visibility);
  const std::string k =
      method.maximumK > 0 ? fmt::format(" of {}{}", report.k, wantsKSearch(scene) ? " (searched for)" : "") : "";
  const std::string targets = scene.targetFormat == Scene{}.targetFormat ? "" : ", targets " + scene.targetFormat;
  const std::string sort = method.needsOrder ? fmt::format(", {} order", scene.sort) : "";
  const std::string kept =
      report.fragments > 0 ? fmt::format(", {} fragments in {} tiles", report.fragments, report.tiles) : "";
  const std::string found = usesLookup(shown) ? fmt::format(", lookup {}{}", report.lookup, table) : "";
  return fmt::format("{}{}{}{}{}{}, on {} ({})", scene.visibility, k, sort, kept, found, targets, scene.device,
                     report.renderer);
}

std::string describeOrder(const Scene& scene, const RenderReport& report) {
  const Certificate& certificate = *report.certificate;
  if (certificate.misordered == 0) return fmt::format("exact (0 of {} fragments misordered)", certificate.fragments);
  const std::string advice = orderAdvice(scene, report.k);
  return fmt::format("wrong in {} pixels ({} of {} fragments misordered, up to {} in a pixel){}", certificate.pixels,
                     certificate.misordered, certificate.fragments, mostMisordered(certificate),
                     advice.empty() ? "" : "; try " + advice);
}

std::string describeTime(const StageTimes& stages) {
  std::string text = fmt::format("{:.0f} ms in all", stages.median("total"));
  for (const auto& [stage, milliseconds] : stages.medians())
    if (stage != "total") text += fmt::format(", {} {:.0f}", stage, milliseconds);
  return text;
}

}  // namespace

std::string reportAsText(const Scene& scene, const RenderReport& report,
                         const std::vector<std::filesystem::path>& outputs) {
  std::string text;
  auto line = [&](const char* label, const std::string& content) { text += fmt::format("{:<9}{}\n", label, content); };
  const std::string drawn =
      report.drawnCells < report.cells ? fmt::format("; {} tetrahedra show anything", report.drawnCells) : "";
  line("mesh", fmt::format("{}: {} points, {} tetrahedra, {} faces{}", scene.mesh.filename().string(), report.points,
                           report.cells, report.faces, drawn));
  line("field", fmt::format("{} ({} data), {:.6g} to {:.6g}", report.field, report.centering, report.fieldRange[0],
                            report.fieldRange[1]));
  line("transfer", describeTransfer(report));
  if (!report.isosurfaces.empty()) line("surfaces", describeIsosurfaces(report));
  line("method", describeMethod(scene, report));
  if (report.certificate) line("order", describeOrder(scene, report));
  line("time", describeTime(report.stages));
  line("memory", fmt::format("{:.0f} MB at most", static_cast<double>(peakMemoryBytes()) / 1e6));
  for (const std::string& note : report.notes) line("note", note);
  for (const auto& output : outputs) line("picture", output.string());
  if (outputs.empty()) line("picture", "not written: -o FILE names where to");
  return text;
}

}  // namespace havs
