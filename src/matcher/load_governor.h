#ifndef STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_
#define STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_

namespace stereo_sgmp {

// Chooses the load level (matcher/load_level.h) from the times of the frames: one level down when
// frames have fallen a budget behind, which late frames add to and early ones make up for; one up
// when the time that the level above takes at least would fit. A level that turns out too slow is
// tried again after eight times as many frames as the time before, so that the level does not
// swing.
class LoadGovernor {
 public:
  // Index into LoadLevels().
  int level() const { return level_; }

  // After each frame; both in seconds. A budget of 0 is unlimited.
  void Update(double time, double budget);

 private:
  void Lower();
  void Raise();
  void GoTo(int level);
  int Patience() const;

  static constexpr int kFirstPatience = 8;
  static constexpr int kLastPatience = 512;

  int level_ = 0;
  int frames_ = 0;                 // at this level
  double mean_ = 0.0;              // time of its frames, the latest most, in budgets
  double behind_ = 0.0;            // in budgets
  bool on_trial_ = false;          // whether the level was reached from below, not long ago
  int too_slow_ = -1;              // the level that was tried last, and proved to be
  int patience_ = kFirstPatience;  // frames before it is tried again
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_LOAD_GOVERNOR_H_
