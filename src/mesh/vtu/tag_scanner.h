#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/file_blocks.h"

namespace havs {

/// A tag of an XML file.
struct Tag {
  std::string name;  ///< "/Piece" for an end
  std::map<std::string, std::string> attributes;
  bool empty = false;     ///< <a/>
  std::size_t begin = 0;  ///< of its '<' in the file
  std::size_t end = 0;    ///< behind its '>'
  /// The attribute, or `otherwise`.
  std::string attribute(const std::string& key, const std::string& otherwise = "") const;
};

/// Goes from tag to tag of an XML file, whatever the size of the text between them. No entities, no DTD, no CDATA.
class TagScanner {
 public:
  explicit TagScanner(const FileBlocks& file) : file_(file) {}
  /// The next tag; comments and <?...?> are passed over. Nothing at the end of the file and for what it does not know.
  std::optional<Tag> next();
  /// The character at a place of the file, 0 behind its end.
  char at(std::size_t place);

 private:
  bool fill(std::size_t place);
  std::optional<std::size_t> find(char wanted, std::size_t from);
  std::optional<std::size_t> endOfTag(std::size_t from);

  const FileBlocks& file_;
  std::vector<char> window_;
  std::size_t windowBegin_ = 0;
  std::size_t at_ = 0;
};

}  // namespace havs
