// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Files dropped on the window.

#include <QObject>
#include <filesystem>

class QMimeData;
class QWidget;

namespace perilymph::gui {

/// Accepts one recording or patient file, and refuses all else while it is dragged.
class FileDrop : public QObject {
  Q_OBJECT
public:
  explicit FileDrop(QWidget* window);

Q_SIGNALS:
  void recordingDropped(const std::filesystem::path& file);
  void patientDropped(const std::filesystem::path& file);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void take(const std::filesystem::path& file);
};

}  // namespace perilymph::gui
