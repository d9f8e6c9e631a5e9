#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scene/prepared_scene.h"
#include "study/records.h"

namespace havs {

/// The ground truth at one size.
struct Truth {
  Image image;
  std::vector<unsigned char> mask;  ///< boundaryEdgeMask
};

/// The ground truths of one mesh seen by one camera, each drawn when first asked for.
class Truths {
 public:
  /// Pictures go to images/ in `folder`, unless it is empty. `prepared` must outlive it.
  Truths(std::string subject, const PreparedScene& prepared, std::filesystem::path folder)
      : subject_(std::move(subject)), prepared_(prepared), folder_(std::move(folder)) {}

  /// Of the scene's camera and size. Throws Error{running}.
  const Truth& of(const Scene& scene);
  /// Those drawn so far, in that order.
  const std::vector<ReferenceRecord>& records() const { return records_; }

 private:
  std::string subject_;
  const PreparedScene& prepared_;
  std::filesystem::path folder_;
  std::map<std::pair<int, int>, Truth> truths_;
  std::vector<ReferenceRecord> records_;
};

}  // namespace havs
