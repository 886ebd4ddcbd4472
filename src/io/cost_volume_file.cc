#include "io/cost_volume_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "io/file_io.h"

namespace stereo_sgmp {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the files are read as they lie");

constexpr int kMaxSide = 1 << 16;
constexpr int kMaxDisparity = 1 << 14;
constexpr float kRounding = 1e-3f;  // by which a cosine may be above 1
constexpr float kMaxCost = 255.0f;

[[noreturn]] void Fail(const std::string& path, const std::string& sentence) {
  throw std::invalid_argument(path + ": " + sentence);
}

bool IsAcrt(const std::string& path) { return std::filesystem::path(path).extension() == ".acrt"; }

std::size_t PlaneSize(const CostVolume& volume) {
  return static_cast<std::size_t>(volume.width) * static_cast<std::size_t>(volume.height);
}

std::vector<int> ReadNumbers(const std::string& path) {
  std::istringstream text(ReadFile(path));
  text.imbue(std::locale::classic());
  std::vector<int> numbers;
  for (int number = 0; text >> number;) numbers.push_back(number);
  if (!text.eof()) Fail(path, "whole numbers are expected, and nothing else.");
  return numbers;
}

void CheckRange(const std::string& path, const char* what, int value, int min, int max) {
  if (value >= min && value <= max) return;
  Fail(path, std::string("the ") + what + " of the cost volume is " + std::to_string(value) +
                 ", a number from " + std::to_string(min) + " to " + std::to_string(max) +
                 " is expected.");
}

void CheckShape(const std::string& path, const CostVolume& volume) {
  CheckRange(path, "width", volume.width, 1, kMaxSide);
  CheckRange(path, "height", volume.height, 1, kMaxSide);
  CheckRange(path, "number of disparities", volume.disparities, 1, kMaxDisparity);
  CheckRange(path, "smallest disparity", volume.min_disparity, -kMaxDisparity, kMaxDisparity);
}

CostVolume ShapeOf(int width, int height, int disparities, int min_disparity) {
  CostVolume volume;
  volume.width = width;
  volume.height = height;
  volume.disparities = disparities;
  volume.min_disparity = min_disparity;
  return volume;
}

CostVolume ParseShape(const std::string& path) {
  const std::vector<int> numbers = ReadNumbers(path);
  if (numbers.size() != 4) {
    Fail(path, std::to_string(numbers.size()) +
                   " numbers found, four are expected: width height disparities min_disparity.");
  }
  return ShapeOf(numbers[0], numbers[1], numbers[2], numbers[3]);
}

CostVolume ParseDim(const std::string& path) {
  std::vector<int> numbers = ReadNumbers(path);
  if (numbers.size() == 4 && numbers[0] == 1) numbers.erase(numbers.begin());
  if (numbers.size() != 3) {
    Fail(path, "the numbers 1, disparities, height and width are expected, one a line.");
  }
  return ShapeOf(numbers[2], numbers[1], numbers[0], 0);
}

std::string Describe(const CostVolume& volume) {
  return std::to_string(volume.width) + " x " + std::to_string(volume.height) + " pixels and " +
         std::to_string(volume.disparities) + " disparities";
}

void CheckFileSize(const std::string& path, std::size_t bytes, const CostVolume& volume) {
  const std::size_t plane_bytes = PlaneSize(volume) * sizeof(float);
  const std::size_t expected = plane_bytes * static_cast<std::size_t>(volume.disparities);
  if (bytes == expected) return;
  std::string sentence = "the file has " + std::to_string(bytes) + " bytes, but " +
                         Describe(volume) + " need " + std::to_string(expected);
  if (bytes > 0 && bytes % plane_bytes == 0) {
    sentence += "; the file may be one of " + std::to_string(bytes / plane_bytes) + " disparities";
  } else {
    sentence +=
        bytes < expected ? "; it is truncated or of another shape" : "; it is of another shape";
  }
  Fail(path, sentence + ".");
}

bool IsPossible(float value, float min) {
  return std::isnan(value) || (value >= min && value <= 1.0f + kRounding);
}

float BytesSwapped(float value) {
  unsigned char bytes[sizeof(float)];
  std::memcpy(bytes, &value, sizeof(value));
  std::reverse(bytes, bytes + sizeof(float));
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

// Calls use(index, plane) for each disparity of the file.
void ForEachPlane(const std::string& path, const CostVolume& volume,
                  const std::function<void(int, const std::vector<float>&)>& use) {
  std::ifstream file = OpenFile(path);
  std::vector<float> plane(PlaneSize(volume));
  for (int index = 0; index < volume.disparities; ++index) {
    if (!file.read(reinterpret_cast<char*>(plane.data()),
                   static_cast<std::streamsize>(plane.size() * sizeof(float)))) {
      Fail(path, "the file can't be read to its end.");
    }
    use(index, plane);
  }
}

// Whether few values are of a magnitude that networks put out, and all would be with their bytes
// in the other order.
bool LooksBigEndian(const std::vector<float>& plane) {
  const auto is_usual = [](float value) {
    constexpr float kSmall = 1e-6f;
    const float magnitude = std::abs(value);
    return value == 0.0f || std::isnan(value) ||
           (magnitude >= kSmall && magnitude <= 1.0f + kRounding);
  };
  const auto usual = std::count_if(plane.begin(), plane.end(), is_usual);
  return static_cast<std::size_t>(usual) < plane.size() / 2 &&
         std::all_of(plane.begin(), plane.end(),
                     [&](float value) { return is_usual(BytesSwapped(value)); });
}

[[noreturn]] void FailAt(const std::string& path, const CostVolume& volume, int index,
                         const std::vector<float>& plane, std::size_t position) {
  if (LooksBigEndian(plane)) {
    Fail(path, "the values seem to be big-endian; little-endian float32 are expected.");
  }
  const auto width = static_cast<std::size_t>(volume.width);
  std::ostringstream sentence;
  sentence << "the value at x " << position % width << ", y " << position / width
           << ", disparity index " << index << " is " << plane[position] << ", but "
           << (IsAcrt(path) ? "0 to 1 or NaN are" : "-1 to 1 or NaN are")
           << " expected; take the network's own output (mc-cnn: -sm_terminate cnn) of this shape.";
  Fail(path, sentence.str());
}

// Checks all values and says whether one is negative.
bool HasNegativeValues(const std::string& path, const CostVolume& volume) {
  const float min = IsAcrt(path) ? 0.0f : -1.0f - kRounding;
  bool negative = false;
  ForEachPlane(path, volume, [&](int index, const std::vector<float>& plane) {
    for (std::size_t i = 0; i < plane.size(); ++i) {
      if (!IsPossible(plane[i], min)) FailAt(path, volume, index, plane, i);
      negative = negative || plane[i] < 0.0f;
    }
  });
  return negative;
}

std::uint8_t CostOf(float value, bool negated_cosine) {
  const float mismatch = negated_cosine ? 1.0f - std::max(0.0f, -value) : value;
  if (std::isnan(value)) return static_cast<std::uint8_t>(kMaxCost);
  return static_cast<std::uint8_t>(std::lround(kMaxCost * std::clamp(mismatch, 0.0f, 1.0f)));
}

}  // namespace

bool IsCostVolumeName(const std::string& path) {
  return IsAcrt(path) || std::filesystem::path(path).extension() == ".bin";
}

void CheckCostVolumeName(const std::string& path) {
  if (!IsCostVolumeName(path)) Fail(path, "a cost volume is expected, named .bin or .acrt.");
}

std::optional<CostVolume> ReadCostVolumeShape(const std::string& path) {
  using Sidecar = std::pair<const char*, CostVolume (*)(const std::string&)>;
  for (const auto& [extension, parse] :
       {Sidecar{".shape", ParseShape}, Sidecar{".dim", ParseDim}}) {
    const std::string beside = path + extension;
    if (!std::filesystem::exists(beside)) continue;
    const CostVolume volume = parse(beside);
    CheckShape(beside, volume);
    return volume;
  }
  return std::nullopt;
}

void ReadCosts(const std::string& path, CostVolume* volume) {
  CheckCostVolumeName(path);
  CheckShape(path, *volume);
  OpenFile(path);  // first of all, says whether there is such a file
  CheckFileSize(path, std::filesystem::file_size(path), *volume);
  const bool negated_cosine = HasNegativeValues(path, *volume);
  const auto disparities = static_cast<std::size_t>(volume->disparities);
  volume->costs.resize(PlaneSize(*volume) * disparities);
  ForEachPlane(path, *volume, [&](int index, const std::vector<float>& plane) {
    std::uint8_t* cost = volume->costs.data() + index;
    for (const float value : plane) {
      *cost = CostOf(value, negated_cosine);
      cost += disparities;
    }
  });
}

void WriteCostVolume(const std::string& path, const CostVolume& volume) {
  CheckCostVolumeName(path);
  std::vector<float> plane(PlaneSize(volume));
  const auto disparities = static_cast<std::size_t>(volume.disparities);
  WriteAtomically(path, [&](const std::string& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    for (std::size_t index = 0; index < disparities; ++index) {
      for (std::size_t i = 0; i < plane.size(); ++i) {
        plane[i] = static_cast<float>(volume.costs[i * disparities + index]) / kMaxCost;
      }
      file.write(reinterpret_cast<const char*>(plane.data()),
                 static_cast<std::streamsize>(plane.size() * sizeof(float)));
    }
    file.close();
    if (!file) {
      throw std::runtime_error(path + ": the costs of " + Describe(volume) +
                               " can't be written; check permissions and free space.");
    }
  });
  std::ostringstream shape;
  shape.imbue(std::locale::classic());
  shape << volume.width << ' ' << volume.height << ' ' << volume.disparities << ' '
        << volume.min_disparity << '\n';
  WriteFile(path + ".shape", shape.str());
}

}  // namespace stereo_sgmp
