#ifndef STEREO_SGMP_TOOLS_RUN_TOOL_H_
#define STEREO_SGMP_TOOLS_RUN_TOOL_H_

#include <string>

namespace stereo_sgmp {

struct ToolRun {
  int exit_code = -1;  // -1: ended by a signal
  std::string out;     // stdout
  std::string err;     // stderr
};

// Runs a program with these arguments, which the shell splits at spaces.
ToolRun RunProgram(const std::string& program, const std::string& arguments);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_RUN_TOOL_H_
