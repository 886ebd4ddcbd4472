#include "tools/progress_line.h"

#include <unistd.h>

#include <iostream>

namespace stereo_sgmp {
namespace {

bool IsTerminal() { return isatty(STDERR_FILENO) != 0; }

// Returns to the start of the line and clears it.
constexpr char kClearLine[] = "\r\x1B[K";

}  // namespace

void ProgressLine::Next(const std::string& name) {
  constexpr std::size_t kBarWidth = 30;
  const std::size_t filled = kBarWidth * begun_ / steps_;
  ++begun_;
  const std::string count = std::to_string(begun_) + "/" + std::to_string(steps_) + " " + name;
  if (IsTerminal()) {
    std::cerr << kClearLine << '[' << std::string(filled, '#')
              << std::string(kBarWidth - filled, ' ') << "] " << count << std::flush;
  } else {
    std::cerr << count << '\n';
  }
}

void ProgressLine::Finish() const {
  if (IsTerminal()) std::cerr << kClearLine << std::flush;
}

}  // namespace stereo_sgmp
