#include "tools/run_tool.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

std::string Content(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

ToolRun RunProgram(const std::string& program, const std::string& arguments) {
  const TemporaryFolder folder;
  const std::string command =
      "'" + program + "' " + arguments + " >" + folder.Path("out") + " 2>" + folder.Path("err");
  // A shell of its own reports a signal as 128 + its number.
  const int status = std::system(command.c_str());
  ToolRun run;
  if (WIFEXITED(status) && WEXITSTATUS(status) < 128) run.exit_code = WEXITSTATUS(status);
  run.out = Content(folder.Path("out"));
  run.err = Content(folder.Path("err"));
  return run;
}

}  // namespace stereo_sgmp
