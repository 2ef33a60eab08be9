#pragma once

// What can be chosen about the picture, for those who do not know the keys.

#include <QToolButton>
#include <optional>
#include <vector>

#include "gui/pages/insert/PaneArea.h"
#include "perilymph/visualization/InsertionScene.h"

class QAction;
class QActionGroup;
class QMenu;

namespace perilymph::gui {

/// Which tier draws; without a tier, the machine's speed decides.
using QualityChoice = std::optional<visualization::Quality>;

/// A button with a menu: where to look from, how many views, stereo, and how much is drawn. Each
/// entry has its key beside it; what cannot be chosen says why.
class ViewMenu : public QToolButton {
  Q_OBJECT
public:
  explicit ViewMenu(QWidget* parent);

  void setPreset(visualization::CameraPreset preset);
  void setArrangement(PaneLayout layout);
  void setStereo(visualization::Stereo stereo);
  void setQuality(QualityChoice quality);
  /// Quad-buffered stereo cannot be chosen here because of this; with no trouble it can.
  void offerQuadBuffered(const QString& error);
  /// The force cannot be heard here because of this; with no trouble it can.
  void offerSound(const QString& error);

Q_SIGNALS:
  /// The menu opens: now is the time to ask what is there.
  void opened();
  void soundChosen(bool isOn);
  void presetChosen(perilymph::visualization::CameraPreset preset);
  void arrangementChosen(perilymph::gui::PaneLayout layout);
  void stereoChosen(perilymph::visualization::Stereo stereo);
  void qualityChosen(perilymph::gui::QualityChoice quality);

private:
  /// One of several; @return the entry.
  QAction* addChoice(QMenu& menu, QActionGroup& group, const QString& text, const QString& key,
                     const char* name);

  void addSound(QMenu& menu);

  QAction* sound_ = nullptr;
  std::vector<QAction*> presets_, layouts_, stereos_, qualities_;
};

}  // namespace perilymph::gui
