// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The top bar: pages, patient, and device state.

#include <QPushButton>
#include <QWidget>
#include <utility>
#include <vector>

#include "gui/run/InsertionControl.h"

class QHBoxLayout;
class QLabel;
class QMenu;

namespace perilymph::gui {

class ElidedLabel;
class InsertionController;
class Page;

/// State of the device light. Every state has a text in addition to its color.
enum class DeviceState { off, steady, warning, alarm };

/// A dot and a short text about the device.
class DeviceLight : public QWidget {
  Q_OBJECT
public:
  explicit DeviceLight(QWidget* parent);

  void show(DeviceState light, const QString& caption);
  const QString& text() const { return text_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent*) override;

private:
  DeviceState light_ = DeviceState::off;
  QString text_;
};

/// Acts on the press, before the button is painted, which may take tens of milliseconds.
class StopButton : public QPushButton {
  Q_OBJECT
public:
  using QPushButton::QPushButton;

Q_SIGNALS:
  void stopRequested();

protected:
  void mousePressEvent(QMouseEvent* event) override;
};

/// Name, pages, patient and device.
class TopBar : public QWidget {
  Q_OBJECT
public:
  explicit TopBar(QWidget* parent);

  /// Adds the buttons of the pages; that of the first one, the start page, is the program's name.
  void setPages(const std::vector<Page*>& pages);
  /// Sets the menu of the button at the right.
  void setMenu(QMenu* menu);

  /// Tab reaches the bar after everything else in the window: Stop, start page, keys, settings,
  /// menu, and the links to the pages last.
  void moveToTabEnd();
  /// Marks the current page.
  void setPage(const Page& page);

  /// Shows patient and ear.
  /// @param changed  Differences from the preset, as text; empty if there are none.
  void showSubject(const session::Scenario& scenario, const QString& changed);
  /// Shows that there is no patient yet.
  void showNobody();

  /// Shows the state of the device, or that a cochlea is built.
  void showInsertion(const InsertionController& insertion);
  /// There is no insertion yet, or a replay instead.
  void showPreparing();
  void showReplay();

Q_SIGNALS:
  /// The Stop button was pressed (not only after its release).
  void stopRequested();
  void pageChosen(const QString& id);
  void keysRequested();
  void settingsRequested();

protected:
  void resizeEvent(QResizeEvent*) override;

private:
  void addStop();
  QPushButton* pageButton(const Page& page, const QString& text);
  void addPage(const Page& page);
  void fit();
  void showPages();
  void showPatient();
  void setDevice(DeviceState light, const QString& caption, const QString& tip);

  QHBoxLayout *left_, *tabs_;
  QHBoxLayout* middle_ = nullptr;  ///< Holds the patient.
  QPushButton* home_ = nullptr;
  const Page* start_ = nullptr;                              ///< Its page.
  std::vector<std::pair<const Page*, QPushButton*>> pages_;  ///< After the first one.
  ElidedLabel* patient_;
  QLabel* modified_;
  StopButton* stop_;  ///< Visible while the input renders force.
  DeviceLight* device_;
  QPushButton* menu_;
  /// What the pages' buttons show; icons alone leave the room that patient and ear need.
  enum class PageFace { name, iconAndName, icon };
  PageFace face_ = PageFace::name;
  QString subject_, shortSubject_;  ///< Patient and ear.
};

}  // namespace perilymph::gui
