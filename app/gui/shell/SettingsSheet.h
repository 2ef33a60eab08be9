#pragma once

// What a person may choose about the window itself: how it looks and which language it speaks.

#include <QFrame>

class QLabel;
class QVBoxLayout;

namespace perilymph::gui {

class Choice;

/// Lies on the page. A choice is kept at once; the window is then made anew to show it.
class SettingsSheet : public QFrame {
  Q_OBJECT
public:
  explicit SettingsSheet(QWidget* parent);

  /// Choices wait while an array is in a cochlea: making the window anew would end the insertion.
  void setChangeable(bool isChangeable);

Q_SIGNALS:
  /// Something was chosen that a window made anew will show.
  void chosen();
  void closeAsked();

private:
  void addGroup(QVBoxLayout& column, const QString& title, const QString& key,
                const QStringList& caption, const QStringList& names);

  QLabel* note_;
};

/// The words a setting may hold; the first one is meant where nothing was chosen.
QStringList colorSchemeText();
QStringList languageText();

}  // namespace perilymph::gui
