// What every reader has to keep to, whatever it reads.
#ifndef STEREO_SGMP_FUZZ_EXPECTATIONS_H_
#define STEREO_SGMP_FUZZ_EXPECTATIONS_H_

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {

inline void Expect(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not as expected: %s\n", what);
  std::abort();
}

// A message is for a person: short, and safe to print on a terminal.
inline void ExpectReadable(const std::string& message) {
  const bool printable = std::all_of(message.begin(), message.end(), [](char c) {
    return c == '\n' || (static_cast<unsigned char>(c) >= ' ' && c != '\x7f');
  });
  const bool readable = printable && message.size() > 20 && message.size() < 1000;
  if (!readable) std::fprintf(stderr, "the message is: %s\n", message.c_str());
  Expect(readable, "a message of readable length and characters");
}

// Calls read() and says whether it succeeded. It may refuse its input by std::invalid_argument
// with a readable message; any other exception ends the program.
template <class Read>
bool Reads(const Read& read) {
  try {
    read();
    return true;
  } catch (const std::invalid_argument& error) {
    ExpectReadable(error.what());
    return false;
  }
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_FUZZ_EXPECTATIONS_H_
