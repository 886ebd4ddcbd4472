// Cost volumes. The first byte tells the formats; a line of text is the file beside the volume;
// what follows is the volume.
#include "io/cost_volume_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/expectations.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

// A file that is rewritten in every run: faster than a new one each time. TMPDIR says where;
// /dev/shm is memory.
class RewrittenFile {
 public:
  explicit RewrittenFile(const std::string& path)
      : path_(path), descriptor_(open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600)) {
    Expect(descriptor_ >= 0, "a temporary file");
  }
  ~RewrittenFile() { close(descriptor_); }
  RewrittenFile(const RewrittenFile&) = delete;
  RewrittenFile& operator=(const RewrittenFile&) = delete;

  void Write(const std::string& bytes) const {
    const auto size = static_cast<ssize_t>(bytes.size());
    const bool written = ftruncate(descriptor_, size) == 0 &&
                         pwrite(descriptor_, bytes.data(), bytes.size(), 0) == size;
    Expect(written, "room for a temporary file");
  }

  const std::string& path() const { return path_; }

 private:
  const std::string path_;
  const int descriptor_;
};

// A volume and the text file that stands beside it.
struct Files {
  Files(const std::string& path, const std::string& extension)
      : volume(path), text(path + extension) {}

  RewrittenFile volume;
  RewrittenFile text;
};

const Files& FilesOf(std::uint8_t format) {
  static const TemporaryFolder folder;
  static const std::array<Files, 3> files = {{{folder.Path("a.bin"), ".dim"},
                                              {folder.Path("b.bin"), ".shape"},
                                              {folder.Path("c.acrt"), ".shape"}}};
  return files[format % files.size()];
}

void ReadVolume(const Files& files, const std::string& text, const std::string& bytes) {
  files.text.Write(text);
  files.volume.Write(bytes);
  const std::string& path = files.volume.path();
  std::optional<CostVolume> volume;
  if (!Reads([&] { volume = ReadCostVolumeShape(path); })) return;
  Expect(volume.has_value(), "the shape, which is there");
  if (!Reads([&] { ReadCosts(path, &*volume); })) return;
  Expect(volume->costs.size() * sizeof(float) == bytes.size(), "a cost for each float");
}

}  // namespace
}  // namespace stereo_sgmp

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::size_t line = rest.find('\n');
  if (line == std::string::npos) return 0;
  stereo_sgmp::ReadVolume(stereo_sgmp::FilesOf(data[0]), rest.substr(0, line),
                          rest.substr(line + 1));
  return 0;
}
