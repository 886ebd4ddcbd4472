// What stands where in each kind of generated scene.
#ifndef STEREO_SGMP_SCENE_LAYOUTS_H_
#define STEREO_SGMP_SCENE_LAYOUTS_H_

#include <cstdint>

#include "scene/world.h"

namespace stereo_sgmp {

// Metres, in the left camera's optical frame (x right, y down, z forward), for a field of view
// of about 64 degrees. The seed moves and turns things a little.
World CorridorWorld(std::uint64_t seed);
World RoomWorld(std::uint64_t seed);
World FrontoParallelWorld(std::uint64_t seed);
World FenceWorld(std::uint64_t seed);
World CurvedWorld(std::uint64_t seed);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_LAYOUTS_H_
