// Tests of the real window on a virtual display.
#include <gtest/gtest.h>

#include <QApplication>

#include "app/window/application.h"

int main(int argc, char** argv) {
  glissade::prepareProcess();
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QApplication application(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
