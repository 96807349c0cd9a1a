#include "engine/sequence/product_finder.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

class ProductFinderTest : public testing::Test {
 protected:
  FitTablePtr fits(const ContactLimits& limits = {}) { return *finder.fits(product, team, {}, limits); }
  JointsPtr joints(const std::vector<std::string>& classes = {}) { return finder.joints(product, classes, {}); }

  AssembledProduct product = test::lockedDrawer();
  ThreadTeam team{0};
  ProductFinder finder;
};

TEST_F(ProductFinderTest, FindsNothingTwiceForOneProduct) {
  const FitTablePtr table = fits();
  const JointsPtr found = joints();
  product.fits.on = true;
  EXPECT_EQ(joints(), found) << "joints do not depend on fits";
  const FitTablePtr switched = fits();
  EXPECT_NE(switched, table);
  const auto findings = finder.findings(product, {}, {}, team, {});
  ASSERT_TRUE(findings);
  EXPECT_EQ(findings->fits.prepared(), switched->prepared()) << "a sequence takes the table of the panel";
  ContactLimits wide;
  wide.clearanceUpTo = 0.1;
  EXPECT_GT(fits(wide)->pairs().size(), switched->pairs().size());
  EXPECT_EQ(fits(), switched);
}

TEST_F(ProductFinderTest, FindsAnewForOtherBodiesAndClasses) {
  const FitTablePtr table = fits();
  const JointsPtr found = joints();
  EXPECT_NE(joints({"", "", "", "cable"}), found);
  product.bodies.back().X_WB.position.z() += 1.0;
  EXPECT_NE(fits(), table);
  EXPECT_NE(joints(), found);
}

TEST_F(ProductFinderTest, RemembersNothingThatWasStopped) {
  StopSource source;
  source.requestStop();
  product.fits.on = true;
  EXPECT_EQ(finder.joints(product, {}, source.token()), nullptr);
  const auto stopped = finder.findings(product, {}, {}, team, source.token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
  EXPECT_NE(joints(), nullptr);
  EXPECT_TRUE(finder.findings(product, {}, {}, team, {}));
}

}  // namespace
}  // namespace glissade
