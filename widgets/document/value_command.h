#pragma once

#include <QString>
#include <QUndoCommand>

#include <functional>
#include <utility>

namespace glissade {

/// Replaces one value by another, and back. Commands with the same merge key become one, which leaves the undo stack if
/// nothing has changed in the end.
template <class Value>
class ValueCommand final : public QUndoCommand {
 public:
  using Apply = std::function<void(const Value&)>;

  ValueCommand(const QString& text, Value before, Value after, Apply apply, QString mergeKey = {})
      : QUndoCommand(text),
        before_(std::move(before)),
        after_(std::move(after)),
        apply_(std::move(apply)),
        mergeKey_(std::move(mergeKey)) {}

  /// The command leaves the undo stack when it is undone.
  void doOnce() { once_ = true; }
  void undo() override {
    apply_(before_);
    setObsolete(once_);
  }
  void redo() override { apply_(after_); }
  int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto* other = dynamic_cast<const ValueCommand*>(next);
    if (other == nullptr || other->mergeKey_ != mergeKey_) return false;
    after_ = other->after_;
    setObsolete(after_ == before_);
    return true;
  }

 private:
  Value before_;
  Value after_;
  Apply apply_;
  QString mergeKey_;
  bool once_ = false;
};

}  // namespace glissade
