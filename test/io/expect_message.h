#ifndef STEREO_SGMP_IO_EXPECT_MESSAGE_H_
#define STEREO_SGMP_IO_EXPECT_MESSAGE_H_

#include <functional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace stereo_sgmp {

// Expects std::invalid_argument whose message contains `part`.
inline void ExpectInvalid(const std::function<void()>& action, const std::string& part) {
  try {
    action();
    ADD_FAILURE() << "no exception; expected one with: " << part;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "message: " << error.what() << "\nexpected in it: " << part;
  }
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_EXPECT_MESSAGE_H_
