// What the nodelet is told beyond the options of the matcher.
#ifndef STEREO_SGMP_ROS_STREAM_OPTIONS_H_
#define STEREO_SGMP_ROS_STREAM_OPTIONS_H_

#include "geometry/pcl/cloud_filter.h"
#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

struct CloudStreamOptions {
  bool compact = false;
  bool dense = false;
  CloudFilterOptions filter;

  bool Organised() const {
    return !dense && filter.voxel_size == 0.0 && filter.outlier_neighbors == 0;
  }
};

struct StreamOptions {
  double min_depth = 0.0;
  double max_depth = 0.0;
  double target_rate = 0.0;
  CloudStreamOptions cloud;
};

// All that the parameters of the nodelet set.
struct NodeletOptions {
  Options match;
  StreamOptions stream;
};

// As VisitOptions of stereo_sgmp/option_fields.h.
template <class StreamOptionsT, class Visitor>
void VisitStreamOptions(StreamOptionsT& o, Visitor&& visit) {
  visit(OptionField{"min_depth", "m",
                    "Nearest depth searched, instead of num_disparities; 0: as many as that says.",
                    0, 1000},
        o.min_depth);
  visit(OptionField{"max_depth", "m",
                    "Farthest depth searched, instead of min_disparity; 0: as that says, or "
                    "infinity where min_depth is set.",
                    0, 100000},
        o.max_depth);
  visit(OptionField{"target_rate", "Hz",
                    "Frames a second to keep up with: when frames take longer, refinement, "
                    "paths and then resolution are lowered, and raised again when there is time; "
                    "0 is off.",
                    0, 1000},
        o.target_rate);
  visit(OptionField{"cloud/compact", "",
                    "Points of 20 bytes without gaps instead of the 32 bytes that PCL aligns to."},
        o.cloud.compact);
  visit(OptionField{"cloud/dense", "",
                    "Valid points only, in one row, instead of one point for each pixel."},
        o.cloud.dense);
  visit(OptionField{"cloud/voxel_size", "m",
                    "One point for each cube with edges of that length; 0 is off.", 0, 100},
        o.cloud.filter.voxel_size);
  visit(OptionField{"cloud/outlier_neighbors", "",
                    "Drop points that are far from their so many nearest neighbours; 0 is off.", 0,
                    1000},
        o.cloud.filter.outlier_neighbors);
  visit(OptionField{"cloud/outlier_deviations", "",
                    "How many standard deviations above the average distance is far.", 0, 100},
        o.cloud.filter.outlier_deviations);
}

template <class NodeletOptionsT, class Visitor>
void VisitNodeletOptions(NodeletOptionsT& o, Visitor&& visit) {
  VisitOptions(o.match, visit);
  VisitStreamOptions(o.stream, visit);
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_STREAM_OPTIONS_H_
