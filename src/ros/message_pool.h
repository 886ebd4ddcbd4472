#ifndef STEREO_SGMP_ROS_MESSAGE_POOL_H_
#define STEREO_SGMP_ROS_MESSAGE_POOL_H_

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <boost/shared_ptr.hpp>

namespace stereo_sgmp {

// Messages whose memory is used again once nobody holds them any more: the system takes longer to
// hand out fresh pages for a large one than it takes to fill them.
template <class Message>
class MessagePool {
 public:
  // A new message, or one that was given back, with what it contained.
  boost::shared_ptr<Message> Get() {
    std::unique_ptr<Message> message = free_->Take();
    if (!message) message = std::make_unique<Message>();
    // The list outlives the pool where a message does.
    return boost::shared_ptr<Message>(message.release(), [free = free_](Message* unused) {
      free->Add(std::unique_ptr<Message>(unused));
    });
  }

 private:
  // What a publisher's queue and a listener in the same process hold at a time; more are freed.
  static constexpr std::size_t kMostFree = 3;

  class FreeList {
   public:
    std::unique_ptr<Message> Take() {
      std::lock_guard<std::mutex> lock(mutex_);
      if (messages_.empty()) return nullptr;
      std::unique_ptr<Message> message = std::move(messages_.back());
      messages_.pop_back();
      return message;
    }

    void Add(std::unique_ptr<Message> message) {
      std::lock_guard<std::mutex> lock(mutex_);
      if (messages_.size() < kMostFree) messages_.push_back(std::move(message));
    }

   private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Message>> messages_;
  };

  std::shared_ptr<FreeList> free_ = std::make_shared<FreeList>();
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_MESSAGE_POOL_H_
