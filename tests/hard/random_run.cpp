#include "hard/random_run.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "core/parallel.h"
#include "hard/random_scenes.h"
#include "hard/random_shrink.h"
#include "mesh/overlaps.h"

namespace havs::test {
namespace {

template <class Number>
void readInto(Number& number, const char* name) {
  if (const char* text = std::getenv(name)) number = static_cast<Number>(std::strtod(text, nullptr));
}

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One of OpenGL's ways, all in turn; most cases have none.
const HardWay* openGlWay(const RandomRun& run, std::size_t number) {
  static const std::vector<HardWay> ways = [] {
    std::vector<HardWay> rows;
    for (const HardWay& way : hardWays())
      if (way.group != "native") rows.push_back(way);
    return rows;
  }();
  if (run.openGl == 0 || number % run.openGl != 0) return nullptr;
  return &ways[number / run.openGl % ways.size()];
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

/// Shrinks a case, and says where it is.
void report(const RandomRun& run, const FoundFailure& found, const RandomCase& c, const HardWay* way) {
  const std::filesystem::path folder =
      std::filesystem::path(HAVS_BUILD) / "random-failures" / fmt::format("{}-{}", run.seed, found.number);
  writeCase(c, folder / "as-found");
  CaseChecker others;
  const std::string kind = kindOf(found.failure);
  RandomCase small = shrunk(c, [&](const RandomCase& next) {  // fewer digits may make cells overlap: no truth is known
    return (next.overlaps || overlappingCells(next.mesh).count == 0) && kindOf(others.failureOf(next, way)) == kind;
  });
  small.story = others.failureOf(small, way);
  writeCase(small, folder);
  print(
      fmt::format("FOUND: seed {}, case {}: {}\n  shrunk to {} cells: {}\n"
                  "  havs render {}/scene.json -o picture.png; havs reference the same\n"
                  "  to keep it: move the folder to tests/hard/found\n",
                  run.seed, found.number, found.failure, small.mesh.tetrahedra.size(), small.story, folder.string()));
}

}  // namespace

RandomRun asAskedFor(RandomRun run) {
  readInto(run.seed, "HAVS_RANDOM_SEED");
  readInto(run.first, "HAVS_RANDOM_FIRST");
  readInto(run.cases, "HAVS_RANDOM_CASES");
  readInto(run.seconds, "HAVS_RANDOM_SECONDS");
  return run;
}

std::vector<FoundFailure> runRandom(const RandomRun& run, CaseChecker& checker) {
  const ThreadLimit oneThread(1);  // pictures are small
  constexpr std::size_t kShown = 3, kNews = 10000;
  std::vector<FoundFailure> failures;
  std::map<std::string, std::size_t> kinds;
  const double begin = processorSeconds();
  const auto goesOn = [&](std::size_t done) {
    return run.seconds > 0 ? processorSeconds() - begin < run.seconds : done < run.cases;
  };
  for (std::size_t done = 0; goesOn(done); ++done) {
    const std::size_t number = run.first + done;
    Dice dice(run.seed, number);
    const RandomCase c = randomCase(dice);
    const HardWay* way = openGlWay(run, number);
    const std::string failure = checker.failureOf(c, way);
    if ((done + 1) % kNews == 0)
      print(fmt::format("{} cases, {:.0f} s, {} failures\n", done + 1, processorSeconds() - begin, failures.size()));
    if (failure.empty()) continue;
    failures.push_back({number, failure});
    if (++kinds[kindOf(failure)] <= kShown) report(run, failures.back(), c, way);
  }
  for (const auto& [kind, count] : kinds) print(fmt::format("{} x {}\n", count, kind));
  return failures;
}

std::string summaryOf(const RandomTally& t) {
  std::string text = fmt::format(
      "{} cases, of which {} were refused\n"
      "native: {} pixels against the truth, within {:.2g}; {} beyond the bound, within what float may do to the ray; "
      "{} late, left out\n"
      "OpenGL: {} pictures; {} pixels against the truth, {} beyond {:.0e}, {} beyond {:.0e} and traced\n"
      "fewer cells, no more opacity: {} times\n",
      t.cases, t.refused, t.pixels, t.native, t.hard, t.late, t.openGl, t.glPixels, t.glCoarse, HardBounds{}.p999,
      t.glTraced, HardBounds{}.traced, t.monotone);
  for (const auto& [message, count] : t.refusals) text += fmt::format("  refused {} times: {}\n", count, message);
  return text;
}

}  // namespace havs::test
