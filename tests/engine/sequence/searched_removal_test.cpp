#include "engine/sequence/searched_removal.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

TEST(SearchedRemoval, HasAsMuchWorkAsItIsGiven) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionWorlds worlds(product, fits);
  const SearchedRemoval searched(product, fits, worlds, 1);
  const BodyGroup cap{product.indexOf("cap")};
  const BodySet all(product.bodies.size(), true);
  EXPECT_TRUE(std::holds_alternative<Refused>(searched.tryRemoval(cap, all, 1, {})));
  const RemovalAnswer answer = searched.tryRemoval(cap, all, 2'000'000, {});
  ASSERT_TRUE(std::holds_alternative<Removed>(answer));
  EXPECT_EQ(std::get<Removed>(answer).path.certificate.status, CertificateStatus::Certified);
}

/// A drawer that is held by its pin: the limit of work ends the search.
TEST(SearchedRemoval, EndsWhereThereIsNoWay) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionWorlds worlds(product, fits);
  const SearchedRemoval searched(product, fits, worlds, 1);
  const RemovalAnswer answer =
      searched.tryRemoval({product.indexOf("drawer")}, BodySet(product.bodies.size(), true), 200'000, {});
  ASSERT_TRUE(std::holds_alternative<Refused>(answer));
  EXPECT_FALSE(std::get<Refused>(answer).stopped);
}

}  // namespace
}  // namespace glissade
