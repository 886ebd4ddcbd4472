// Matching costs of networks: the volumes that mc-cnn and LocalExp leave behind.
#ifndef STEREO_SGMP_IO_COST_VOLUME_FILE_H_
#define STEREO_SGMP_IO_COST_VOLUME_FILE_H_

#include <optional>
#include <string>

#include "stereo_sgmp/cost_volume.h"

namespace stereo_sgmp {

// Both formats are bare little-endian float32 values [disparity][y][x], NaN where the match lies
// outside the right image; the name of the file tells which one it is:
//   .acrt  LocalExp's volumes of mc-cnn's accurate net: v in 0..1, 0 a match: C = round(255 v)
//   .bin   mc-cnn's left.bin, ended after the net (-sm_terminate cnn). All values >= 0: as .acrt.
//          With any value below 0 it is the fast net's negated cosine in -1..1, -1 a match:
//          C = round(255 (1 - max(0, -v)))
// NaN costs 255. The shape stands in a text file beside the volume, or the reader has to know it:
//   FILE.shape  "width height disparities min_disparity"
//   FILE.dim    mc-cnn's own, a number per line: 1, disparities, height, width (the 1 may be
//               missing); the smallest disparity is 0

// Whether `path` ends in .bin or .acrt.
bool IsCostVolumeName(const std::string& path);

// Throws std::invalid_argument unless it does.
void CheckCostVolumeName(const std::string& path);

// The shape that stands beside the volume `path`, as a volume without costs; nothing where neither
// text file exists. Throws std::invalid_argument for one that is malformed.
std::optional<CostVolume> ReadCostVolumeShape(const std::string& path);

// Fills volume->costs from a file of the shape that `volume` has. Holds one disparity of the file
// at a time. Throws std::invalid_argument for a file that is missing or of another size than the
// shape, and for values outside of the format's range, with their position.
void ReadCosts(const std::string& path, CostVolume* volume);

// Writes the volume, as values C / 255, and FILE.shape. ReadCosts gives the same costs from it.
// Throws std::invalid_argument for another name than .bin or .acrt and std::runtime_error when the
// files can't be written.
void WriteCostVolume(const std::string& path, const CostVolume& volume);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_COST_VOLUME_FILE_H_
