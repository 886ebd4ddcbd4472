#ifndef STEREO_SGMP_COMMON_EXCERPT_H_
#define STEREO_SGMP_COMMON_EXCERPT_H_

#include <cstddef>
#include <string>

namespace stereo_sgmp {

// Text from outside, fit for a message: its first `longest` characters, with "..." where there
// are more, and "?" for each that can't be printed.
std::string Excerpt(const std::string& text, std::size_t longest = 60);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_EXCERPT_H_
