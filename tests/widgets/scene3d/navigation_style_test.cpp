#include "widgets/scene3d/navigation_style.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(NavigationStyleTest, EachStyleOrbitsAndPans) {
  struct Drags {
    NavigationStyle style;
    Qt::MouseButtons orbit;
    Qt::MouseButtons pan;
    Qt::KeyboardModifiers panKey;
  };
  const Drags drags[] = {{NavigationStyle::Standard, Qt::LeftButton, Qt::MiddleButton, Qt::NoModifier},
                         {NavigationStyle::Standard, Qt::LeftButton, Qt::LeftButton, Qt::ShiftModifier},
                         {NavigationStyle::Cad, Qt::MiddleButton, Qt::MiddleButton, Qt::ControlModifier},
                         {NavigationStyle::Blender, Qt::MiddleButton, Qt::MiddleButton, Qt::ShiftModifier},
                         {NavigationStyle::Gesture, Qt::LeftButton, Qt::RightButton, Qt::NoModifier}};
  for (const Drags& drag : drags) {
    EXPECT_EQ(cameraDragOf(drag.style, drag.orbit, Qt::NoModifier), CameraDrag::Orbit);
    EXPECT_EQ(cameraDragOf(drag.style, drag.pan, drag.panKey), CameraDrag::Pan);
  }
}

TEST(NavigationStyleTest, TheLeftButtonIsFreeForSelectionInCadStyles) {
  for (const NavigationStyle style : {NavigationStyle::Cad, NavigationStyle::Blender}) {
    EXPECT_EQ(cameraDragOf(style, Qt::LeftButton, Qt::NoModifier), CameraDrag::None);
  }
}

TEST(NavigationStyleTest, ATrackballTumbles) {
  EXPECT_EQ(cameraDragOf(NavigationStyle::Trackball, Qt::LeftButton, Qt::NoModifier), CameraDrag::Tumble);
}

}  // namespace
}  // namespace glissade
