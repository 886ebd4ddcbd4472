#ifndef STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_
#define STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_

namespace stereo_sgmp {

// Chooses the load level (matcher/load_level.h) from the times of the frames: one level down when
// two frames in a row exceed their budget, one up when the time that the level above takes at
// least would fit. A level that turns out too slow is tried again after twice as many frames as
// the time before, so that the level does not swing.
class LoadGovernor {
 public:
  // Index into LoadLevels().
  int level() const { return level_; }

  // After each frame; both in seconds. A budget of 0 is unlimited.
  void Update(double time, double budget);

 private:
  void Lower();
  void Raise();

  static constexpr int kFirstPatience = 8;
  static constexpr int kLastPatience = 256;

  int level_ = 0;
  int late_ = 0;                         // frames in a row that exceeded their budget
  int early_ = 0;                        // frames in a row that left time for the level above
  int patience_ = kFirstPatience;        // early frames before a raise
  int since_raise_ = 2 * kLastPatience;  // frames
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_
