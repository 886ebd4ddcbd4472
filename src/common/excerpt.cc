#include "common/excerpt.h"

#include <algorithm>

namespace stereo_sgmp {

std::string Excerpt(const std::string& text, std::size_t longest) {
  std::string excerpt = text.substr(0, longest);
  std::replace_if(
      excerpt.begin(), excerpt.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > longest ? excerpt + "..." : excerpt;
}

}  // namespace stereo_sgmp
