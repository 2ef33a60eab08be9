// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The bar above the planes of the CT: tools for distances, angles and notes, what was marked, and key images.

#include <QWidget>
#include <array>
#include <vector>

#include "gui/pages/ct/CtStudy.h"
#include "gui/setup/CtKeyImages.h"

class QMenu;
class QPushButton;

namespace perilymph::gui {

/// Chooses a study's tools, lists its markups, and emits the requests of its buttons.
class MarkupBar : public QWidget {
  Q_OBJECT
public:
  MarkupBar(CtStudy& study, QWidget* parent);

  void showKeyImages(std::vector<CtKeyImage> images);
  /// Where the markups are kept: a sentence in their menu.
  void showKeeping(const QString& sentence) { keeping_ = sentence; }

Q_SIGNALS:
  void keyImageRequested();
  void keyImageRemoved(const std::filesystem::path& file);
  void slicerRequested();
  void tableRequested();
  void loadRequested();

private:
  void refresh();
  void fillMarkups();
  void fillKeyImages();

  CtStudy& study_;
  std::array<QPushButton*, 3> tools_{};
  QPushButton *markups_, *keyImage_, *keyImages_;
  QMenu *markupMenu_, *keyImageMenu_;
  std::vector<CtKeyImage> images_;
  QString keeping_;
};

}  // namespace perilymph::gui
