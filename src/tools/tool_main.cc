#include "tools/tool_main.h"

#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {
namespace {

constexpr int kRuntimeError = 1;
constexpr int kUsageError = 2;

int Fail(const CLI::App& app, const std::string& sentence, int code) {
  std::cerr << app.get_name() << ": " << sentence << '\n';
  return code;
}

}  // namespace

int RunTool(int argc, char** argv, CLI::App* app, const std::function<void()>& body) {
  try {
    app->parse(argc, argv);
    body();
    return 0;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      return app->exit(error);  // prints the help that was asked for
    }
    return Fail(*app, std::string(error.what()) + " (--help explains)", kUsageError);
  } catch (const std::invalid_argument& error) {
    return Fail(*app, error.what(), kUsageError);
  } catch (const std::bad_alloc&) {
    return Fail(*app, "there is not enough memory.", kRuntimeError);
  } catch (const std::exception& error) {
    return Fail(*app, error.what(), kRuntimeError);
  }
}

}  // namespace stereo_sgmp
