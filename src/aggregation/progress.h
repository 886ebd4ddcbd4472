#ifndef STEREO_SGMP_AGGREGATION_PROGRESS_H_
#define STEREO_SGMP_AGGREGATION_PROGRESS_H_

#include <atomic>
#include <memory>

namespace stereo_sgmp {

// How far each group of rows of a sweep has come, for the wavefront: a group may enter a column
// when the group above has left the next one.
class Progress {
 public:
  // Nothing done in any of `groups` groups.
  void Reset(int groups);

  // `columns` columns of the last row of `group` are done.
  void Publish(int group, int columns) { done_[group].store(columns, std::memory_order_release); }

  // Returns when `columns` columns of `group` are done. Spins for a moment, then sleeps, since
  // another process may need the core that the other group waits for.
  void WaitFor(int group, int columns) const;

 private:
  std::unique_ptr<std::atomic<int>[]> done_;
  int capacity_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PROGRESS_H_
