#pragma once

// The bar at the top: the pages, whose ear this is, and whether the hand answers.

#include <QWidget>
#include <utility>
#include <vector>

#include "gui/run/InsertionControl.h"
#include "gui/shell/PageStack.h"

class QLabel;
class QPushButton;

namespace perilymph::gui {

/// How the device's light shines. Every state has its word beside the color.
enum class DeviceState { off, steady, warning, alarm };

/// A dot and a few words about the hand.
class DeviceLight : public QWidget {
  Q_OBJECT
public:
  explicit DeviceLight(QWidget* parent);

  void show(DeviceState light, const QString& caption);
  const QString& text() const { return text_; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;

private:
  DeviceState light_ = DeviceState::off;
  QString text_;
};

/// Name, pages, patient and device.
class TopBar : public QWidget {
  Q_OBJECT
public:
  explicit TopBar(QWidget* parent);

  /// Marks the page that is shown.
  void setPage(Page page);

  /// Whose ear this is.
  /// @param changed  What is no longer as the preset says, in words; empty where nothing is.
  void showSubject(const session::Scenario& scenario, const QString& changed);
  /// It is nobody's turn yet.
  void showNobody();

  /// How the hand answers.
  /// @param error  What went wrong, for the tip.
  void showInsertion(const InsertionControl& control, const QString& error);
  /// There is no insertion yet, or a recording in its place.
  void showPreparing();
  void showReplay();

Q_SIGNALS:
  void pageChosen(perilymph::gui::Page page);
  void keysAsked();
  void settingsAsked();

private:
  QPushButton* addPage(Page page, const QString& text, const char* name);
  void setDevice(DeviceState light, const QString& caption, const QString& tip);

  std::vector<std::pair<Page, QPushButton*>> pages_;
  QLabel* patient_;
  QLabel* modified_;
  DeviceLight* device_;
};

}  // namespace perilymph::gui
