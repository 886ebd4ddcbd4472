#include "io/pfm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "common/excerpt.h"
#include "io/file_io.h"

namespace stereo_sgmp {
namespace {

constexpr long kMaxSide = 1 << 16;

struct Header {
  int width = 0;
  int height = 0;
  int channels = 0;
  bool little_endian = true;
  std::size_t size = 0;  // bytes before the first sample
};

[[noreturn]] void Fail(const std::string& name, const std::string& sentence) {
  throw std::invalid_argument(name + ": " + sentence);
}

std::string Quoted(const std::string& token) { return "\"" + Excerpt(token, 12) + "\""; }

// Reads the next word of the header that starts at `position` and moves behind it.
std::string NextToken(const std::string& bytes, std::size_t* position) {
  constexpr char kSpaces[] = " \t\r\n";
  constexpr std::size_t kLongest = 64;
  const std::size_t begin = std::min(bytes.find_first_not_of(kSpaces, *position), bytes.size());
  const std::string rest = bytes.substr(begin, kLongest);
  std::string token = rest.substr(0, rest.find_first_of(kSpaces));
  *position = begin + token.size();
  return token;
}

template <class Number>
bool Parse(const std::string& token, Number* value) {
  std::istringstream stream(token);
  stream.imbue(std::locale::classic());
  return (stream >> *value) && stream.eof();
}

int ParseSide(const std::string& token, const char* what, const std::string& name) {
  long side = 0;
  if (!Parse(token, &side) || side < 1 || side > kMaxSide) {
    Fail(name, std::string("the ") + what + " in the PFM header is " + Quoted(token) +
                   ", a number from 1 to " + std::to_string(kMaxSide) + " is expected.");
  }
  return static_cast<int>(side);
}

Header ParseHeader(const std::string& bytes, const std::string& name) {
  Header header;
  const std::string magic = NextToken(bytes, &header.size);
  if (magic != "Pf" && magic != "PF") {
    Fail(name,
         "the file starts with " + Quoted(magic) + ", a PFM file starts with \"Pf\" or \"PF\".");
  }
  header.channels = magic == "Pf" ? 1 : 3;
  header.width = ParseSide(NextToken(bytes, &header.size), "width", name);
  header.height = ParseSide(NextToken(bytes, &header.size), "height", name);
  const std::string token = NextToken(bytes, &header.size);
  double scale = 0.0;
  if (!Parse(token, &scale) || !std::isfinite(scale) || scale == 0.0) {
    Fail(name, "the scale in the PFM header is " + Quoted(token) +
                   ", a number other than 0 is expected (negative: little endian).");
  }
  header.little_endian = scale < 0.0;
  ++header.size;  // the one white space that ends the header
  return header;
}

bool HostIsLittleEndian() {
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

void SwapBytes(cv::Mat* image) {
  const std::size_t floats = image->total() * static_cast<std::size_t>(image->channels());
  for (std::size_t i = 0; i < floats; ++i) {
    unsigned char* value = image->data + i * sizeof(float);
    std::reverse(value, value + sizeof(float));
  }
}

}  // namespace

cv::Mat DecodePfm(const std::string& bytes, const std::string& name) {
  const Header header = ParseHeader(bytes, name);
  const std::size_t row_bytes = sizeof(float) * static_cast<std::size_t>(header.channels) *
                                static_cast<std::size_t>(header.width);
  const std::size_t expected = header.size + row_bytes * static_cast<std::size_t>(header.height);
  if (bytes.size() < expected) {
    Fail(name, "the file is truncated: " + std::to_string(bytes.size()) + " bytes, but " +
                   std::to_string(header.width) + " x " + std::to_string(header.height) +
                   " pixels need " + std::to_string(expected) + ".");
  }
  cv::Mat image(header.height, header.width, CV_MAKETYPE(CV_32F, header.channels));
  for (int y = 0; y < header.height; ++y) {
    const auto rows_below = static_cast<std::size_t>(header.height - 1 - y);
    std::memcpy(image.ptr(y), bytes.data() + header.size + rows_below * row_bytes, row_bytes);
  }
  if (header.little_endian != HostIsLittleEndian()) SwapBytes(&image);
  return image;
}

cv::Mat ReadPfm(const std::string& path) { return DecodePfm(ReadFile(path), path); }

void WritePfm(const std::string& path, const cv::Mat& image) {
  if (image.empty() || (image.type() != CV_32FC1 && image.type() != CV_32FC3)) {
    Fail(path, "only images of one or three float channels can be written as PFM.");
  }
  std::ostringstream header;
  header.imbue(std::locale::classic());
  header << (image.channels() == 1 ? "Pf" : "PF") << '\n'
         << image.cols << ' ' << image.rows << '\n'
         << (HostIsLittleEndian() ? "-1.0" : "1.0") << '\n';
  std::string bytes = header.str();
  const std::size_t row_bytes = image.elemSize() * static_cast<std::size_t>(image.cols);
  bytes.reserve(bytes.size() + row_bytes * static_cast<std::size_t>(image.rows));
  for (int y = image.rows - 1; y >= 0; --y) bytes.append(image.ptr<char>(y), row_bytes);
  WriteFile(path, bytes);
}

}  // namespace stereo_sgmp
