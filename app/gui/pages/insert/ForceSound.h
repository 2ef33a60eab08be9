// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sonification of the force on the hand, in a separate thread.

#include <QObject>
#include <QThread>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

class ForceVoice;

/// Opens an audio output on request, and plays on it. The UI thread only posts to the audio thread,
/// because audio systems may block for seconds.
class ForceSound : public QObject {
  Q_OBJECT
public:
  explicit ForceSound(QObject* parent);
  ~ForceSound() override;

  /// Searches for an audio output once; emits known().
  void ask();
  void setOn(bool isOn);
  bool isOn() const { return isOn_; }
  /// Sets the force to be played, if enabled.
  void show(Force onHand);

Q_SIGNALS:
  /// Whether sound is available.
  /// @param reason  Why not; empty if it is.
  void known(const QString& reason);

private:
  ForceVoice* voice_;
  QThread thread_;
  bool isOn_ = false;
};

}  // namespace perilymph::gui
