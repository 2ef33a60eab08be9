// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Menu of the view options.

#include <QToolButton>
#include <optional>
#include <vector>

#include "gui/pages/insert/PaneArea.h"
#include "perilymph/visualization/InsertionScene.h"

class QAction;
class QActionGroup;
class QMenu;

namespace perilymph::gui {

/// Rendering quality; empty: selected automatically.
using QualityChoice = std::optional<visualization::Quality>;

/// A button with a menu: camera, number of views, stereo, and quality. Entries show their keys;
/// unavailable ones show why.
class ViewMenu : public QToolButton {
  Q_OBJECT
public:
  explicit ViewMenu(QWidget* parent);

  void setPreset(visualization::CameraPreset preset);
  void setArrangement(PaneLayout layout);
  void setStereo(visualization::Stereo stereo);
  void setQuality(QualityChoice quality);
  /// Why quad-buffered stereo is unavailable; empty if it is available.
  void offerQuadBuffered(const QString& error);
  /// Why force sound is unavailable; empty if it is available.
  void offerSound(const QString& error);

Q_SIGNALS:
  /// The menu opens: update what is available.
  void opened();
  void soundChosen(bool isOn);
  void presetChosen(perilymph::visualization::CameraPreset preset);
  void arrangementChosen(perilymph::gui::PaneLayout layout);
  void stereoChosen(perilymph::visualization::Stereo stereo);
  void qualityChosen(perilymph::gui::QualityChoice quality);

private:
  /// Adds one of several exclusive entries. @return the entry.
  QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, const QString& key,
                     const char* name);

  void addSound(QMenu& menu);

  QAction* sound_ = nullptr;
  std::vector<QAction*> presets_, layouts_, stereos_, qualities_;
};

}  // namespace perilymph::gui
