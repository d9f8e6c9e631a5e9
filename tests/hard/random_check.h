#pragma once
// What must be true of every random case, and a count of what was looked at.
#include <map>
#include <string>

#include "hard/hard_case.h"
#include "hard/random_case.h"
#include "support/temporary_folder.h"

namespace havs::test {

/// What a run looked at.
struct RandomTally {
  std::size_t cases = 0, refused = 0, openGl = 0, monotone = 0;
  std::size_t pixels = 0;                       ///< of the native device, compared with the truth
  std::size_t late = 0;                         ///< left out
  std::size_t hard = 0;                         ///< beyond HardBounds::native, within what float may do to the ray
  double native = 0;                            ///< largest error of the pixels that are not hard
  std::size_t glPixels = 0;                     ///< of OpenGL, compared with the truth outside the edge mask
  std::size_t glTraced = 0;                     ///< beyond HardBounds::traced, each traced to the rasteriser
  std::size_t glCoarse = 0;                     ///< beyond HardBounds::p999
  std::map<std::string, std::size_t> refusals;  ///< by message, without its numbers
};

/// Draws cases and judges them.
class CaseChecker {
 public:
  /// "", or what is wrong: its kind, a colon, and details. A scene that is refused as wrong input is not wrong.
  /// `openGl`: one of OpenGL's ways (hardWays()) besides; null: none.
  std::string failureOf(const RandomCase& c, const HardWay* openGl);
  const RandomTally& tally() const { return tally_; }

 private:
  std::string drawn(const RandomCase& c, const HardWay* openGl);
  std::string judgeNative(const HardPicture& picture, const HardWay& way, const havs::Drawing& drawing,
                          bool overlaps);
  std::string judgeOpenGl(const HardPicture& picture, const HardWay& way, bool overlaps);
  std::string judgeFewerCells(const RandomCase& c, const HardPicture& picture);

  TemporaryFolder folder_;
  RandomTally tally_;
};

/// The kind of a failure: what stands before the colon.
std::string kindOf(const std::string& failure);

}  // namespace havs::test
