#ifndef STEREO_SGMP_ROS_WORKER_H_
#define STEREO_SGMP_ROS_WORKER_H_

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace stereo_sgmp {

// A thread that always works on the newest item offered to it. Items wait in a single slot: one
// that was not taken yet is dropped for a newer one, so that nothing piles up behind slow work.
template <class Item>
class NewestItemWorker {
 public:
  // `work` runs on the worker's thread and must not throw.
  explicit NewestItemWorker(std::function<void(const Item&)> work)
      : work_(std::move(work)), thread_([this] { Run(); }) {}

  ~NewestItemWorker() { Stop(); }

  NewestItemWorker(const NewestItemWorker&) = delete;
  NewestItemWorker& operator=(const NewestItemWorker&) = delete;

  // Returns at once.
  void Offer(Item item) {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      if (slot_) ++dropped_;
      slot_ = std::move(item);
    }
    changed_.notify_one();
  }

  // Forgets the item that waits: for when nobody wants a result any more.
  void Clear() {
    std::lock_guard<std::mutex> lock(mutex_);
    slot_.reset();
  }

  // Finishes the item in work, forgets the one that waits; what is offered later is forgotten too.
  void Stop() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      stop_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  // Items given up for newer ones so far.
  std::uint64_t dropped() const {
    std::lock_guard<std::mutex> lock(mutex_);
    return dropped_;
  }

 private:
  void Run() {
    while (std::optional<Item> item = Take()) work_(*item);
  }

  // Waits for an item; none when the worker stops.
  std::optional<Item> Take() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return stop_ || slot_; });
    if (stop_) return std::nullopt;
    return std::exchange(slot_, std::nullopt);
  }

  const std::function<void(const Item&)> work_;
  mutable std::mutex mutex_;  // guards the three below
  std::optional<Item> slot_;
  std::uint64_t dropped_ = 0;
  bool stop_ = false;
  std::condition_variable changed_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_WORKER_H_
