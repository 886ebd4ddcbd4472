// Measures what the machine can do at most, for 1 and 2 threads: bytes per second from and to
// memory and the caches, and additions and minima of bytes per second. Usage:
//   ceiling_benchmark [--benchmark_...]
// Benchmarks are named ceiling/WHAT/THREADS; the counter is G/s, 10^9 bytes or operations.
#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "ceiling_kernels.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {
namespace {

// Of each thread: well inside the caches of current machines, or far outside.
constexpr std::size_t kInL1 = 16 << 10;
constexpr std::size_t kInL2 = 192 << 10;
constexpr std::size_t kInL3 = 4 << 20;
constexpr std::size_t kInMemory = 256 << 20;
// What a thread moves between two meetings with the others.
constexpr std::size_t kPerRun = 256 << 20;

using Move = std::function<void(std::uint8_t* buffer, std::size_t bytes)>;

void SetGiga(double per_iteration, benchmark::State* state) {
  state->counters["G/s"] =
      benchmark::Counter(per_iteration * 1e-9, benchmark::Counter::kIsIterationInvariantRate);
}

void Bandwidth(benchmark::State& state, int threads, std::size_t bytes, const Move& move) {
  ThreadPool pool(threads);
  std::vector<AlignedBuffer<std::uint8_t>> buffers(static_cast<std::size_t>(threads));
  for (AlignedBuffer<std::uint8_t>& buffer : buffers) {
    buffer.Resize(bytes);
    WriteBytes(buffer.data(), bytes);
  }
  const auto run = [&](int thread) {
    std::uint8_t* buffer = buffers[static_cast<std::size_t>(thread)].data();
    for (std::size_t moved = 0; moved < kPerRun; moved += bytes) move(buffer, bytes);
  };
  pool.Run(run);
  for (auto _ : state) pool.Run(run);
  const std::size_t rounds = (kPerRun + bytes - 1) / bytes;
  SetGiga(static_cast<double>(rounds * bytes) * threads, &state);
}

void Operations(benchmark::State& state, int threads) {
  ThreadPool pool(threads);
  double done = 0.0;
  const auto run = [&](int thread) {
    constexpr double kOperations = 20e9;
    std::uint8_t result = 7;
    const double of_thread = AddAndMinBytes(kOperations, &result);
    benchmark::DoNotOptimize(result);
    if (thread == 0) done = of_thread;
  };
  pool.Run(run);
  for (auto _ : state) pool.Run(run);
  SetGiga(done * threads, &state);
}

void Register(const std::string& name, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->Iterations(1);
}

void RegisterAll(int threads) {
  const std::string suffix = "/" + std::to_string(threads);
  const auto add = [&](const char* name, std::size_t bytes, const Move& move) {
    Register("ceiling/" + std::string(name) + suffix,
             [=](benchmark::State& state) { Bandwidth(state, threads, bytes, move); });
  };
  const auto read = [](std::uint8_t* buffer, std::size_t bytes) {
    benchmark::DoNotOptimize(ReadBytes(buffer, bytes));
  };
  add("memory_read", kInMemory, read);
  add("memory_write", kInMemory, WriteBytes);
  add("memory_stream", kInMemory, StreamBytes);
  add("l3_read", kInL3, read);
  add("l2_read", kInL2, read);
  add("l1_read", kInL1, read);
  Register("ceiling/byte_operations" + suffix,
           [=](benchmark::State& state) { Operations(state, threads); });
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const int threads : {1, 2}) stereo_sgmp::RegisterAll(threads);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
