#include "aggregation/winner_map.h"

namespace stereo_sgmp {

void WinnerMap::Create(const VolumeShape& volume) {
  shape = volume;
  for (auto* image :
       {&winner, &cost, &cost_below, &cost_above, &second, &uncertainty, &right_winner}) {
    image->create(volume.height, volume.width);
  }
}

}  // namespace stereo_sgmp
