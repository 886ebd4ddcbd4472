#include "ros/message_pool.h"

#include <algorithm>
#include <memory>
#include <thread>
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

// The contents are plain: it is for the pool to keep the threads apart, and for ThreadSanitizer to
// see whether it does.
using Messages = std::vector<boost::shared_ptr<Message>>;

void Fill(int value, MessagePool<Message>* pool, Messages* messages) {
  for (auto& message : *messages) {
    message = pool->Get();  // gives back what was there
    message->assign(16, value);
  }
}

bool HoldOnly(int value, const Messages& messages) {
  return std::all_of(messages.begin(), messages.end(),
                     [&](const auto& message) { return *message == Message(16, value); });
}

TEST(MessagePool, ServesManyThreads) {
  constexpr int kThreads = 4;
  MessagePool<Message> pool;
  std::vector<int> wrong(kThreads, 0);
  std::vector<std::thread> threads;
  for (int k = 0; k < kThreads; ++k) {
    threads.emplace_back([&pool, k, count = &wrong[static_cast<std::size_t>(k)]] {
      Messages messages(3);
      for (int i = 0; i < 1000; ++i) {
        Fill(kThreads * i + k, &pool, &messages);
        if (!HoldOnly(kThreads * i + k, messages)) ++*count;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(kThreads, 0));
}

TEST(MessagePool, TakesBackWhatOtherThreadsHold) {
  MessagePool<Message> pool;
  int wrong = 0;
  for (int round = 0; round < 200; ++round) {
    Messages messages(4);
    Fill(round, &pool, &messages);
    std::vector<std::thread> listeners;
    std::vector<int> wrong_of(2, 0);
    for (int& count : wrong_of) {
      listeners.emplace_back([held = messages, round, &count]() mutable {
        if (!HoldOnly(round, held)) ++count;
        held.clear();
      });
    }
    for (int i = 1; i < 20; ++i) {  // while the listeners read and give back
      Fill(-i, &pool, &messages);
      if (!HoldOnly(-i, messages)) ++wrong;
    }
    for (std::thread& listener : listeners) listener.join();
    for (const int count : wrong_of) wrong += count;
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace stereo_sgmp
