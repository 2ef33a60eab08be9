// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The insertion page while another patient's cochlea is built, of which nothing before is shown, or while a
// device is opened.

#include "gui/widgets/Overlay.h"

class QLabel;

namespace perilymph::gui {

/// Covers its page.
class LoadingStage : public Overlay {
  Q_OBJECT
public:
  explicit LoadingStage(QWidget* page);

  /// @param subject  What is built: "P-301 · left ear". Empty removes the cover.
  void show(const QString& subject);
  /// @param sentence  What is waited for. Empty removes the cover.
  void showDevice(const QString& sentence);

Q_SIGNALS:
  void cancelRequested();

protected:
  void place() override;

private:
  void cover(const QString& sentence, const QString& afterCancel);

  QLabel* text_;
  QWidget* cancel_;
};

}  // namespace perilymph::gui
