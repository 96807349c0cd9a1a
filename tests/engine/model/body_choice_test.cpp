#include "engine/model/body_choice.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

const std::vector<BodyId> kIds{"pump/rotor/nut", "pump/rotor/shaft", "pump/nut", "plate"};

TEST(BodyChoice, ANameMeansABodyOrAnAssembly) {
  EXPECT_EQ(*bodiesMeant(kIds, {"plate"}, "--without"), (std::vector<bool>{false, false, false, true}));
  EXPECT_EQ(*bodiesMeant(kIds, {"rotor"}, "--without"), (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(*bodiesMeant(kIds, {"nut"}, "--without"), (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(*bodiesMeant(kIds, {"rotor/nut", "plate"}, "--without"), (std::vector<bool>{true, false, false, true}));
  EXPECT_EQ(*bodiesMeant(kIds, {}, "--without"), std::vector<bool>(4, false));
}

TEST(BodyChoice, WhatMeansNothingOrEverythingIsRefused) {
  for (const std::string name : {"ut", "", "pump/plate"}) {
    const auto refused = bodiesMeant(kIds, {name}, "--without");
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
    EXPECT_EQ(toString(refused.error().location), "--without");
    EXPECT_NE(toString(refused.error().reason).find("'" + name + "'"), std::string::npos);
  }
  const auto all = bodiesMeant(kIds, {"pump", "plate"}, "--without");
  ASSERT_FALSE(all);
  EXPECT_EQ(toString(all.error().reason), "leaves no body");
}

}  // namespace
}  // namespace glissade
