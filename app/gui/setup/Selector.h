#pragma once

// One of a list, in the window's own drawing.

#include <QComboBox>

namespace perilymph::gui {

/// A list that opens. What cannot be chosen stays in it, greyed, with the reason. The wheel scrolls
/// the panel and never changes a choice.
class Selector : public QComboBox {
  Q_OBJECT
public:
  Selector(const char* name, const QString& accessibleName, QWidget* parent);

  /// A line that parts the list; not to be chosen.
  void addHeading(const QString& text);
  /// @param tip  Why, or what it is.
  void addChoice(const QString& text, const QString& value, const QString& tip = {});
  /// @param reason  Follows the text of a choice that is not possible.
  void setPossible(const QString& value, bool isPossible, const QString& reason);
  bool isPossible(const QString& value) const;

  /// Shows a choice; one that is not in the list is added.
  void show(const QString& value, const QString& textIfMissing);
  /// What the closed list says instead of the choice's whole text.
  void setShown(const QString& text) { shown_ = text; }
  QString value() const { return currentData().toString(); }
  /// As wide as it must be for its longest choice.
  int widest_px() const;
  /// Whether what it says now is not cut.
  bool isWhole() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  void showPopup() override;

Q_SIGNALS:
  /// A person chose this.
  void chosen(const QString& value);

protected:
  void paintEvent(QPaintEvent*) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  QString text() const;

  QString shown_;
};

}  // namespace perilymph::gui
