#include "prior/modal_planes.h"

#include <cstddef>
#include <stdexcept>

namespace stereo_sgmp {

void ModalPlanes::Assign(const PlaneMap& map, const Superpixels& superpixels, double min_support) {
  if (map.labels.size() != superpixels.labels().size()) {
    throw std::invalid_argument(
        "Plane labels and superpixels differ in size; segment the image of the coarse pass.");
  }
  GroupBySuperpixel(map, superpixels);
  votes_.assign(map.planes.size(), 0);
  plane_of_superpixel_.clear();
  for (int s = 0; s < superpixels.count(); ++s) {
    plane_of_superpixel_.push_back(ModeOf(s, min_support));
  }
  labels_.create(map.labels.size(), CV_16SC1);
  for (int y = 0; y < labels_.rows; ++y) {
    const std::int32_t* superpixel = superpixels.labels().ptr<std::int32_t>(y);
    std::int16_t* labels = labels_.ptr<std::int16_t>(y);
    for (int x = 0; x < labels_.cols; ++x) {
      labels[x] = plane_of_superpixel_[static_cast<std::size_t>(superpixel[x])];
    }
  }
}

// Counting sort of the plane labels by superpixel.
void ModalPlanes::GroupBySuperpixel(const PlaneMap& map, const Superpixels& superpixels) {
  const std::int32_t* superpixel = superpixels.labels().ptr<std::int32_t>();
  const std::int16_t* plane = map.labels.ptr<std::int16_t>();
  const std::size_t pixels = map.labels.total();
  first_.assign(static_cast<std::size_t>(superpixels.count()) + 1, 0);
  for (std::size_t i = 0; i < pixels; ++i) ++first_[static_cast<std::size_t>(superpixel[i]) + 1];
  for (std::size_t s = 1; s < first_.size(); ++s) first_[s] += first_[s - 1];
  next_ = first_;
  plane_of_pixel_.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    int& next = next_[static_cast<std::size_t>(superpixel[i])];
    plane_of_pixel_[static_cast<std::size_t>(next++)] = plane[i];
  }
}

std::int16_t ModalPlanes::ModeOf(int superpixel, double min_support) {
  const int begin = first_[static_cast<std::size_t>(superpixel)];
  const int end = first_[static_cast<std::size_t>(superpixel) + 1];
  std::int16_t mode = -1;
  int most = 0;
  for (int i = begin; i < end; ++i) {
    const std::int16_t plane = plane_of_pixel_[static_cast<std::size_t>(i)];
    if (plane < 0) continue;
    const int votes = ++votes_[static_cast<std::size_t>(plane)];
    if (votes > most || (votes == most && plane < mode)) {
      most = votes;
      mode = plane;
    }
  }
  for (int i = begin; i < end; ++i) {
    const std::int16_t plane = plane_of_pixel_[static_cast<std::size_t>(i)];
    if (plane >= 0) votes_[static_cast<std::size_t>(plane)] = 0;
  }
  return most >= min_support * (end - begin) ? mode : std::int16_t{-1};
}

}  // namespace stereo_sgmp
