// Carries out the recipe "Add a member of the automatic planner".
#include <gtest/gtest.h>

#include "engine/planning/direct_planner.h"
#include "tests/engine/planning/automatic/member_conformance.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

Member straightMember(const Problem& problem) {
  return {
      "straight", {0.5, 0, 0, Restart::Never, 20}, [problem](std::uint64_t, std::uint64_t) -> std::unique_ptr<Planner> {
        return std::make_unique<LinearPlanner>(problem);
      }};
}

TEST(MemberRecipe, TheNewMemberKeepsTheContractOfTheMembers) {
  Problem problem = windowProblem();
  EXPECT_FALSE(deliversOrSaysWhyNot(straightMember(closedProblem()), closedProblem()));
  problem.goal = Pose::translation({1.5, 0.0, 0.0});
  EXPECT_TRUE(deliversOrSaysWhyNot(straightMember(problem), problem));
}

TEST(MemberRecipe, ThePortfolioGivesTheNewMemberItsShareFromItsEntryOn) {
  const Problem problem = windowProblem();
  std::vector<Member> members = makeMembers(problem);
  const std::size_t mine = members.size();
  members.push_back(straightMember(problem));
  std::vector<Contender> contenders;
  for (const Member& member : members) contenders.push_back(member.contender);
  Portfolio portfolio(contenders);
  for (int turn = 0; turn < 20; ++turn) portfolio.charge(portfolio.next(), 1);
  EXPECT_EQ(portfolio.work(mine), 0U);
  for (int turn = 0; turn < 200; ++turn) portfolio.charge(portfolio.next(), 1);
  EXPECT_GT(portfolio.work(mine), 1U);
}

}  // namespace
}  // namespace glissade
