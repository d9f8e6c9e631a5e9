#include "page/study_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "image/image.h"

namespace havs::test {
namespace fs = std::filesystem;
using Json = nlohmann::json;
namespace {

constexpr int kSide = 40;

/// A round cloud; `wrong` shifts its colours.
Image cloud(double wrong, double hue) {
  Image image;
  image.width = image.height = kSide;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double r = std::hypot(x - kSide / 2.0, y - kSide / 2.0) / (kSide / 2.0);
      const double a = std::max(0.0, 1 - r * r), c = 0.5 + 0.5 * std::sin(9 * r + hue + wrong);
      for (const double value : {a * c, a * (1 - c), a * 0.6, a}) image.rgba.push_back(static_cast<float>(value));
    }
  return image;
}

struct Subject {
  std::string id, mesh;
  double cost, hue;
};

struct Maker {
  const fs::path& folder;
  Json& runs;
  const Subject& subject;

  Json settings() const {
    return {{"visibility", "kbuffer"},
            {"k", 6},
            {"sort", "topological"},
            {"lookup", "3d"},
            {"table", 128},
            {"table_format", "rgba32f"},
            {"target_format", "rgba32f"},
            {"early_termination", 0},
            {"composite_late", false},
            {"size", {512, 512}}};
  }

  static std::string label(const Json& s) {
    return fmt::format("{} k {}, {}, {} {}^3 {}", s["visibility"].get<std::string>(), s["k"].get<int>(),
                       s["sort"].get<std::string>(), s["lookup"].get<std::string>(), s["table"].get<int>(),
                       s["table_format"].get<std::string>());
  }

  /// Errors and times that behave as real ones do: sums of what each setting adds.
  double errorOf(const Json& s) const {
    const int k = s["k"], table = s["table"];
    const std::string lookup = s["lookup"], format = s["table_format"];
    if (lookup == "exact" && k == 14) return 0;
    const double order = s["sort"] == "centroid" ? 0.3 / std::pow(2.0, 1.5 * k) : 0.002 / std::pow(4.0, k);
    const double curve = lookup == "exact"  ? 2e-7
                         : lookup == "post" ? 4e-2
                                            : (lookup == "2d" ? 9.0 : 1.7) / (table * table);
    const double numbers = format == "rgba8" ? 4e-3 : format == "rgba16" ? 1.6e-5 : 0;
    return order + curve + numbers + s["early_termination"].get<double>() * 3e-3 + 1e-6;
  }
  double timeOf(const Json& s) const {
    const int k = s["k"];
    const double lookup = s["lookup"] == "exact" ? 1.9 : s["lookup"] == "post" ? 0.8 : 1;
    const double pixels = s["size"][0].get<double>() * s["size"][1].get<double>() / (512 * 512);
    return subject.cost * (1 + 0.13 * k) * lookup * std::pow(pixels, 0.7) * (s["sort"] == "centroid" ? 0.93 : 1) *
           (1 - 0.2 * s["early_termination"].get<double>());
  }

  Json& add(const std::string& name, const std::string& kind, const Json& s, const Json& axis = nullptr,
            const Json& value = nullptr) {
    const double p999 = errorOf(s), time = timeOf(s);
    const std::string id = subject.id + "/" + name, file = fmt::format("images/{}-{}", subject.id, runs.size());
    writeImage(cloud(20 * p999, subject.hue), folder / (file + ".png"));
    writeImage(cloud(3, 2), folder / (file + "-difference.png"));
    const auto errors = [](double e) {
      return Json{{"rmse", e / 7},
                  {"p999", e},
                  {"max", e * 12},
                  {"psnr", e > 0 ? Json(-20 * std::log10(e / 7)) : Json()},
                  {"ssim", 1 - e * e}};
    };
    const auto spread = [](double t) { return Json{{"median", t}, {"least", t * 0.97}, {"most", t * 1.06}}; };
    const int late = s["sort"] == "centroid" ? static_cast<int>(4000 / std::pow(2, s["k"].get<int>())) : 0;
    return runs.emplace_back(
        Json{{"id", id},
             {"subject", subject.id},
             {"kind", kind},
             {"axis", axis},
             {"value", value},
             {"label", label(s)},
             {"settings", s},
             {"error", errors(p999)},
             {"error_with_masked_pixels", errors(p999 > 0 ? p999 * 1.5 : 1e-4)},
             {"certificate", s["k"] == 1 ? Json() : Json{{"misordered", late}, {"pixels", late / 3}}},
             {"repetitions", 5},
             {"frame_wall_ms", spread(time)},
             {"frame_cpu_ms", spread(time * 1.8)},
             {"table_ms", 140.0},
             {"bytes_per_pixel", 16 + 8 * s["k"].get<int>()},
             {"image", file + ".png"},
             {"difference", file + "-difference.png"},
             {"on_front", false},
             {"failed", nullptr}});
  }

  void sweep(const std::string& axis, const std::vector<Json>& values, Json base) {
    for (const Json& value : values) {
      base[axis] = value;
      const std::string text = value.is_string()  ? value.get<std::string>()
                               : value.is_array() ? value[0].dump()
                                                  : value.dump();
      std::string place = axis + "=" + text;
      if (axis == "table") place = base["lookup"].get<std::string>() + "," + place;
      std::string name = axis;
      std::replace(name.begin(), name.end(), '_', '-');
      if (base != settings()) add(place, "axis", base, name, text);
    }
  }
};

void markFront(Json& runs, const std::string& subject) {
  for (Json& run : runs) {
    if (run["subject"] != subject || !run["failed"].is_null() || run["settings"]["size"][0] != 512) continue;
    bool beaten = false;
    for (const Json& other : runs) {
      if (other["subject"] != subject || !other["failed"].is_null() || other["settings"]["size"][0] != 512) continue;
      const double t = run["frame_wall_ms"]["median"], u = other["frame_wall_ms"]["median"], e = run["error"]["p999"],
                   f = other["error"]["p999"];
      beaten = beaten || (u <= t && f <= e && (u < t || f < e));
    }
    run["on_front"] = !beaten;
  }
}

void addRuns(const Subject& subject, const fs::path& folder, Json& runs) {
  Maker maker{folder, runs, subject};
  const Json base = maker.settings();
  maker.add("baseline", "baseline", base);
  Json paper = base;
  paper["sort"] = "centroid";
  paper["table_format"] = "rgba8";
  maker.add("paper", "paper", paper);
  maker.sweep("k", {1, 2, 3, 4, 8, 14}, base);
  maker.sweep("sort", {"centroid"}, base);
  maker.sweep("lookup", {"post", "exact"}, base);
  maker.sweep("table", {16, 32, 64}, base);
  Json flat = base;
  flat["lookup"] = "2d";
  maker.sweep("table", {16, 32, 64, 128}, flat);
  maker.sweep("table_format", {"rgba8", "rgba16"}, base);
  maker.sweep("early_termination", {0.9, 0.99}, base);
  maker.sweep("size", {Json{256, 256}, Json{1024, 1024}}, base);
  for (const int k : {2, 4, 14}) {
    Json s = base;
    s["k"] = k;
    s["lookup"] = "exact";
    maker.add(fmt::format("exact,k={}", k), "front", s);
    s["lookup"] = "3d";
    s["table"] = 32;
    if (k < 14) maker.add(fmt::format("small,k={}", k), "front", s);
  }
  Json failed = {{"id", subject.id + "/failed"},
                 {"subject", subject.id},
                 {"kind", "axis"},
                 {"axis", "k"},
                 {"value", "16"},
                 {"label", "kbuffer k 16"},
                 {"settings", base},
                 {"certificate", nullptr},
                 {"failed", "k 16 needs 9 targets, this driver has 8; use k of at most 14"}};
  failed["settings"]["k"] = 16;
  runs.push_back(failed);
  markFront(runs, subject.id);
}

Json fits(const std::string& subject) {
  Json all = Json::array();
  for (const auto& [lookup, constant] : std::map<std::string, double>{{"3d", 1.7}, {"2d", 9.0}}) {
    Json points = Json::array();
    for (const int size : {8, 16, 32, 64, 128}) points.push_back({size, constant / (size * size) + 1e-6});
    all.push_back({{"subject", subject},
                   {"axis", "table"},
                   {"lookup", lookup},
                   {"measure", "p999"},
                   {"slope", -2.0},
                   {"points", points},
                   {"used", {16, 64}}});
  }
  return all;
}

}  // namespace

Json writeStudyFixture(const fs::path& folder) {
  fs::create_directories(folder / "images");
  Json study{{"version", 1},
             {"command", "havs study bracket.vtu fin.vtu --out report"},
             {"created", "2026-11-22T18:00:00Z"},
             {"complete", true},
             {"machine",
              {{"cpu", "A processor <of> 2 cores"},
               {"cores", 2},
               {"threads", 2},
               {"memory_bytes", 8589934592},
               {"system", "Debian 12"},
               {"renderer", "llvmpipe"},
               {"gl_version", "4.5"},
               {"havs", "0.1.0"},
               {"compiler", "g++ 12"}}},
             {"subjects", Json::array()},
             {"runs", Json::array()},
             {"fits", Json::array()},
             {"skipped", {"tables of 512: 2 GiB are more than the memory left"}},
             {"effects", Json::array()}};
  const auto axis = [](const char* name, const char* title, std::vector<std::string> values, const char* baseline,
                       bool ordered) {
    return Json{{"name", name}, {"title", title}, {"values", values}, {"baseline", baseline}, {"ordered", ordered}};
  };
  study["axes"] = {
      axis("k", "Entries of the k-buffer", {"1", "2", "3", "4", "6", "8", "14", "16"}, "6", true),
      axis("sort", "Order in which faces are drawn", {"centroid", "topological"}, "topological", false),
      axis("lookup", "How a segment's colour is found", {"post", "2d", "3d", "exact"}, "3d", false),
      axis("table", "Entries along each side of the table", {"16", "32", "64", "128"}, "128", true),
      axis("table-format", "Numbers of the table", {"rgba8", "rgba16", "rgba32f"}, "rgba32f", false),
      axis("early-termination", "Opacity at which a pixel is done (0: never)", {"0", "0.9", "0.99"}, "0", true),
      axis("size", "Pixels along the longer side", {"256", "512", "1024"}, "512", true)};
  for (Json& one : study["axes"]) one["across"] = one["name"] == "table" ? Json("lookup") : Json();
  for (const Subject& subject : {Subject{"bracket-0", "bracket.vtu", 45, 0}, Subject{"fin-0", "fin.vtu", 130, 2}}) {
    const std::string reference = "images/" + subject.id + "-reference.png";
    writeImage(cloud(0, subject.hue), folder / reference);
    study["subjects"].push_back({{"id", subject.id},
                                 {"mesh", subject.mesh},
                                 {"points", 102345},
                                 {"cells", 454288},
                                 {"faces", 912345},
                                 {"field", "density"},
                                 {"transfer_function", "three-peaks"},
                                 {"camera", Json::object()},
                                 {"size", {512, 512}},
                                 {"masked_pixels", 12},
                                 {"reference", {{"image", reference}, {"wall_ms", 2345.0}, {"cpu_ms", 4567.0}}}});
    addRuns(subject, folder, study["runs"]);
    for (const Json& effect : effectsFixture(study["runs"], subject.id)) study["effects"].push_back(effect);
    for (const Json& fit : fits(subject.id)) study["fits"].push_back(fit);
  }
  std::ofstream(folder / "study.json") << study.dump(1);
  return study;
}

}  // namespace havs::test
