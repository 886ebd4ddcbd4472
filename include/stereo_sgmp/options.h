// Options of the matcher: plain structs, a default in place for each field.
// Ranges, units and the sentence a user reads stand in option_fields.h, once, for the command
// line, YAML, ROS parameters, dynamic_reconfigure and the documentation.
#ifndef STEREO_SGMP_OPTIONS_H_
#define STEREO_SGMP_OPTIONS_H_

namespace stereo_sgmp {

// Which orientation prior steers the aggregation (Table 1 of the paper).
enum class Variant {
  kSgm,  // no prior: the baseline
  kEpi,  // estimated planes, one per superpixel: a 2D prior
  kEpv,  // estimated planes, overlapping within their convex hulls: a 3D prior
  kGs,   // the given disparity surface: a 2D prior
  kGp,   // planes fitted to the given disparity surface: a 2D prior
  kGni,  // one surface integrated from given normals: a 2D prior
  kGnv,  // surfaces integrated from given normals, at all depths: a 3D prior
  kMw,   // planes along the three directions of a Manhattan world: a 3D prior
};

enum class CostKind {
  kNcc,     // truncated normalised cross correlation, 5x5 (the paper's)
  kCensus,  // Hamming distance of census transforms
  kMixed,   // census + absolute difference + gradient
};

enum class CensusWindow { k5x5, k9x7 };

enum class AlignmentMode {
  kOff,   // the images are taken as they are
  kOn,    // the right image is always warped by the fitted model
  kAuto,  // warped only where the fit is reliable and shifts by a visible amount
};

// What the zero-cost transition follows where neighbouring pixels carry different surfaces.
enum class JumpPolicy {
  kLiteral,      // j = S^(p') - S^(p) of the rasterised prior, across label borders too
  kSameSurface,  // j of the surface at p, evaluated at p and at p'
};

// Which path evaluations a pixel gets.
enum class PathScheme {
  kFour,       // four axis directions, once: the least time
  kEight,      // eight directions, once
  kFourTwice,  // four axis directions twice, the second time on costs sharpened by the first S
};

// Resolution of costs and path costs.
enum class PathCosts {
  kCompact,  // costs in about 36 steps, path costs of 8 bits where the penalties let them fit
  kFull,     // costs in 256 steps, path costs of 16 bits: half as fast
};

enum class Subpixel { kNone, kEquiangular, kParabola, kBlend };

// What the published confidence is computed from.
enum class ConfidenceMeasure {
  kPeakDifference,  // distance of the second best S to the best, smoothed, less the LR difference
  kUncertainty,     // U_p of the paper
};

struct AlignmentOptions {
  AlignmentMode mode = AlignmentMode::kAuto;
  int refresh_interval = 100;
};

struct CostOptions {
  CostKind kind = CostKind::kMixed;
  CensusWindow census_window = CensusWindow::k9x7;
  double ncc_epsilon = 1.0;
  bool vertical_tolerance = false;
};

struct AggregationOptions {
  PathScheme scheme = PathScheme::kEight;
  PathCosts path_costs = PathCosts::kCompact;
  int p1 = 116;
  double alpha = 12.0;
  double beta = 7.0;
  bool color_guide = true;
};

struct PriorOptions {
  Variant variant = Variant::kEpv;
  JumpPolicy jump_policy = JumpPolicy::kSameSurface;
  int jump_slack = 12;
  double attraction = 0.25;
  double min_slope = 0.04;
  int coarse_factor = 0;
  double keep_quantile = 0.95;
  int min_plane_area = 800;
  bool spread = true;
  int superpixel_size = 14;
  double min_support = 0.2;
  double gni_disparity = 0.0;
};

struct RefinementOptions {
  Subpixel subpixel = Subpixel::kBlend;
  bool median = true;
  bool weighted_median = false;
  bool plane_propagation = false;
  bool plane_smoothing = false;
  bool superpixel_planes = false;
};

struct FilterOptions {
  ConfidenceMeasure confidence = ConfidenceMeasure::kPeakDifference;
  double min_confidence = 0.1;
  double lr_tolerance = 1.5;
  double uniqueness_ratio = 0.0;
  int speckle_size = 200;
  double speckle_range = 1.0;
};

struct Options {
  int min_disparity = 0;
  int num_disparities = 128;
  bool narrow_range = true;
  int threads = 0;
  int memory_limit = 0;
  bool pin_threads = false;
  AlignmentOptions alignment;
  CostOptions cost;
  AggregationOptions aggregation;
  PriorOptions prior;
  RefinementOptions refinement;
  FilterOptions filter;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_OPTIONS_H_
