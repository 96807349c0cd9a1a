#pragma once

#include <QDialog>
#include <QPointer>

#include <functional>
#include <vector>

#include "widgets/panels/headset_page.h"

namespace glissade {

/// Errors and questions of the window, which a person with a headset does not see: the page asks them, and answers are
/// given to the dialog in the window. Of dialogs that are more than a message, the page has the title only, and closes
/// them.
class HeadsetQuestions final : public QObject {
 public:
  /// The page outlives this.
  explicit HeadsetQuestions(HeadsetPage& page);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();
  void answer(int chosen) const;

  HeadsetPage& page_;
  std::function<void()> showSoon_;
  std::vector<QPointer<QDialog>> open_;  ///< the last one is the one that is answered
};

}  // namespace glissade
