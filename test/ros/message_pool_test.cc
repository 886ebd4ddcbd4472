#include "ros/message_pool.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

using Message = std::vector<int>;

TEST(MessagePool, UsesTheMemoryOfWhatWasGivenBack) {
  MessagePool<Message> pool;
  const int* first = nullptr;
  {
    const auto message = pool.Get();
    message->resize(1000);
    first = message->data();
  }
  EXPECT_EQ(pool.Get()->data(), first);
}

TEST(MessagePool, LeavesAMessageThatIsHeldAlone) {
  MessagePool<Message> pool;
  const auto held = pool.Get();
  held->assign(3, 7);
  for (int i = 0; i < 5; ++i) pool.Get()->assign(3, i);
  EXPECT_EQ(*held, Message(3, 7));
}

TEST(MessagePool, MayGoBeforeItsMessages) {
  auto pool = std::make_unique<MessagePool<Message>>();
  auto message = pool->Get();
  pool.reset();
  message->assign(3, 7);
  EXPECT_EQ(message->size(), 3U);
  message.reset();
}

}  // namespace
}  // namespace stereo_sgmp
