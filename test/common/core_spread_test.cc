#include "common/core_spread.h"

#include <gtest/gtest.h>
#include <sched.h>

namespace stereo_sgmp {
namespace {

cpu_set_t Usable() {
  cpu_set_t usable;
  EXPECT_EQ(sched_getaffinity(0, sizeof(usable), &usable), 0);
  return usable;
}

void Allow(const cpu_set_t& cores) { ASSERT_EQ(sched_setaffinity(0, sizeof(cores), &cores), 0); }

cpu_set_t Only(int core) {
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(core, &only);
  return only;
}

TEST(CoreSpreadTest, MovesAwayFromTheCoreOfAnotherThread) {
  const cpu_set_t usable = Usable();
  if (CPU_COUNT(&usable) < 2) GTEST_SKIP() << "on one core there is nowhere to move to";
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &usable)) continue;
    CoreSpread spread(2);
    Allow(Only(core));
    spread.Note(0);
    Allow(usable);
    spread.MoveApart(1);
    const cpu_set_t after = Usable();
    EXPECT_TRUE(CPU_EQUAL(&after, &usable));
    // Stays there until the scheduler has a reason of its own.
    EXPECT_NE(sched_getcpu(), core);
  }
}

TEST(CoreSpreadTest, StaysWhereAllCoresAreTaken) {
  const cpu_set_t usable = Usable();
  CoreSpread spread(3);
  Allow(Only(sched_getcpu()));
  const cpu_set_t only = Usable();
  spread.Note(0);
  spread.MoveApart(1);
  const cpu_set_t after = Usable();
  EXPECT_TRUE(CPU_EQUAL(&after, &only));
  Allow(usable);
}

// The first one is the caller's, whose affinity is not this library's matter.
TEST(CoreSpreadTest, NeverMovesTheFirstThread) {
  const cpu_set_t usable = Usable();
  CoreSpread spread(2);
  Allow(Only(sched_getcpu()));
  const int core = sched_getcpu();
  spread.Note(1);
  Allow(usable);
  spread.MoveApart(0);
  EXPECT_EQ(sched_getcpu(), core);
}

}  // namespace
}  // namespace stereo_sgmp
