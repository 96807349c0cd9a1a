#pragma once

#include <gtest/gtest.h>

#include "engine/places/attribute.h"

namespace glissade {

/// Tests the contract of built-in attributes.
inline void expectSoundBuiltIn(const AttributeDefinition& definition) {
  EXPECT_TRUE(definition.builtIn) << definition.name;
  EXPECT_TRUE(checkValue(definition, definition.initial).ok()) << definition.name;
}

}  // namespace glissade
