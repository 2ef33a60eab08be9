// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The user guide in the window: the pages of resources/guide with their pictures.

#include <QFrame>
#include <filesystem>
#include <optional>

#include "gui/shell/GuideSearch.h"

class QLineEdit;
class QStackedWidget;

namespace perilymph::gui {

class GuideBrowser;

/// The folder of the guide: beside the resources, or among the documents of the package. Empty if
/// it is not installed.
std::filesystem::path guideFolder();

/// The first page of a guide, in the window's language if it exists in it.
std::filesystem::path guideStart(const std::filesystem::path& folder);

class GuideOverlay : public QFrame {
  Q_OBJECT
public:
  explicit GuideOverlay(QWidget* parent);

  /// Shows the first page in the center of the window.
  void open();
  /// Shows the parts of the guide that have the words; the page again if there are none.
  void search(const QString& words);

Q_SIGNALS:
  void closeRequested();

private:
  void fit();
  void openHit(std::size_t number);

  QLineEdit* words_;
  QStackedWidget* sheets_;  // the page and the hits
  GuideBrowser *page_, *found_;
  std::optional<GuideSearch> search_;  // read when something is searched
  std::vector<GuideHit> hits_;
};

}  // namespace perilymph::gui
