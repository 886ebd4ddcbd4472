#include "matcher/prior_stage.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

const char* EntryOf(int type) {
  if (type == CV_8UC1) return "one byte";
  return type == CV_32FC3 ? "three floats" : "one float";
}

void CheckMap(Variant variant, const char* name, const cv::Mat& map, int type, cv::Size size) {
  if (map.type() == type && map.size() == size) return;
  std::ostringstream text;
  text << "prior/variant " << NameOf(variant) << " needs a " << name << " of " << EntryOf(type)
       << " per pixel of the left image, " << size.width << "x" << size.height << "; ";
  if (map.empty()) {
    text << "none was given. Pass one, or choose sgm, epi, epv or mw";
  } else {
    text << "the one given is " << map.cols << "x" << map.rows << " of OpenCV type " << map.type();
  }
  throw std::invalid_argument(text.str());
}

void CheckCamera(Variant variant, const MatchInputs& inputs) {
  if (inputs.camera) {
    inputs.camera->Check();
    return;
  }
  throw std::invalid_argument(std::string("prior/variant ") + NameOf(variant) +
                              " needs the camera (its calibration), and none was given");
}

// Area means of a surface in coarse pixels; not finite wherever part of it is not known.
void ShrinkSurface(const cv::Mat& surface, cv::Size size, cv::Mat* coarse, cv::Mat* known) {
  cv::resize(surface, *coarse, size, 0.0, 0.0, cv::INTER_AREA);
  const double scale = static_cast<double>(surface.cols) / size.width;
  known->create(size, CV_8UC1);
  for (int y = 0; y < size.height; ++y) {
    float* values = coarse->ptr<float>(y);
    for (int x = 0; x < size.width; ++x) {
      values[x] = static_cast<float>(values[x] / scale);
      known->at<std::uint8_t>(y, x) = std::isfinite(values[x]) ? 255 : 0;
    }
  }
}

// Given surfaces and normals are trusted: not following them is never free, as in the paper.
PathPrior Trusted(const OrientationPrior* prior) { return {prior, prior, -1}; }

void Clear(PlanePriors* report) {
  report->planes.clear();
  report->labels.release();
}

}  // namespace

void CheckInputs(Variant variant, const MatchInputs& inputs, cv::Size size) {
  switch (variant) {
    case Variant::kGs:
    case Variant::kGp:
      return CheckMap(variant, "disparity surface", inputs.surface, CV_32FC1, size);
    case Variant::kGni:
    case Variant::kGnv:
      CheckMap(variant, "normal map", inputs.normals, CV_32FC3, size);
      if (!inputs.discontinuities.empty()) {
        CheckMap(variant, "map of discontinuities", inputs.discontinuities, CV_8UC1, size);
      }
      return CheckCamera(variant, inputs);
    case Variant::kMw:
      return CheckCamera(variant, inputs);
    case Variant::kSgm:
    case Variant::kEpi:
    case Variant::kEpv:
      return;
  }
}

PathPrior PriorStage::Make(const PriorOptions& options, const MatchInputs& inputs,
                           const ImagePair& images, const CoarsePass& coarse,
                           const VolumeShape& shape, ThreadPool* pool, const SideWork* beside,
                           PlanePriors* report) {
  report->variant = options.variant;
  report->note.clear();
  switch (options.variant) {
    case Variant::kEpi:
    case Variant::kEpv:
      return FromPlanes(options, {coarse.disparity(), coarse.confident()}, coarse.image(), shape,
                        pool, beside, report);
    case Variant::kGp:
      return FromPlanesOfSurface(options, inputs.surface, coarse, shape, pool, beside, report);
    case Variant::kMw:
      return FromManhattanWorld(options, *inputs.camera, images, coarse, shape, pool, beside,
                                report);
    case Variant::kSgm:
    case Variant::kGs:
    case Variant::kGni:
    case Variant::kGnv:
      break;
  }
  Clear(report);
  if (options.variant == Variant::kSgm) return {};
  if (options.variant == Variant::kGs) return FromSurface(inputs.surface, shape);
  return Trusted(normals_.Build({options.variant == Variant::kGnv, options.gni_disparity},
                                inputs.normals, inputs.discontinuities, *inputs.camera,
                                {coarse.disparity(), coarse.confident()}, images.left_color(),
                                shape, pool));
}

PathPrior PriorStage::FromPlanes(const PriorOptions& options, const CoarseDisparity& coarse,
                                 const cv::Mat& coarse_left, const VolumeShape& shape,
                                 ThreadPool* pool, const SideWork* beside, PlanePriors* report) {
  const OrientationPrior* prior =
      estimated_.Estimate(options, coarse, coarse_left, shape, pool, beside);
  report->planes = estimated_.report().planes;
  estimated_.report().labels.copyTo(report->labels);
  return {prior, estimated_.parallel(), options.jump_slack};
}

PathPrior PriorStage::FromSurface(const cv::Mat& surface, const VolumeShape& shape) {
  surface_.Assign(surface, shape);
  return Trusted(&surface_);
}

// The planes of a given surface are found and spread as those of a coarse disparity map (EPi).
PathPrior PriorStage::FromPlanesOfSurface(PriorOptions options, const cv::Mat& surface,
                                          const CoarsePass& coarse, const VolumeShape& shape,
                                          ThreadPool* pool, const SideWork* beside,
                                          PlanePriors* report) {
  ShrinkSurface(surface, coarse.image().size(), &coarse_surface_, &known_);
  options.variant = Variant::kEpi;
  options.jump_slack = -1;
  return FromPlanes(options, {coarse_surface_, known_}, coarse.image(), shape, pool, beside,
                    report);
}

PathPrior PriorStage::FromManhattanWorld(const PriorOptions& options, const StereoCamera& camera,
                                         const ImagePair& images, const CoarsePass& coarse,
                                         const VolumeShape& shape, ThreadPool* pool,
                                         const SideWork* beside, PlanePriors* report) {
  const CoarseDisparity disparity{coarse.disparity(), coarse.confident()};
  const OrientationPrior* prior = manhattan_.Estimate(options, disparity, images.left_color(),
                                                      coarse.image(), camera, shape, pool);
  if (prior != nullptr) {
    report->planes = manhattan_.report().planes;
    manhattan_.report().labels.copyTo(report->labels);
    return {prior, manhattan_.parallel(), options.jump_slack};
  }
  PriorOptions fallback = options;
  fallback.variant = Variant::kEpv;
  report->variant = Variant::kEpv;
  report->note = manhattan_.frame() ? "no plane lies along the three directions of the lines"
                                    : "the lines of the image show no three orthogonal directions";
  report->note += "; the prior is that of epv";
  return FromPlanes(fallback, disparity, coarse.image(), shape, pool, beside, report);
}

}  // namespace stereo_sgmp
