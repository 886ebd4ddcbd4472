#ifndef STEREO_SGMP_TOOLS_TOOL_MAIN_H_
#define STEREO_SGMP_TOOLS_TOOL_MAIN_H_

#include <functional>

#include <CLI/CLI.hpp>

namespace stereo_sgmp {

// Parses the command line and calls `body`. Returns the exit code of the process: 0; 2 when the
// command line or an input is wrong (CLI::ParseError, std::invalid_argument); 1 when something
// else fails. What went wrong stands in one sentence on stderr.
int RunTool(int argc, char** argv, CLI::App* app, const std::function<void()>& body);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_TOOL_MAIN_H_
