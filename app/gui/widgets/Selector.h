// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A drop-down list in the window's style.

#include <QComboBox>

namespace perilymph::gui {

/// Unavailable entries remain visible but disabled, with the reason. The wheel scrolls the panel
/// and never changes the selection.
class Selector : public QComboBox {
  Q_OBJECT
public:
  Selector(const char* name, const QString& accessibleName, QWidget* parent);

  /// Adds a heading, which cannot be selected.
  void addHeading(const QString& text);
  /// @param tip  Tooltip.
  void addChoice(const QString& text, const QString& value, const QString& tip = {});
  /// @param reason  Appended to the text of an unavailable entry.
  void setPossible(const QString& value, bool isPossible, const QString& reason);
  bool isPossible(const QString& value) const;

  /// Selects an entry; adds it if it is missing.
  void show(const QString& value, const QString& textIfMissing);
  /// Sets the text of the closed list, in place of the entry's full text.
  void setShown(const QString& text) { shown_ = text; }
  QString value() const { return currentData().toString(); }
  /// Width required by the longest entry [px].
  int widest_px() const;
  /// Whether the current text is fully visible.
  bool isWhole() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  void showPopup() override;

Q_SIGNALS:
  /// The user selected this entry.
  void chosen(const QString& value);

protected:
  void paintEvent(QPaintEvent*) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  QString text() const;

  QString shown_;
};

}  // namespace perilymph::gui
