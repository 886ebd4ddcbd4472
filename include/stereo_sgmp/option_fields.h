// The one list of all options: name, unit, range and sentence of each. Command line, YAML, ROS
// parameters, dynamic_reconfigure and the documentation derive from it or are tested against it.
#ifndef STEREO_SGMP_OPTION_FIELDS_H_
#define STEREO_SGMP_OPTION_FIELDS_H_

#include <array>
#include <utility>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The names of the values of an option enum, for people and files.
template <class Enum>
struct EnumNames;

template <>
struct EnumNames<Variant> {
  static constexpr std::array<std::pair<Variant, const char*>, 8> kValues{{{Variant::kSgm, "sgm"},
                                                                           {Variant::kEpi, "epi"},
                                                                           {Variant::kEpv, "epv"},
                                                                           {Variant::kGs, "gs"},
                                                                           {Variant::kGp, "gp"},
                                                                           {Variant::kGni, "gni"},
                                                                           {Variant::kGnv, "gnv"},
                                                                           {Variant::kMw, "mw"}}};
};
template <>
struct EnumNames<CostKind> {
  static constexpr std::array<std::pair<CostKind, const char*>, 3> kValues{
      {{CostKind::kNcc, "ncc"}, {CostKind::kCensus, "census"}, {CostKind::kMixed, "mixed"}}};
};
template <>
struct EnumNames<CensusWindow> {
  static constexpr std::array<std::pair<CensusWindow, const char*>, 2> kValues{
      {{CensusWindow::k5x5, "5x5"}, {CensusWindow::k9x7, "9x7"}}};
};
template <>
struct EnumNames<AlignmentMode> {
  static constexpr std::array<std::pair<AlignmentMode, const char*>, 3> kValues{
      {{AlignmentMode::kOff, "off"}, {AlignmentMode::kOn, "on"}, {AlignmentMode::kAuto, "auto"}}};
};
template <>
struct EnumNames<JumpPolicy> {
  static constexpr std::array<std::pair<JumpPolicy, const char*>, 2> kValues{
      {{JumpPolicy::kLiteral, "literal"}, {JumpPolicy::kSameSurface, "same_surface"}}};
};
template <>
struct EnumNames<PathScheme> {
  static constexpr std::array<std::pair<PathScheme, const char*>, 3> kValues{
      {{PathScheme::kFour, "four"},
       {PathScheme::kEight, "eight"},
       {PathScheme::kFourTwice, "four_twice"}}};
};
template <>
struct EnumNames<PathCosts> {
  static constexpr std::array<std::pair<PathCosts, const char*>, 2> kValues{
      {{PathCosts::kCompact, "compact"}, {PathCosts::kFull, "full"}}};
};
template <>
struct EnumNames<Subpixel> {
  static constexpr std::array<std::pair<Subpixel, const char*>, 4> kValues{
      {{Subpixel::kNone, "none"},
       {Subpixel::kEquiangular, "equiangular"},
       {Subpixel::kParabola, "parabola"},
       {Subpixel::kBlend, "blend"}}};
};
template <>
struct EnumNames<ConfidenceMeasure> {
  static constexpr std::array<std::pair<ConfidenceMeasure, const char*>, 2> kValues{
      {{ConfidenceMeasure::kPeakDifference, "peak_difference"},
       {ConfidenceMeasure::kUncertainty, "uncertainty"}}};
};

// "" for what is no value of the enum.
template <class Enum>
constexpr const char* NameOf(Enum value) {
  for (const auto& [candidate, name] : EnumNames<Enum>::kValues) {
    if (candidate == value) return name;
  }
  return "";
}

struct OptionField {
  const char* name;  // unique; '/' separates the part from the field, as in "prior/variant"
  const char* unit;  // "" for pure numbers, switches and choices
  const char* doc;   // a sentence
  double min = 0.0;  // smallest and largest value of a number
  double max = 0.0;
};

// Calls visit(field, value) for each option, in order. `Options` may be const.
template <class OptionsT, class Visitor>
void VisitOptions(OptionsT& o, Visitor&& visit) {
  visit(OptionField{"min_disparity", "px", "Smallest disparity searched; may be negative.", -4096,
                    4096},
        o.min_disparity);
  visit(OptionField{"num_disparities", "px",
                    "How many disparities are searched from min_disparity on; time and memory "
                    "grow with it.",
                    1, 2048},
        o.num_disparities);
  visit(
      OptionField{"narrow_range", "",
                  "End the search where the surfaces of the coarse pass end; off where things too "
                  "thin for it come nearer than all others."},
      o.narrow_range);
  visit(OptionField{"threads", "",
                    "Threads that match one frame; 0 takes the cores that the process may run on.",
                    0, 256},
        o.threads);
  visit(OptionField{"memory_limit", "MB",
                    "Memory of one frame above which the aggregation works in strips: the same "
                    "result in half as much time again; 0: no limit.",
                    0, 1000000},
        o.memory_limit);
  visit(OptionField{"pin_threads", "",
                    "Keep each thread on a core of its own; taskset chooses which cores."},
        o.pin_threads);

  visit(OptionField{"alignment/mode", "",
                    "Warp the right image by a fitted y' = a y + b: off, on, or auto (only where "
                    "the fit is reliable and matters)."},
        o.alignment.mode);
  visit(OptionField{"alignment/refresh_interval", "frames",
                    "How often the fit is renewed in a stream of frames.", 1, 1000000},
        o.alignment.refresh_interval);

  visit(OptionField{"cost/kind", "",
                    "Matching cost: ncc (the paper's), census, or mixed (census, absolute "
                    "difference and gradient)."},
        o.cost.kind);
  visit(OptionField{"cost/census_window", "", "Window of the census cost: 5x5 or 9x7."},
        o.cost.census_window);
  visit(OptionField{"cost/ncc_epsilon", "gray levels^2",
                    "Added to the denominator of the NCC; damps noise in untextured regions.", 0,
                    10000},
        o.cost.ncc_epsilon);
  visit(OptionField{"cost/vertical_tolerance", "",
                    "Take the smallest NCC cost of the rows -1, 0 and +1 of the right image."},
        o.cost.vertical_tolerance);

  visit(OptionField{"aggregation/scheme", "",
                    "Path evaluations of a pixel: four (the axis directions), eight directions, or "
                    "four_twice (the axis directions, repeated on costs sharpened by the first "
                    "result)."},
        o.aggregation.scheme);
  visit(OptionField{"aggregation/path_costs", "",
                    "compact: costs in about 36 steps and path costs of 8 bits, where the "
                    "penalties let them fit; full: 256 steps and 16 bits, half as fast."},
        o.aggregation.path_costs);
  // Sums of eight path costs have 16 bits: 8 (255 + P1 (1 + alpha)) has to stay below 65535.
  visit(OptionField{"aggregation/p1", "cost", "Penalty of a disparity step of one.", 0, 400},
        o.aggregation.p1);
  visit(OptionField{"aggregation/alpha", "",
                    "P2 = P1 (1 + alpha exp(-|dI| / beta)): how much dearer larger steps are.", 0,
                    16},
        o.aggregation.alpha);
  visit(OptionField{"aggregation/beta", "gray levels",
                    "Intensity difference at which P2 has fallen to about a third.", 0.1, 1000},
        o.aggregation.beta);
  visit(OptionField{"aggregation/color_guide", "",
                    "|dI| is the largest difference of the colour channels instead of the gray "
                    "value's."},
        o.aggregation.color_guide);

  visit(OptionField{"prior/variant", "",
                    "Orientation prior: sgm (none), epi (a plane per superpixel), epv (overlapping "
                    "planes), mw (Manhattan world), or from given inputs gs (surface), gp (its "
                    "planes), gni, gnv (normals, at one or all depths)."},
        o.prior.variant);
  visit(OptionField{"prior/jump_policy", "",
                    "Jumps across label borders: literal (the paper's equation) or same_surface."},
        o.prior.jump_policy);
  visit(OptionField{"prior/jump_slack", "cost",
                    "Price of not following a jump of an estimated plane; -1 makes the shifted "
                    "transition the only "
                    "free one, as in the paper.",
                    -1, 1000},
        o.prior.jump_slack);
  visit(OptionField{"prior/attraction", "px",
                    "Copies of each plane this far above and below it let paths that follow it "
                    "come nearer at no cost; 0 leaves it a prior of orientation alone.",
                    0, 0.5},
        o.prior.attraction);
  visit(OptionField{"prior/min_slope", "px/px",
                    "Planes with less disparity per pixel count as constant, as plain SGM has "
                    "surfaces anyway.",
                    0, 1},
        o.prior.min_slope);
  visit(OptionField{"prior/coarse_factor", "",
                    "Ratio of the full to the coarse resolution from which planes are estimated; 0 "
                    "takes the smallest from 2 to 4 that leaves 0.12 megapixels at most.",
                    0, 16},
        o.prior.coarse_factor);
  visit(
      OptionField{"prior/keep_quantile", "",
                  "Share of the coarse pixels, by uncertainty, that planes are fitted to.", 0.1, 1},
      o.prior.keep_quantile);
  visit(OptionField{"prior/min_plane_area", "coarse px^2",
                    "Smaller plane hypotheses are dropped; in small images the limit is a "
                    "fiftieth of the image.",
                    9, 100000},
        o.prior.min_plane_area);
  visit(OptionField{"prior/spread", "",
                    "Where no plane was found, take that of the pixels that look most alike "
                    "nearby."},
        o.prior.spread);
  visit(OptionField{"prior/superpixel_size", "coarse px",
                    "Distance of neighbouring superpixels (epi).", 4, 200},
        o.prior.superpixel_size);
  visit(OptionField{"prior/min_support", "",
                    "Share of a superpixel that must agree on its plane (epi).", 0, 1},
        o.prior.min_support);
  visit(OptionField{"prior/gni_disparity", "px",
                    "Mean disparity of the one surface that gni integrates from normals; 0 takes "
                    "the middle of the search range.",
                    0, 4096},
        o.prior.gni_disparity);

  visit(OptionField{"refinement/subpixel", "",
                    "Sub-pixel interpolation of the aggregated costs: none, equiangular, "
                    "parabola, or blend (their mean)."},
        o.refinement.subpixel);
  visit(OptionField{"refinement/median", "", "5x5 median of the filled disparities."},
        o.refinement.median);
  visit(OptionField{"refinement/weighted_median", "",
                    "7x7 median of the filled disparities, weighted by colour and confidence."},
        o.refinement.weighted_median);
  visit(OptionField{"refinement/plane_propagation", "",
                    "Unsure pixels move onto the plane of the surer ones of the same surface."},
        o.refinement.plane_propagation);
  visit(OptionField{"refinement/plane_smoothing", "",
                    "Local, colour-weighted plane fit of the disparities."},
        o.refinement.plane_smoothing);
  visit(OptionField{"refinement/superpixel_planes", "",
                    "Holes take the plane fitted to their superpixel."},
        o.refinement.superpixel_planes);

  visit(OptionField{"filter/confidence", "",
                    "What the confidence is computed from: peak_difference, or uncertainty (U of "
                    "the paper)."},
        o.filter.confidence);
  visit(OptionField{"filter/min_confidence", "", "Pixels below are invalid.", 0, 1},
        o.filter.min_confidence);
  visit(OptionField{"filter/lr_tolerance", "px",
                    "Largest difference of the disparity and the right image's own winner; -1 "
                    "switches the check off.",
                    -1, 2048},
        o.filter.lr_tolerance);
  visit(OptionField{"filter/uniqueness_ratio", "%",
                    "By how much the second best disparity must cost more; 0 is off.", 0, 100},
        o.filter.uniqueness_ratio);
  visit(OptionField{"filter/speckle_size", "px^2",
                    "Connected regions smaller than this are invalid; 0 is off.", 0, 100000000},
        o.filter.speckle_size);
  visit(OptionField{"filter/speckle_range", "px",
                    "Largest step between neighbours of one connected region.", 0, 100},
        o.filter.speckle_range);
}

// Throws std::invalid_argument naming the first option out of range, its value and the range.
void CheckOptions(const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_OPTION_FIELDS_H_
