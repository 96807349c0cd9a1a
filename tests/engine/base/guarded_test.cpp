#include "engine/base/guarded.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>

namespace glissade {
namespace {

TEST(Guarded, ReturnsNothingWhereTheWorkEnds) {
  int done = 0;
  EXPECT_FALSE(guarded(GLISSADE_TEXT("counting"), [&] { ++done; }));
  EXPECT_EQ(done, 1);
}

TEST(Guarded, ExhaustedMemoryIsALimit) {
  const auto why = guarded(GLISSADE_TEXT("planning"), [] { throw std::bad_alloc(); });
  ASSERT_TRUE(why);
  EXPECT_EQ(why->kind, ErrorKind::LimitReached);
  EXPECT_EQ(toString(why->reason), "there was not enough memory while planning (std::bad_alloc)");
  EXPECT_FALSE(why->advice.empty());
}

TEST(Guarded, OtherExceptionsAreInternalAndNameTheWork) {
  const auto why = guarded(GLISSADE_TEXT("smoothing the path"), [] { throw std::runtime_error("no motion"); });
  ASSERT_TRUE(why);
  EXPECT_EQ(why->kind, ErrorKind::Internal);
  EXPECT_EQ(toString(why->reason), "an error occurred while smoothing the path: no motion");
  EXPECT_FALSE(why->advice.empty());
}

TEST(Guarded, WhatIsNoExceptionClassIsCaughtToo) {
  const auto why = guarded(GLISSADE_TEXT("planning"), [] { throw 7; });
  ASSERT_TRUE(why);
  EXPECT_EQ(why->kind, ErrorKind::Internal);
  EXPECT_NE(toString(why->reason).find("while planning"), std::string::npos);
}

}  // namespace
}  // namespace glissade
