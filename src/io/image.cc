#include "io/image.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "io/file_io.h"

namespace stereo_sgmp {
namespace {

bool StartsWith(const std::string& bytes, const std::string& prefix) {
  return bytes.compare(0, prefix.size(), prefix) == 0;
}

// The next number of a PNM header, from `at` on, which moves behind it. Whatever else stands before
// it is left out, as decoders do.
std::uint64_t NextNumber(const std::string& bytes, std::size_t* at) {
  constexpr std::uint64_t kMost = 1U << 31;
  const auto is_digit = [&](std::size_t i) { return bytes[i] >= '0' && bytes[i] <= '9'; };
  while (*at < bytes.size() && !is_digit(*at)) {
    *at = bytes[*at] == '#' ? std::min(bytes.find('\n', *at), bytes.size()) : *at + 1;
  }
  std::uint64_t number = 0;
  for (; *at < bytes.size() && is_digit(*at); ++*at) {
    number = std::min(10 * number + static_cast<std::uint64_t>(bytes[*at] - '0'), kMost);
  }
  return number;
}

// Whether a PNM has less than a bit (P4) or a byte for each of the pixels that its header claims,
// for which decoders would make room.
bool IsShortPnm(const std::string& bytes) {
  std::size_t at = 2;
  const std::uint64_t width = NextNumber(bytes, &at);
  const std::uint64_t height = NextNumber(bytes, &at);
  const std::uint64_t least = bytes[1] == '4' ? width * height / 8 : width * height;
  return bytes.size() < least;
}

bool IsPnm(const std::string& bytes) {
  return bytes.size() > 1 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6';
}

// Decoders fill the missing part of a truncated file with gray, or complain on their own, so it
// is recognised by the end mark that its format prescribes, or by its size.
bool IsTruncated(const std::string& bytes) {
  if (IsPnm(bytes)) return IsShortPnm(bytes);
  if (StartsWith(bytes, "\x89PNG")) return bytes.rfind("IEND") == std::string::npos;
  if (StartsWith(bytes, "\xFF\xD8")) {
    const std::size_t end = bytes.rfind("\xFF\xD9");
    const std::size_t scan = bytes.rfind("\xFF\xDA");  // a thumbnail ends before the last scan
    return end == std::string::npos || scan == std::string::npos || end < scan;
  }
  return false;
}

// Whether the file begins as one of the formats that are read. OpenCV would try many more, some
// with decoders that end the process or make room for whatever size a header claims.
bool IsKnownFormat(const std::string& bytes) {
  using std::string_literals::operator""s;
  for (const std::string& prefix : {"\x89PNG"s, "\xFF\xD8"s, "BM"s, "II*\0"s, "MM\0*"s}) {
    if (StartsWith(bytes, prefix)) return true;
  }
  if (StartsWith(bytes, "RIFF")) return bytes.size() > 12 && bytes.compare(8, 4, "WEBP") == 0;
  return IsPnm(bytes);
}

cv::Mat Decode(const std::string& bytes, const std::string& path) {
  const std::vector<unsigned char> buffer(bytes.begin(), bytes.end());
  try {
    return cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw std::invalid_argument(path + ": the picture can't be decoded (" + error.err + ").");
  }
}

std::string Describe(const cv::Mat& image) {
  return std::to_string(image.cols) + " x " + std::to_string(image.rows) + " pixels of " +
         std::to_string(image.channels()) + " x " + std::to_string(8 * image.elemSize1()) + " bit";
}

}  // namespace

cv::Mat DecodeImage(const std::string& bytes, const std::string& name) {
  if (IsTruncated(bytes)) {
    throw std::invalid_argument(name + ": the picture is truncated after " +
                                std::to_string(bytes.size()) + " bytes.");
  }
  cv::Mat image = IsKnownFormat(bytes) ? Decode(bytes, name) : cv::Mat();
  if (image.empty()) {
    throw std::invalid_argument(name +
                                ": this is not a picture that can be read (PNG, JPEG, PNM, " +
                                "TIFF, BMP and WebP are expected).");
  }
  const bool known_depth = image.depth() == CV_8U || image.depth() == CV_16U;
  if (!known_depth || image.channels() == 2) {
    throw std::invalid_argument(name + ": " + Describe(image) +
                                " found, 8 or 16 bit gray, BGR or BGRA expected.");
  }
  return image;
}

cv::Mat LoadImage(const std::string& path) { return DecodeImage(ReadFile(path), path); }

void CheckPair(const cv::Mat& left, const std::string& left_name, const cv::Mat& right,
               const std::string& right_name) {
  if (left.size() == right.size() && left.type() == right.type()) return;
  throw std::invalid_argument("The images of a pair must have one size and type, but " + left_name +
                              " has " + Describe(left) + " and " + right_name + " has " +
                              Describe(right) + ".");
}

cv::Mat To8Bit(const cv::Mat& image) {
  constexpr double kScale = 1.0 / 257.0;  // 65535 becomes 255
  cv::Mat converted;
  image.convertTo(converted, CV_8U, image.depth() == CV_16U ? kScale : 1.0);
  return converted;
}

void CheckImageName(const std::string& path) {
  if (cv::haveImageWriter(path)) return;
  throw std::invalid_argument(path + ": no picture format has the extension \"" +
                              std::filesystem::path(path).extension().string() +
                              "\"; take .png, for example.");
}

void SaveImage(const std::string& path, const cv::Mat& image) {
  CheckImageName(path);
  WriteAtomically(path, [&](const std::string& temporary) {
    if (!cv::imwrite(temporary, image)) {
      throw std::runtime_error(path + ": the picture can't be written; check permissions and " +
                               "free space.");
    }
  });
}

}  // namespace stereo_sgmp
