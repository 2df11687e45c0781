/// The error with which check() refuses a case.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "supple/core/error.hpp"
#include "supple/experiment/case.hpp"

namespace supple {

inline std::string error_of(const Case& c) {
  try {
    check(c);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

}  // namespace supple
