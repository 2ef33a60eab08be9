// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The user guide in the window: the pages of resources/guide with their pictures.

#include <QFrame>
#include <filesystem>

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

Q_SIGNALS:
  void closeRequested();

private:
  void fit();

  GuideBrowser* page_;
};

}  // namespace perilymph::gui
