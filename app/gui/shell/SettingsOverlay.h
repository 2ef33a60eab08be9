// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Settings of the window: colors, language, text size, and keys.

#include <QFrame>
#include <vector>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace perilymph::gui {

/// An overlay of the page. A change is saved at once; colors, language and text size make the window
/// again.
class SettingsOverlay : public QFrame {
  Q_OBJECT
public:
  explicit SettingsOverlay(QWidget* parent);

  /// Disables changes while an array is in a cochlea: a new window would end the insertion.
  void setChangeable(bool isChangeable);

  /// Adds a section, which may be changed at any time.
  void append(QWidget* section);
  /// Scrolls to a section.
  void scrollTo(const QWidget& section);

Q_SIGNALS:
  /// A setting was changed that requires a new window.
  void chosen();
  void closeRequested();

private:
  /// When a change takes effect.
  enum class Effect { withNewWindow, atOnce };
  void addGroup(QVBoxLayout& column, const QString& title, const QString& key,
                const QStringList& caption, const QStringList& names, Effect effect);
  void addTextSize(QVBoxLayout& column);
  void set(const QString& key, const QString& word, Effect effect);
  void addLine(QVBoxLayout& column, const QString& title, const QString& key);
  void addLogo(QVBoxLayout& column);
  /// Where CTs were opened.
  void addScans(QVBoxLayout& column);

  QLabel* note_;
  QVBoxLayout* column_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  std::vector<QWidget*> choices_;  ///< Not those of sections.
};

/// Allowed values of a setting; the first one is the default, unless said.
QStringList colorSchemeText();
QStringList languageText();
/// Whether letters, digits and symbols alone act as keys of the window.
QStringList letterKeysText();
/// Size of all text, in percent; by default 100, at the index normalTextSize.
QStringList textSizeText();
inline constexpr int normalTextSize = 1;

}  // namespace perilymph::gui
