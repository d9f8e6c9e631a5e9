#pragma once
#include <string>
#include <vector>

#include "image/image.h"

namespace havs {

/// A picture as read, and what messages call it.
struct NamedPicture {
  std::string name;
  StoredImage stored;
};

/// What two pictures can be compared in: rgba when both hold opacity, rgb when both are opaque pictures (a file without
/// opacity, or with opacity 1 in every pixel). Throws Error{input} when one holds opacity and the other a picture over
/// a background: the difference would be that of the background. So it does when one is opaque everywhere and the other
/// has empty pixels.
ImageContent commonContent(const NamedPicture& a, const NamedPicture& b);

/// What one should know before trusting the measures, a sentence each: values that the files have rounded; two pictures
/// that seem to lie over different backgrounds.
std::vector<std::string> comparisonNotes(const NamedPicture& a, const NamedPicture& b);

}  // namespace havs
