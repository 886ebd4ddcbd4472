// YAML files of options.
#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"
#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/options_yaml.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string yaml(reinterpret_cast<const char*>(data), size);
  constexpr int kUntouched = 77;
  stereo_sgmp::Options options;
  options.num_disparities = kUntouched;
  const auto load = [&] { stereo_sgmp::LoadOptionsText(yaml, "options.yaml", &options); };
  if (stereo_sgmp::Reads(load)) {
    stereo_sgmp::CheckOptions(options);
  } else {
    stereo_sgmp::Expect(options.num_disparities == kUntouched, "options left alone");
  }
  return 0;
}
