#include "engine/session/run_logger.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(RunLogger, NotesEveryMoveOnceAndWhenTheObjectIsLetGo) {
  RunLogger logger;
  logger.start({});
  logger.noteHand(std::nullopt);
  logger.noteHand(HandState{Pose::identity(), 7});
  logger.noteHand(HandState{Pose::identity(), 7});
  EXPECT_EQ(logger.handMoves(), 0U);
  // Moved there and back between two steps, so that the operator has moved.
  logger.noteHand(HandState{Pose::identity(), 9});
  EXPECT_EQ(logger.handMoves(), 1U);
  logger.noteHand(std::nullopt);
  EXPECT_FALSE(logger.held());
  const RunLog log = joined(logger.parts(true));
  ASSERT_EQ(log.operatorStream.size(), 3U);
  EXPECT_TRUE(log.operatorStream[1].q_device);
  EXPECT_FALSE(log.operatorStream[2].q_device);
}

TEST(RunLogger, PartsComeOnceASecondAndTheLastAtTheEnd) {
  RunLogger logger;
  logger.start({});
  EXPECT_EQ(logger.parts(false).size(), 1U);
  logger.note(ParameterId::Alpha, 0.5);
  EXPECT_EQ(logger.parts(false).size(), 1U);
  EXPECT_EQ(logger.parts(true).size(), 2U);
  EXPECT_EQ(logger.parts(true).size(), 2U);  // no new entries
  EXPECT_EQ(joined(logger.parts(true)).parameterChanges.size(), 1U);
}

TEST(RunLogger, IsBoundedAndSaysSo) {
  RunLogger logger;
  logger.start({});
  for (std::uint64_t i = 0; i <= kMostHandPoses; ++i) logger.noteHand(HandState{Pose::identity(), i});
  logger.note(ParameterId::Alpha, 0.5);
  const RunLogParts& parts = logger.parts(true);
  EXPECT_TRUE(parts.back()->cutShort);
  EXPECT_EQ(parts.back()->operatorStream.size(), kMostHandPoses);
  EXPECT_TRUE(parts.back()->parameterChanges.empty());
  EXPECT_EQ(logger.handMoves(), kMostHandPoses);  // the run itself goes on
}

}  // namespace
}  // namespace glissade
