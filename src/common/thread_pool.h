#ifndef STEREO_SGMP_COMMON_THREAD_POOL_H_
#define STEREO_SGMP_COMMON_THREAD_POOL_H_

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "common/core_spread.h"

namespace stereo_sgmp {

// Threads that sleep between tasks that do not follow each other at once, and start each of them on
// cores of their own where there are enough. One task at a time; a task must not start another.
class ThreadPool {
 public:
  // The threads that `threads` stands for: 0 takes the cores that this process may run on.
  static int Count(int threads);

  // The calling thread works too, so one fewer than Count(threads) is started. `pinned` keeps
  // each of those on a core of its own, as far as there are as many, from the second on of the
  // cores that this process may run on; the caller's thread stays as it is.
  explicit ThreadPool(int threads, bool pinned = false);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(workers_.size()) + 1; }

  // Calls task(0) ... task(size() - 1), each on a thread of its own at the same time, and
  // returns when all have. The first exception thrown is thrown again here.
  void Run(const std::function<void(int)>& task);

  // Calls task(0) on the calling thread, and meanwhile task(i) on those of the others that get to a
  // core in time; returns when all that have begun have ended. For tasks that take pieces of work
  // until none are left: so a thread that is kept off its core holds nobody up. Exceptions as
  // above.
  void Share(const std::function<void(int)>& task);

  // Calls body(thread, begin, end) for all pieces of `size` of [0, count), in which the last may be
  // smaller: each thread takes the next one when it is done with one.
  void ForPieces(int count, int size, const std::function<void(int, int, int)>& body);

  // Calls body(begin, end) for pieces of [0, count), a few for each thread.
  void ForRanges(int count, const std::function<void(int, int)>& body);

  // Work, and which of the jobs before it in the list must be done first.
  struct Job {
    std::function<void()> work;
    std::vector<std::size_t> after;
  };

  // Does all jobs, as many at a time as there are threads: a thread that is free begins the first
  // that may begin. Each is done by one thread, and must not give the pool a task. Of those that
  // throw, the first exception is thrown again here; jobs that have not begun by then are left.
  void RunJobs(const std::vector<Job>& jobs);

  // For tasks whose parts wait for each other, while the calling part waits: moves it away from the
  // core of another part. Does nothing outside of tasks.
  static void MoveApart();

  // While a part of a task sleeps because it waits for others. Does nothing outside of tasks.
  class Sleep {
   public:
    Sleep();
    ~Sleep();
    Sleep(const Sleep&) = delete;
    Sleep& operator=(const Sleep&) = delete;

    // Before it sleeps again for a moment: leaves its core to a part that has none.
    void LendCore();

   private:
    bool has_lent_ = false;
  };

 private:
  void Work(int index);
  void Execute(int index, const std::function<void(int)>& task);
  void Begin(const std::function<void(int)>& task);
  void Finish(bool leave_out);

  CoreSpread spread_;
  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable done_;
  const std::function<void(int)>* task_ = nullptr;  // null where nobody may begin it
  // Changed with the lock, and read without by who looks whether to wait.
  std::atomic<std::uint64_t> generation_{0};
  std::atomic<int> to_begin_{0};  // threads that are to, and
  std::atomic<int> running_{0};   // that have begun
  bool stopping_ = false;
  std::exception_ptr error_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_THREAD_POOL_H_
