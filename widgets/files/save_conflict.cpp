#include "widgets/files/save_conflict.h"

#include <QCoreApplication>
#include <QDir>
#include <QPushButton>

#include "widgets/controls/plain_message_box.h"

namespace glissade {
namespace {

/// Context of the translations.
struct SaveConflict {
  Q_DECLARE_TR_FUNCTIONS(SaveConflict)
};

}  // namespace

ConflictAnswer askAboutConflict(const SaveResult& refused, QWidget* parent) {
  const bool removed = refused.status == SaveStatus::RemovedByOthers;
  const QString file = QDir::toNativeSeparators(QString::fromStdString(refused.why.file));
  const QString choice =
      removed ? SaveConflict::tr("Save it there again, or under another name.")
              : SaveConflict::tr(
                    "Overwrite it with your version: the other version stays under File > Earlier versions. Or open "
                    "the other version: your edits are lost. Or save your version under another name.");
  PlainMessageBox box(QMessageBox::Warning,
                      removed ? SaveConflict::tr("The file is gone") : SaveConflict::tr("The file was changed"),
                      removed ? SaveConflict::tr("Another program has removed or renamed the file since it was opened:")
                              : SaveConflict::tr("Another program has changed the file since it was opened:"),
                      file + QStringLiteral("\n\n") + choice, parent);
  const auto* mine = box.addButton(removed ? SaveConflict::tr("Save &again") : SaveConflict::tr("&Overwrite"),
                                   QMessageBox::DestructiveRole);
  const QPushButton* theirs =
      removed ? nullptr : box.addButton(SaveConflict::tr("Open the other &version"), QMessageBox::ActionRole);
  QPushButton* other = box.addButton(SaveConflict::tr("Save &as..."), QMessageBox::AcceptRole);
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(other);
  box.exec();
  if (box.clickedButton() == mine) return ConflictAnswer::KeepMine;
  if (theirs != nullptr && box.clickedButton() == theirs) return ConflictAnswer::TakeTheirs;
  return box.clickedButton() == other ? ConflictAnswer::SaveAs : ConflictAnswer::Cancel;
}

}  // namespace glissade
