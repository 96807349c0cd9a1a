#include "widgets/panels/part_pictures.h"

#include "widgets/panels/part_picture.h"

namespace glissade {

PartPictures::Key PartPictures::keyOf(const RigidBody& body) {
  const auto& q = body.X_WB.orientation;
  return {body.mesh, {q.x(), q.y(), q.z(), q.w()}, body.colour};
}

QIcon PartPictures::of(const RigidBody& body) const {
  const auto known = icons_.find(keyOf(body));
  return known == icons_.end() ? QIcon() : known->second;
}

/// Pictures of products that are not shown any more are forgotten.
void PartPictures::draw(const ProductPtr& product, int pixels, bool atOnce) {
  std::map<Key, QIcon> known;
  std::map<Key, RigidBody> open;
  for (const RigidBody& body : product->bodies) {
    const Key key = keyOf(body);
    const auto icon = icons_.find(key);
    if (icon != icons_.end()) {
      known.insert(*icon);
    } else {
      open.emplace(key, body);
    }
  }
  icons_ = std::move(known);
  if (open.empty()) return;
  task_.start(
      "drawing the parts",
      [this, open, pixels](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const auto pictures = std::make_shared<std::map<Key, QImage>>();
        for (const auto& [key, body] : open) {
          if (watch.stop.stopRequested()) break;
          pictures->emplace(key, partPicture(body, pixels));
        }
        return [this, pictures] {
          for (const auto& [key, picture] : *pictures) {
            const QPixmap pixmap = QPixmap::fromImage(picture);
            QIcon icon(pixmap);
            icon.addPixmap(pixmap, QIcon::Selected);  // not tinted where the row is chosen
            icons_[key] = icon;
          }
          emit drawn();
        };
      },
      atOnce);
}

}  // namespace glissade
