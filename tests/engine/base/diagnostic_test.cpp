#include "engine/base/diagnostic.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(Diagnostic, LeavesEmptyPartsOut) {
  EXPECT_EQ(toString(Diagnostic{ErrorKind::MalformedInput, "a.json", "/start", Message("not a number"),
                                Message("Write one.")}),
            "a.json: /start: not a number. Write one.");
  EXPECT_EQ(toString(Diagnostic{ErrorKind::Internal, "", "", Message("disk full"), {}}), "disk full");
}

TEST(Diagnostic, ExitCodesAreTheDocumentedOnes) {
  EXPECT_EQ(exitCode(ErrorKind::NoPath), 1);
  EXPECT_EQ(exitCode(ErrorKind::Usage), 2);
  EXPECT_EQ(exitCode(ErrorKind::MalformedInput), 3);
  EXPECT_EQ(exitCode(ErrorKind::Unwritable), 3);
  EXPECT_EQ(exitCode(ErrorKind::InCollision), 4);
  EXPECT_EQ(exitCode(ErrorKind::LimitReached), 5);
  EXPECT_EQ(exitCode(ErrorKind::Interrupted), 130);
  EXPECT_EQ(exitCode(ErrorKind::Internal), 70);
}

}  // namespace
}  // namespace glissade
