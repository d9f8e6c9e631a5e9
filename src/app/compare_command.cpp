// havs compare: how far a picture is from another that is taken as true.
#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <span>

#include "app/commands.h"
#include "app/compare_report.h"
#include "app/print_json.h"
#include "app/read_options.h"
#include "app/table_names.h"
#include "core/error.h"
#include "core/find_row.h"
#include "image/comparable.h"
#include "image/difference_picture.h"
#include "image/mask.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

struct CompareOptions {
  std::filesystem::path picture, truth, mask, difference;
  std::string scale = "log", channel = "worst";
  std::optional<double> max;
  std::vector<std::string> limits;
  bool json = false;
  bool quiet = false;
};

/// One row a measure that --limit takes.
struct Measure {
  std::string name;
  double ErrorMeasures::*value;
  bool greaterIsBetter;
};
const std::array<Measure, 5> kMeasures{{
    {"rmse", &ErrorMeasures::rmse, false},
    {"p999", &ErrorMeasures::p999, false},
    {"max", &ErrorMeasures::max, false},
    {"psnr", &ErrorMeasures::psnr, true},
    {"ssim", &ErrorMeasures::ssim, true},
}};

struct Limit {
  const Measure* measure;
  double value;
};

Limit parseLimit(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    failInput(fmt::format("'{}' is not a limit", text), "--limit", "write MEASURE=VALUE, such as max=0.001");
  const Measure& measure = findRow(std::span<const Measure>(kMeasures), text.substr(0, equals), "measure", "--limit");
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + equals + 1, last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value))
    failInput(fmt::format("'{}' is not a number", text.substr(equals + 1)), "--limit");
  return {&measure, value};
}

/// SSIM that is not a number (nothing was measured) is beyond every limit.
bool isMet(const Limit& limit, const ErrorMeasures& measures) {
  const double value = measures.*limit.measure->value;
  return limit.measure->greaterIsBetter ? value >= limit.value : value <= limit.value;
}

void failBeyond(const Limit& limit, const CompareOptions& options, const ErrorMeasures& measures) {
  const double value = measures.*limit.measure->value;
  failRunning(fmt::format("{} is {:.6g}, {} the limit {:g}", limit.measure->name, value,
                          limit.measure->greaterIsBetter ? "below" : "above", limit.value),
              options.picture.string());
}

std::vector<unsigned char> readMaskFor(const std::filesystem::path& file, const Image& picture) {
  int width = 0, height = 0;
  auto mask = readMask(file, width, height);
  if (width != picture.width || height != picture.height)
    failInput(fmt::format("the mask has {} x {} pixels, the pictures have {} x {}", width, height, picture.width,
                          picture.height),
              file.string(), "make it with the same --size");
  return mask;
}

/// Throws Error{input} for names and numbers that are none.
DifferenceStyle styleOf(const CompareOptions& options) {
  DifferenceStyle style{.colors = presetColors("inferno"), .max = options.max};
  if (options.scale != "log" && options.scale != "linear")
    failInput(fmt::format("unknown scale '{}'", options.scale), "--scale", "use log or linear");
  style.logarithmic = options.scale == "log";
  if (options.max && !(*options.max > 0 && std::isfinite(*options.max)))
    failInput("must be a finite number above 0", "--max");
  if (options.channel == "worst") return style;
  for (std::size_t c = 0; c < kChannelNames.size(); ++c)
    if (options.channel == kChannelNames[c]) style.channel = c;
  if (!style.channel)
    failInput(fmt::format("unknown channel '{}'", options.channel), "--channel",
              "use worst, red, green, blue or opacity");
  return style;
}

NamedPicture readPicture(const std::filesystem::path& file) {
  NamedPicture picture{file.string(), readStoredImage(file)};
  requireFinite(picture.stored.image, picture.name);
  return picture;
}

CompareReport compareFiles(const CompareOptions& options, DifferenceStyle style) {
  const NamedPicture picture = readPicture(options.picture), truth = readPicture(options.truth);
  const Image& a = picture.stored.image;
  const Image& b = truth.stored.image;
  requireSameSize(a, b);
  const ImageContent content = commonContent(picture, truth);
  std::vector<unsigned char> mask;
  if (!options.mask.empty()) mask = readMaskFor(options.mask, b);

  CompareReport report{.picture = options.picture, .truth = options.truth, .width = b.width, .height = b.height};
  report.notes = comparisonNotes(picture, truth);
  report.comparison = compareImages(a, b, mask, content);
  if (!mask.empty()) report.withMasked = compareImages(a, b, {}, content);
  if (!options.difference.empty()) {
    style.channels = report.comparison.channelCount;
    if (style.channel.value_or(0) >= style.channels)
      failInput("the pictures have no opacity: they lie over a background", "--channel");
    const DifferencePicture shown = differencePicture(a, b, mask, style);
    writeImage(shown.image, options.difference);
    report.difference = options.difference;
    report.differenceAxis = shown.scale.axis;
  }
  return report;
}

void compare(const CompareOptions& options) {
  std::vector<Limit> limits;
  for (const std::string& text : options.limits) limits.push_back(parseLimit(text));
  const DifferenceStyle style = styleOf(options);
  if (!options.difference.empty()) checkImagePath(options.difference);
  const CompareReport report = compareFiles(options, style);
  if (options.json)
    printJson(reportAsJson(report));
  else if (!options.quiet)
    fmt::print("{}", reportAsText(report));
  for (const Limit& limit : limits)
    if (!isMet(limit, report.comparison.rgba)) failBeyond(limit, options, report.comparison.rgba);
}

}  // namespace

void addCompareCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("compare", "How far a picture is from another that is taken as true");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("A", options->picture, "The picture: .png, .exr or .pfm")->required()->type_name("FILE");
  command->add_option("B", options->truth, "The truth, of the same size and content")->required()->type_name("FILE");
  command->add_option("--mask", options->mask, "Leave out the pixels that are white (red above 0.5) in this picture")
      ->type_name("FILE");
  const std::string group = "Difference picture";
  command->add_option("--difference", options->difference, "Write the error of each pixel, with a colour bar")
      ->type_name("FILE")
      ->group(group);
  command->add_option("--scale", options->scale, "log (default) or linear")->type_name("NAME")->group(group);
  command->add_option("--max", options->max, "Error at the top of the scale (default: the greatest)")
      ->type_name("VALUE")
      ->group(group);
  command
      ->add_option("--channel", options->channel, "Show the error of red, green, blue or opacity (default: the worst)")
      ->type_name("NAME")
      ->group(group);
  command
      ->add_option("--limit", options->limits,
                   "Exit with status 1 when rmse, p999 or max is above VALUE, psnr or ssim below; may be given several "
                   "times")
      ->type_name("MEASURE=VALUE")
      ->take_all()
      ->expected(1);
  addMaxMemoryOption(*command);
  command->add_flag("--json", options->json, "Report as JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors (and what --json asks for)");
  command->callback([options] { compare(*options); });
}

}  // namespace havs
