#ifndef STEREO_SGMP_ROS_FOLLOW_UP_THREAD_H_
#define STEREO_SGMP_ROS_FOLLOW_UP_THREAD_H_

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace stereo_sgmp {

// A thread for what follows a frame while the next one is worked on: one task at a time, none
// dropped.
class FollowUpThread {
 public:
  FollowUpThread() : thread_([this] { Run(); }) {}

  // Finishes the task that was started.
  ~FollowUpThread() {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  FollowUpThread(const FollowUpThread&) = delete;
  FollowUpThread& operator=(const FollowUpThread&) = delete;

  // Waits until the task before has ended. `task` must not throw.
  void Start(std::function<void()> task) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !task_; });
    task_ = std::move(task);
    changed_.notify_all();
  }

 private:
  void Run() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stop_ || task_; });
      if (!task_) return;
      lock.unlock();
      task_();
      lock.lock();
      task_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;  // guards the two below, but for the call of the task
  std::function<void()> task_;
  bool stop_ = false;
  std::condition_variable changed_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_FOLLOW_UP_THREAD_H_
