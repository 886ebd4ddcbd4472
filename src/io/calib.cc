#include "io/calib.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/excerpt.h"
#include "io/file_io.h"

namespace stereo_sgmp {
namespace {

constexpr double kMillimetresPerMetre = 1000.0;
// cam0, cam1 and doffs are rounded to a few digits in some files.
constexpr double kRounding = 0.1;

struct Entry {
  std::string value;
  int line = 0;
};

// The keys of one file with their values as text.
class Entries {
 public:
  Entries(const std::string& text, const std::string& name) : name_(name) {
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      if (std::all_of(line.begin(), line.end(),
                      [](unsigned char c) { return std::isspace(c) != 0; })) {
        continue;
      }
      const std::size_t equals = line.find('=');
      if (equals == std::string::npos) {
        throw std::invalid_argument(name_ + ", line " + std::to_string(number) +
                                    ": \"key=value\" is expected.");
      }
      std::string key = line.substr(0, equals);
      key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
      entries_[key] = {line.substr(equals + 1), number};
    }
  }

  bool Has(const std::string& key) const { return entries_.count(key) != 0; }

  // Numbers of a value, of which brackets and semicolons count as white space.
  template <std::size_t kCount>
  std::array<double, kCount> Numbers(const std::string& key) const {
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) {
      throw std::invalid_argument(name_ + ": the key " + key + " is missing.");
    }
    std::string text = entry->second.value;
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '[' || c == ']' || c == ';'; }, ' ');
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    std::array<double, kCount> numbers{};
    for (double& number : numbers) {
      if (!(stream >> number)) Fail(key, std::to_string(kCount) + " number(s) expected");
    }
    std::string rest;
    if (stream >> rest) Fail(key, "nothing is expected after the number(s)");
    return numbers;
  }

  double Number(const std::string& key) const { return Numbers<1>(key)[0]; }

  double PositiveNumber(const std::string& key) const {
    const double number = Number(key);
    if (!(number > 0.0)) Fail(key, "a number above 0 is expected");
    return number;
  }

  // 0 where there is no such key.
  int Count(const std::string& key) const {
    if (!Has(key)) return 0;
    constexpr int kLargest = 1 << 16;
    const double number = Number(key);
    if (number < 1.0 || number > kLargest || number != std::floor(number)) {
      Fail(key, "a whole number from 1 to " + std::to_string(kLargest) + " is expected");
    }
    return static_cast<int>(number);
  }

  [[noreturn]] void Fail(const std::string& key, const std::string& expectation) const {
    const Entry& entry = entries_.at(key);
    throw std::invalid_argument(name_ + ", line " + std::to_string(entry.line) + ": " + key + "=" +
                                Excerpt(entry.value, 80) + ", but " + expectation + ".");
  }

 private:
  std::string name_;
  std::map<std::string, Entry> entries_;
};

struct Pinhole {
  double f = 0.0;
  double cx = 0.0;
  double cy = 0.0;
};

Pinhole ReadPinhole(const Entries& entries, const std::string& key) {
  const std::array<double, 9> k = entries.Numbers<9>(key);
  const bool rectified = k[0] > 0.0 && k[1] == 0.0 && k[3] == 0.0 && k[4] == k[0] && k[6] == 0.0 &&
                         k[7] == 0.0 && k[8] == 1.0;
  if (!rectified) entries.Fail(key, "[f 0 cx; 0 f cy; 0 0 1] with f > 0 is expected");
  return {k[0], k[2], k[5]};
}

}  // namespace

Calibration ParseCalibration(const std::string& text, const std::string& name) {
  const Entries entries(text, name);
  const Pinhole left = ReadPinhole(entries, "cam0");
  const Pinhole right = ReadPinhole(entries, "cam1");
  if (right.f != left.f || std::abs(right.cy - left.cy) > kRounding) {
    entries.Fail("cam1", "the same f and cy as in cam0 are expected of a rectified pair");
  }
  Calibration calibration;
  StereoCamera& camera = calibration.camera;
  camera.focal_length = left.f;
  camera.cx = left.cx;
  camera.cy = left.cy;
  camera.doffs = right.cx - left.cx;
  if (entries.Has("doffs")) {
    const double doffs = entries.Number("doffs");
    if (std::abs(doffs - camera.doffs) > kRounding) {
      entries.Fail("doffs", "the difference of the principal points of cam1 and cam0 is expected");
    }
    camera.doffs = doffs;
  }
  camera.baseline = entries.PositiveNumber("baseline") / kMillimetresPerMetre;
  calibration.size = {entries.Count("width"), entries.Count("height")};
  calibration.num_disparities = entries.Count("ndisp");
  return calibration;
}

Calibration ReadCalibration(const std::string& path) {
  return ParseCalibration(ReadFile(path), path);
}

void WriteCalibration(const std::string& path, const Calibration& calibration) {
  const StereoCamera& camera = calibration.camera;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10 - 1);
  const auto write_pinhole = [&](const char* key, double cx) {
    text << key << "=[" << camera.focal_length << " 0 " << cx << "; 0 " << camera.focal_length
         << ' ' << camera.cy << "; 0 0 1]\n";
  };
  write_pinhole("cam0", camera.cx);
  write_pinhole("cam1", camera.cx + camera.doffs);
  text << "doffs=" << camera.doffs << '\n'
       << "baseline=" << camera.baseline * kMillimetresPerMetre << '\n';
  if (!calibration.size.empty()) {
    text << "width=" << calibration.size.width << '\n'
         << "height=" << calibration.size.height << '\n';
  }
  if (calibration.num_disparities > 0) text << "ndisp=" << calibration.num_disparities << '\n';
  text << "isint=0\n";
  WriteFile(path, text.str());
}

}  // namespace stereo_sgmp
