#include "winner_maps.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <vector>

namespace stereo_sgmp {
namespace {

using Costs = std::vector<std::uint16_t>;  // S of one pixel

void SetPixel(const Costs& costs, int y, int x, WinnerMap* map) {
  const auto best = std::min_element(costs.begin(), costs.end());
  const int winner = static_cast<int>(best - costs.begin());
  const int last = static_cast<int>(costs.size()) - 1;
  map->winner(y, x) = static_cast<std::uint16_t>(winner);
  map->cost(y, x) = *best;
  map->cost_below(y, x) = winner == 0 ? WinnerMap::kNone : *(best - 1);
  map->cost_above(y, x) = winner == last ? WinnerMap::kNone : *(best + 1);
  std::uint16_t second = WinnerMap::kNone;
  for (int d = 0; d <= last; ++d) {
    if (std::abs(d - winner) > 1) second = std::min(second, costs[static_cast<std::size_t>(d)]);
  }
  map->second(y, x) = second;
}

void SetRightWinners(const std::vector<Costs>& row, int y, WinnerMap* map) {
  for (int x = 0; x < map->shape.width; ++x) {
    std::uint16_t best = WinnerMap::kNone;
    map->right_winner(y, x) = WinnerMap::kNone;
    for (int d = 0; d < map->shape.disparities; ++d) {
      const int x_left = x + map->shape.min_disparity + d;
      if (x_left < 0 || x_left >= map->shape.width) continue;
      const std::uint16_t cost = row[static_cast<std::size_t>(x_left)][static_cast<std::size_t>(d)];
      if (cost < best) {
        best = cost;
        map->right_winner(y, x) = static_cast<std::uint16_t>(d);
      }
    }
  }
}

}  // namespace

WinnerMap UniformWinnerMap(const VolumeShape& shape, std::uint16_t winner) {
  WinnerMap map;
  map.Create(shape);
  map.winner = winner;
  map.cost = 100;
  map.cost_below = winner == 0 ? WinnerMap::kNone : std::uint16_t{200};
  map.cost_above = winner == shape.disparities - 1 ? WinnerMap::kNone : std::uint16_t{200};
  map.second = 900;
  map.uncertainty = 0;
  map.right_winner = winner;
  return map;
}

WinnerMap RandomWinnerMap(const VolumeShape& shape, unsigned seed) {
  std::mt19937 random(seed);
  WinnerMap map;
  map.Create(shape);
  std::vector<Costs> row(static_cast<std::size_t>(shape.width),
                         Costs(static_cast<std::size_t>(shape.disparities)));
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) {
      Costs& costs = row[static_cast<std::size_t>(x)];
      for (std::uint16_t& cost : costs) cost = static_cast<std::uint16_t>(random() % 9000);
      SetPixel(costs, y, x, &map);
      map.uncertainty(y, x) = static_cast<std::uint16_t>(random() % 3000);
    }
    SetRightWinners(row, y, &map);
  }
  return map;
}

}  // namespace stereo_sgmp
