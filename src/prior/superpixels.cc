#include "prior/superpixels.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

// Clusters settle after few rounds; the authors use ten.
constexpr int kIterations = 5;
// Components below this share of size^2 join a neighbour.
constexpr int kSmallestDivisor = 4;

void CheckInputs(const cv::Mat& image, int size, double compactness) {
  const int channels = image.channels();
  if (image.depth() != CV_8U || (channels != 1 && channels != 3 && channels != 4)) {
    throw std::invalid_argument("The image for superpixels has OpenCV type " +
                                std::to_string(image.type()) +
                                "; expected CV_8U with 1, 3 or 4 channels.");
  }
  if (size < 1) {
    throw std::invalid_argument("The superpixel size is " + std::to_string(size) +
                                "; expected at least 1 pixel.");
  }
  if (!(compactness > 0.0)) {
    throw std::invalid_argument("The superpixel compactness is " + std::to_string(compactness) +
                                "; expected a value above 0.");
  }
}

// Calls body(band, begin, end) over as many contiguous bands of [0, count) as there are threads.
void ForBands(int count, ThreadPool* threads, const std::function<void(int, int, int)>& body) {
  if (threads == nullptr) {
    body(0, 0, count);
    return;
  }
  const std::int64_t bands = threads->size();
  threads->ForPieces(threads->size(), 1, [&](int, int band, int) {
    body(band, static_cast<int>(count * band / bands),
         static_cast<int>(count * (band + std::int64_t{1}) / bands));
  });
}

}  // namespace

void Superpixels::Segment(const cv::Mat& image, int size, double compactness, ThreadPool* threads) {
  CheckInputs(image, size, compactness);
  count_ = 0;
  labels_.create(image.size(), CV_32SC1);
  if (image.empty()) return;
  Convert(image);
  PlaceCentres(size);
  sums_.resize(threads != nullptr ? static_cast<std::size_t>(threads->size()) : 1);
  const double weight = compactness / size;
  for (int i = 0; i < kIterations; ++i) {
    ForBands(image.rows, threads, [&](int band, int begin, int end) {
      AssignRows(begin, end, size, static_cast<float>(weight * weight));
      AddUp(begin, end, &sums_[static_cast<std::size_t>(band)]);
    });
    MoveCentres();
  }
  Connect(size * size / kSmallestDivisor);
}

void Superpixels::Convert(const cv::Mat& image) {
  if (image.channels() == 1) {
    image.copyTo(converted_);
  } else if (image.channels() == 3) {
    cv::cvtColor(image, converted_, cv::COLOR_BGR2Lab);
  } else {
    cv::cvtColor(image, converted_, cv::COLOR_BGRA2BGR);
    cv::cvtColor(converted_, converted_, cv::COLOR_BGR2Lab);
  }
  cv::split(converted_, bytes_);
  channels_.resize(bytes_.size());
  for (std::size_t c = 0; c < bytes_.size(); ++c) bytes_[c].convertTo(channels_[c], CV_32F);
}

void Superpixels::PlaceCentres(int size) {
  const int across = std::max(1, (converted_.cols + size / 2) / size);
  const int down = std::max(1, (converted_.rows + size / 2) / size);
  distance_.create(converted_.size(), CV_32FC1);
  clusters_.create(converted_.size(), CV_32SC1);
  centres_.clear();
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      const int x = (2 * i + 1) * converted_.cols / (2 * across);
      const int y = (2 * j + 1) * converted_.rows / (2 * down);
      ClusterCentre centre{{}, static_cast<float>(x), static_cast<float>(y)};
      for (std::size_t c = 0; c < channels_.size(); ++c) {
        centre.channel[c] = channels_[c].at<float>(y, x);
      }
      centres_.push_back(centre);
    }
  }
  // What holds for pixels that no centre ever reaches.
  for (int y = 0; y < clusters_.rows; ++y) {
    std::int32_t* clusters = clusters_.ptr<std::int32_t>(y);
    const int row = static_cast<int>(std::int64_t{y} * down / clusters_.rows) * across;
    for (int x = 0; x < clusters_.cols; ++x) {
      clusters[x] = row + static_cast<int>(std::int64_t{x} * across / clusters_.cols);
    }
  }
}

void Superpixels::AssignRows(int begin, int end, int size, float spatial_weight) {
  distance_.rowRange(begin, end).setTo(std::numeric_limits<float>::max());
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    const ClusterCentre& centre = centres_[k];
    const int cx = cvRound(centre.x);
    const int cy = cvRound(centre.y);
    const cv::Rect around(cx - size, cy - size, 2 * size + 1, 2 * size + 1);
    const cv::Rect box = around & cv::Rect(0, begin, distance_.cols, end - begin);
    if (box.empty()) continue;
    AssignWindow(WindowOf(box), centre, spatial_weight, static_cast<std::int32_t>(k));
  }
}

ClusterWindow Superpixels::WindowOf(const cv::Rect& box) {
  ClusterWindow window{};
  window.channels = static_cast<int>(channels_.size());
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    window.channel[c] = channels_[c].ptr<float>(box.y) + box.x;
  }
  window.nearest = distance_.ptr<float>(box.y) + box.x;
  window.cluster = clusters_.ptr<std::int32_t>(box.y) + box.x;
  window.stride = distance_.cols;
  window.x = box.x;
  window.y = box.y;
  window.width = box.width;
  window.height = box.height;
  return window;
}

void Superpixels::AddUp(int begin, int end, std::vector<Sums>* sums) const {
  sums->assign(centres_.size(), Sums());
  const int channels = converted_.channels();
  for (int y = begin; y < end; ++y) {
    const std::int32_t* clusters = clusters_.ptr<std::int32_t>(y);
    const std::uint8_t* pixel = converted_.ptr<std::uint8_t>(y);
    for (int x = 0; x < clusters_.cols; ++x, pixel += channels) {
      Sums& sum = (*sums)[static_cast<std::size_t>(clusters[x])];
      for (int c = 0; c < channels; ++c) sum.channel[c] += pixel[c];
      sum.x += x;
      sum.y += y;
      ++sum.pixels;
    }
  }
}

void Superpixels::MoveCentres() {
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    Sums total{};
    for (const std::vector<Sums>& part : sums_) {
      for (int c = 0; c < 3; ++c) total.channel[c] += part[k].channel[c];
      total.x += part[k].x;
      total.y += part[k].y;
      total.pixels += part[k].pixels;
    }
    if (total.pixels == 0) continue;
    const auto mean = [&total](std::int64_t sum) {
      return static_cast<float>(static_cast<double>(sum) / static_cast<double>(total.pixels));
    };
    for (int c = 0; c < 3; ++c) centres_[k].channel[c] = mean(total.channel[c]);
    centres_[k].x = mean(total.x);
    centres_[k].y = mean(total.y);
  }
}

// Gives each component of a cluster a label of its own; components below `smallest` pixels join
// the label of the pixel to the left of or above their first one.
void Superpixels::Connect(int smallest) {
  labels_.setTo(-1);
  const int width = labels_.cols;
  std::int32_t* labels = labels_.ptr<std::int32_t>();
  const int total = static_cast<int>(labels_.total());
  for (int start = 0; start < total; ++start) {
    if (labels[start] >= 0) continue;
    const int pixels = Flood(start, count_);
    if (pixels >= smallest || start == 0) {
      ++count_;
      continue;
    }
    const std::int32_t neighbour = start % width > 0 ? labels[start - 1] : labels[start - width];
    for (const int i : component_) labels[i] = neighbour;
  }
}

// Labels the component of the pixel `start` and returns its size.
int Superpixels::Flood(int start, int label) {
  const int width = labels_.cols;
  const int total = static_cast<int>(labels_.total());
  std::int32_t* labels = labels_.ptr<std::int32_t>();
  const std::int32_t* clusters = clusters_.ptr<std::int32_t>();
  const auto visit = [&](int i) {
    if (labels[i] >= 0 || clusters[i] != clusters[start]) return;
    labels[i] = label;
    component_.push_back(i);
  };
  component_.clear();
  visit(start);
  std::size_t next = 0;
  while (next < component_.size()) {
    const int i = component_[next++];
    const int x = i % width;
    if (x > 0) visit(i - 1);
    if (x + 1 < width) visit(i + 1);
    if (i >= width) visit(i - width);
    if (i + width < total) visit(i + width);
  }
  return static_cast<int>(component_.size());
}

}  // namespace stereo_sgmp
