#ifndef STEREO_SGMP_TOOLS_PROGRESS_LINE_H_
#define STEREO_SGMP_TOOLS_PROGRESS_LINE_H_

#include <cstddef>
#include <string>

namespace stereo_sgmp {

// Shows on stderr how far a tool is: a bar that moves on a terminal, a line per step elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(std::size_t steps) : steps_(steps) {}

  // Says that the next step, of this name, begins.
  void Next(const std::string& name);

  // Ends the bar.
  void Finish() const;

 private:
  std::size_t steps_;
  std::size_t begun_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_PROGRESS_LINE_H_
