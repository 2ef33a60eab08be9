// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The insertion page while another patient's cochlea is built: nothing of the one before is shown.

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

Q_SIGNALS:
  void cancelRequested();

protected:
  void place() override;

private:
  QLabel* text_;
};

}  // namespace perilymph::gui
