#include "common/thread_pool.h"

#include <pthread.h>
#include <sched.h>

#include <hwy/cache_control.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace stereo_sgmp {
namespace {

// About as long as it takes to wake a thread.
constexpr int kSpins = 1000;

// How long a thread that waits for others sleeps, before it looks whether they lack a core.
constexpr std::chrono::microseconds kSleep(100);

// Returns when `done` holds, or after a moment: for what comes at once most times.
template <class Condition>
void SpinUntil(const Condition& done) {
  for (int i = 0; i < kSpins && !done(); ++i) hwy::Pause();
}

// What the calling thread works on: a part of a task of a pool, or nothing.
struct Part {
  CoreSpread* spread = nullptr;
  int index = 0;
};
thread_local Part current_part;

// The cores that this process may run on; empty where the system does not say.
std::vector<int> UsableCores() {
  std::vector<int> cores;
  cpu_set_t usable;
  if (sched_getaffinity(0, sizeof(usable), &usable) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &usable)) cores.push_back(core);
  }
  return cores;
}

// Where that fails, the thread runs where it would have without.
void PinTo(int core, std::thread* thread) {
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(core, &only);
  pthread_setaffinity_np(thread->native_handle(), sizeof(only), &only);
}

// The jobs of a list, for threads that take them.
class JobList {
 public:
  explicit JobList(const std::vector<ThreadPool::Job>& jobs)
      : jobs_(jobs), states_(jobs.size(), State::kWaiting) {}

  // Begins jobs for as long as there are any, or the jobs that they wait for may still end.
  void Work() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
      const std::size_t next = FirstReady();
      if (failed_ || IsOver(next)) return;
      if (next == jobs_.size()) {
        WaitForChange(&lock);
        continue;
      }
      states_[next] = State::kBegun;
      lock.unlock();
      try {
        jobs_[next].work();
      } catch (...) {
        End(next, true);
        throw;
      }
      End(next, false);
      lock.lock();
    }
  }

 private:
  enum class State { kWaiting, kBegun, kDone };

  // Or for a moment.
  void WaitForChange(std::unique_lock<std::mutex>* lock) {
    {
      ThreadPool::Sleep sleep;
      if (changed_.wait_for(*lock, kSleep) == std::cv_status::timeout) sleep.LendCore();
    }
    ThreadPool::MoveApart();
  }

  bool IsReady(std::size_t job) const {
    const std::vector<std::size_t>& after = jobs_[job].after;
    return states_[job] == State::kWaiting &&
           std::all_of(after.begin(), after.end(),
                       [this](std::size_t i) { return states_[i] == State::kDone; });
  }

  std::size_t FirstReady() const {
    std::size_t job = 0;
    while (job < jobs_.size() && !IsReady(job)) ++job;
    return job;
  }

  // Whether nothing waits any more, if the first that is ready is `next`.
  bool IsOver(std::size_t next) const {
    return next == jobs_.size() &&
           std::find(states_.begin(), states_.end(), State::kWaiting) == states_.end();
  }

  void End(std::size_t job, bool failed) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      states_[job] = State::kDone;
      failed_ = failed_ || failed;
    }
    changed_.notify_all();
  }

  const std::vector<ThreadPool::Job>& jobs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<State> states_;
  bool failed_ = false;
};

}  // namespace

int ThreadPool::Count(int threads) {
  if (threads > 0) return threads;
  const auto usable = static_cast<int>(UsableCores().size());
  if (usable > 0) return usable;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ThreadPool::ThreadPool(int threads, bool pinned) : spread_(Count(threads)) {
  const int count = Count(threads);
  const std::vector<int> cores = pinned ? UsableCores() : std::vector<int>();
  for (int i = 1; i < count; ++i) {
    workers_.emplace_back([this, i] { Work(i); });
    if (!cores.empty()) PinTo(cores[static_cast<std::size_t>(i) % cores.size()], &workers_.back());
  }
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  start_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::Run(const std::function<void(int)>& task) {
  Begin(task);
  Execute(0, task);
  Finish(false);
}

void ThreadPool::Share(const std::function<void(int)>& task) {
  Begin(task);
  Execute(0, task);
  Finish(true);
}

void ThreadPool::Begin(const std::function<void(int)>& task) {
  spread_.Begin(0);  // before the others look where it is
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    task_ = &task;
    error_ = nullptr;
    to_begin_ = static_cast<int>(workers_.size());
    generation_.fetch_add(1);
  }
  start_.notify_all();
}

// Waits for the others, or with `leave_out` for those that have begun.
void ThreadPool::Finish(bool leave_out) {
  const auto is_done = [this] { return to_begin_ == 0 && running_ == 0; };
  if (leave_out) {
    const std::lock_guard<std::mutex> lock(mutex_);
    to_begin_ = 0;
    task_ = nullptr;
  }
  SpinUntil(is_done);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!done_.wait_for(lock, kSleep, is_done)) {
    lock.unlock();
    spread_.LendCore(0);
    lock.lock();
  }
  task_ = nullptr;
  if (error_) std::rethrow_exception(error_);
}

void ThreadPool::ForPieces(int count, int size, const std::function<void(int, int, int)>& body) {
  std::atomic<std::int64_t> next{0};
  Share([&](int thread) {
    for (std::int64_t begin = next.fetch_add(size); begin < count; begin = next.fetch_add(size)) {
      const std::int64_t end = std::min<std::int64_t>(begin + size, count);
      body(thread, static_cast<int>(begin), static_cast<int>(end));
    }
  });
}

void ThreadPool::ForRanges(int count, const std::function<void(int, int)>& body) {
  constexpr int kPiecesPerThread = 4;
  const int pieces = size() > 1 ? kPiecesPerThread * size() : 1;
  ForPieces(count, std::max(1, count / pieces),
            [&body](int, int begin, int end) { body(begin, end); });
}

void ThreadPool::RunJobs(const std::vector<Job>& jobs) {
  JobList list(jobs);
  Share([&list](int) { list.Work(); });
}

void ThreadPool::Work(int index) {
  std::uint64_t seen = 0;
  for (;;) {
    SpinUntil([&] { return generation_ != seen; });
    const std::function<void(int)>* task = nullptr;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      start_.wait(lock, [&] { return stopping_ || generation_ != seen; });
      if (stopping_) return;
      seen = generation_;
      if (task_ == nullptr) continue;
      task = task_;
      ++running_;
      --to_begin_;
    }
    Execute(index, *task);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      --running_;
    }
    done_.notify_one();
  }
}

void ThreadPool::MoveApart() {
  if (current_part.spread != nullptr) current_part.spread->MoveApart(current_part.index);
}

ThreadPool::Sleep::Sleep() {
  if (current_part.spread != nullptr) current_part.spread->Rest(current_part.index);
}

ThreadPool::Sleep::~Sleep() {
  if (current_part.spread == nullptr) return;
  current_part.spread->Begin(current_part.index);
  if (has_lent_) current_part.spread->MoveToFreeCore(current_part.index);
}

void ThreadPool::Sleep::LendCore() {
  if (current_part.spread == nullptr) return;
  has_lent_ = current_part.spread->LendCore(current_part.index) || has_lent_;
}

void ThreadPool::Execute(int index, const std::function<void(int)>& task) {
  const Part around = current_part;  // where a job has a pool of its own
  current_part = {&spread_, index};
  if (index > 0) spread_.Begin(index);
  MoveApart();
  try {
    task(index);
  } catch (...) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!error_) error_ = std::current_exception();
  }
  spread_.Rest(index);
  current_part = around;
}

}  // namespace stereo_sgmp
