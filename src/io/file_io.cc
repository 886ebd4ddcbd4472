#include "io/file_io.h"

#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <stdexcept>

namespace stereo_sgmp {

namespace fs = std::filesystem;

std::ifstream OpenFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw std::invalid_argument(path + ": there is no such file.");
  if (fs::is_directory(status)) {
    throw std::invalid_argument(path + ": this is a folder, a file is expected.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::invalid_argument(path + ": the file can't be opened; check its permissions.");
  }
  return file;
}

std::string ReadFile(const std::string& path) {
  std::ifstream file = OpenFile(path);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw std::invalid_argument(path + ": the file can't be read to its end.");
  if (bytes.empty()) throw std::invalid_argument(path + ": the file is empty.");
  return bytes;
}

void WriteAtomically(const std::string& path,
                     const std::function<void(const std::string&)>& write) {
  const fs::path target(path);
  if (fs::exists(target) && !fs::is_regular_file(target)) {
    write(path);
    return;
  }
  fs::path temporary = target;
  temporary.replace_filename("." + target.stem().string() + ".part" + std::to_string(getpid()) +
                             target.extension().string());
  try {
    write(temporary.string());
    fs::rename(temporary, target);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

void WriteFile(const std::string& path, const std::string& bytes) {
  WriteAtomically(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      throw std::runtime_error(path + ": " + std::to_string(bytes.size()) +
                               " bytes can't be written; check permissions and free space.");
    }
  });
}

void CheckWritable(const std::string& path) {
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder)) {
    throw std::invalid_argument(path + ": its folder does not exist; create " + folder.string() +
                                " first.");
  }
  if (fs::is_directory(target)) {
    throw std::invalid_argument(path + ": this is a folder, a file name is expected.");
  }
}

}  // namespace stereo_sgmp
