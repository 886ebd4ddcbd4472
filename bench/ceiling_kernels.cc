#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ceiling_kernels.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "ceiling_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::ScalableTag<std::uint8_t>;

// Independent chains, so that no operation waits for another.
constexpr std::size_t kChains = 8;

std::uint8_t Read(const std::uint8_t* from, std::size_t bytes) {
  const Bytes d;
  const std::size_t lanes = hn::Lanes(d);
  auto a = hn::Zero(d);
  auto b = a;
  auto c = a;
  auto e = a;
  for (std::size_t i = 0; i < bytes; i += 4 * lanes) {
    a = hn::Or(a, hn::Load(d, from + i));
    b = hn::Or(b, hn::Load(d, from + i + lanes));
    c = hn::Or(c, hn::Load(d, from + i + 2 * lanes));
    e = hn::Or(e, hn::Load(d, from + i + 3 * lanes));
  }
  return hn::GetLane(hn::Or(hn::Or(a, b), hn::Or(c, e)));
}

void Write(std::uint8_t* to, std::size_t bytes) {
  const Bytes d;
  const auto value = hn::Set(d, 1);
  for (std::size_t i = 0; i < bytes; i += hn::Lanes(d)) hn::Store(value, d, to + i);
}

void Stream(std::uint8_t* to, std::size_t bytes) {
  const Bytes d;
  const auto value = hn::Set(d, 1);
  for (std::size_t i = 0; i < bytes; i += hn::Lanes(d)) hn::Stream(value, d, to + i);
  hwy::FlushStream();
}

double AddAndMin(double operations, std::uint8_t* result) {
  const Bytes d;
  const auto step = hn::Set(d, *result);
  const auto bound = hn::Set(d, static_cast<std::uint8_t>(~*result));
  auto c0 = hn::Iota(d, 0);
  auto c1 = hn::Iota(d, 1);
  auto c2 = hn::Iota(d, 2);
  auto c3 = hn::Iota(d, 3);
  auto c4 = hn::Iota(d, 4);
  auto c5 = hn::Iota(d, 5);
  auto c6 = hn::Iota(d, 6);
  auto c7 = hn::Iota(d, 7);
  const double per_round = 2.0 * static_cast<double>(kChains * hn::Lanes(d));
  double done = 0.0;
  for (; done < operations; done += per_round) {
    c0 = hn::Min(hn::Add(c0, step), bound);
    c1 = hn::Min(hn::Add(c1, step), bound);
    c2 = hn::Min(hn::Add(c2, step), bound);
    c3 = hn::Min(hn::Add(c3, step), bound);
    c4 = hn::Min(hn::Add(c4, step), bound);
    c5 = hn::Min(hn::Add(c5, step), bound);
    c6 = hn::Min(hn::Add(c6, step), bound);
    c7 = hn::Min(hn::Add(c7, step), bound);
  }
  const auto low = hn::Xor(hn::Xor(c0, c1), hn::Xor(c2, c3));
  *result = hn::GetLane(hn::Xor(low, hn::Xor(hn::Xor(c4, c5), hn::Xor(c6, c7))));
  return done;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(Read);
HWY_EXPORT(Write);
HWY_EXPORT(Stream);
HWY_EXPORT(AddAndMin);

std::uint8_t ReadBytes(const std::uint8_t* from, std::size_t bytes) {
  return HWY_DYNAMIC_DISPATCH(Read)(from, bytes);
}

void WriteBytes(std::uint8_t* to, std::size_t bytes) { HWY_DYNAMIC_DISPATCH(Write)(to, bytes); }

void StreamBytes(std::uint8_t* to, std::size_t bytes) { HWY_DYNAMIC_DISPATCH(Stream)(to, bytes); }

double AddAndMinBytes(double operations, std::uint8_t* result) {
  return HWY_DYNAMIC_DISPATCH(AddAndMin)(operations, result);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
