#include "widgets/paths/export_dialog.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(ExportDialog, HasAFilterForEachFormatOfTheRegistry) {
  const PathExporterRegistry registry = makePathExporterRegistry();
  const ExportDialog dialog(registry);
  ASSERT_EQ(dialog.nameFilters().size(), static_cast<int>(registry.entries().size()));
  EXPECT_EQ(dialog.nameFilters().join(QStringLiteral(";;")),
            QStringLiteral("Table (*.csv);;With provenance (*.json);;OMPL columns (*.path);;Animation (*.glb)"));
  EXPECT_EQ(dialog.acceptMode(), QFileDialog::AcceptSave);
}

TEST(ExportDialog, ANameWithoutEndingGetsThatOfTheFilter) {
  ExportDialog dialog(makePathExporterRegistry());
  EXPECT_EQ(dialog.defaultSuffix(), QStringLiteral("csv"));
  emit dialog.filterSelected(QStringLiteral("Animation (*.glb)"));
  EXPECT_EQ(dialog.defaultSuffix(), QStringLiteral("glb"));
  dialog.selectFile(QStringLiteral("mine"));
  EXPECT_TRUE(dialog.selectedFiles().front().endsWith(QStringLiteral("/mine.glb")))
      << dialog.selectedFiles().front().toStdString();
}

}  // namespace
}  // namespace glissade
