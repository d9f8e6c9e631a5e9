#include "app/compare_report.h"

#include <fmt/format.h>

#include <cmath>

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

Json finiteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }

void addMeasures(const ErrorMeasures& measures, Json& json) {
  json["rmse"] = measures.rmse;
  json["p999"] = measures.p999;
  json["max"] = measures.max;
  json["psnr"] = finiteOrNull(measures.psnr);
  json["ssim"] = finiteOrNull(measures.ssim);
}

void addComparison(const Comparison& comparison, Json& json) {
  addMeasures(comparison.rgba, json);
  for (std::size_t c = 0; c < comparison.channelCount; ++c)
    addMeasures(comparison.channels[c], json["channels"][kChannelNames[c]]);
  json["pixels"] = comparison.pixels;
  json["masked"] = comparison.masked;
  json["worst"] = {
      {"x", comparison.worstX}, {"y", comparison.worstY}, {"channel", kChannelNames[comparison.worstChannel]}};
}

std::string nameOf(ImageContent content) { return content == ImageContent::rgba ? "rgba" : "rgb"; }

}  // namespace

Json reportAsJson(const CompareReport& report) {
  Json json;
  json["picture"] = report.picture.string();
  json["truth"] = report.truth.string();
  json["size"] = {report.width, report.height};
  json["content"] = nameOf(report.comparison.content);
  addComparison(report.comparison, json);
  if (report.withMasked) addComparison(*report.withMasked, json["with_masked_pixels"]);
  if (!report.difference.empty())
    json["difference"] = {{"file", report.difference.string()},
                          {"scale", report.differenceAxis.logarithmic ? "log" : "linear"},
                          {"range", {report.differenceAxis.low, report.differenceAxis.high}}};
  json["notes"] = report.notes;
  return json;
}

namespace {

void addRow(const std::string& name, const ErrorMeasures& measures, std::string& text) {
  text += fmt::format("{:<9}{:>11.3e}{:>11.3e}{:>11.3e}{:>10.2f}{:>11.7f}\n", name, measures.rmse, measures.p999,
                      measures.max, measures.psnr, measures.ssim);
}

void addTable(const Comparison& comparison, std::string& text) {
  text += fmt::format("{:<9}{:>11}{:>11}{:>11}{:>10}{:>11}\n", "", "rmse", "p999", "max", "psnr", "ssim");
  addRow(nameOf(comparison.content), comparison.rgba, text);
  for (std::size_t c = 0; c < comparison.channelCount; ++c) addRow(kChannelNames[c], comparison.channels[c], text);
}

std::string worstText(const Comparison& comparison) {
  return fmt::format("pixel {},{} in {}", comparison.worstX, comparison.worstY, kChannelNames[comparison.worstChannel]);
}

}  // namespace

std::string reportAsText(const CompareReport& report) {
  std::string text;
  auto line = [&](const char* label, const std::string& content) { text += fmt::format("{:<9}{}\n", label, content); };
  const Comparison& comparison = report.comparison;
  line("picture", report.picture.string());
  line("truth", report.truth.string());
  line("pixels", fmt::format("{} x {}; {} compared", report.width, report.height, comparison.pixels) +
                     (comparison.masked > 0 ? fmt::format(", {} masked", comparison.masked) : ""));
  addTable(comparison, text);
  line("worst", worstText(comparison));
  if (report.withMasked) {
    text += "with the masked pixels\n";
    addRow(nameOf(report.withMasked->content), report.withMasked->rgba, text);
    line("worst", worstText(*report.withMasked));
  }
  for (const std::string& note : report.notes) line("note", note);
  if (!report.difference.empty())
    line("shown in", fmt::format("{}: {} scale from {:.3g} to {:.3g}", report.difference.string(),
                                 report.differenceAxis.logarithmic ? "logarithmic" : "linear",
                                 report.differenceAxis.low, report.differenceAxis.high));
  return text;
}

}  // namespace havs
