#pragma once

#include <QButtonGroup>
#include <QDialog>
#include <QImage>
#include <set>
#include <string>
#include <vector>

#include "engine/model/body_id.h"

namespace glissade {

/// A body that fills the same place as others.
struct Variant {
  BodyId id;
  QString name;
  QImage picture;
};

/// Asks for the one that is built among several bodies that fill the same place. Each body has a picture, and each
/// place one choice.
class VariantsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `places`: the variants of each place.
  VariantsDialog(std::vector<std::vector<Variant>> places, QWidget* parent);

  /// Ids of the bodies that were not chosen, at places where one was.
  std::set<BodyId> leftOut() const;

 private:
  QWidget* makePlace(const std::vector<Variant>& variants, int number);
  QWidget* makeVariant(const Variant& variant, int index, QButtonGroup& choice);

  std::vector<std::vector<Variant>> places_;
  std::vector<QButtonGroup*> choices_;  ///< one for each place; the button of a variant has the variant's index
};

}  // namespace glissade
