#pragma once

// Lets the force on the hand be heard, in a thread of its own.

#include <QObject>
#include <QThread>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

class ForceVoice;

/// Asks for a sound output when told to, and plays on it. The window's thread only posts to the
/// thread that does; systems of sound may block for seconds.
class ForceSound : public QObject {
  Q_OBJECT
public:
  explicit ForceSound(QObject* parent);
  ~ForceSound() override;

  /// Looks for a sound output, once; known() tells.
  void ask();
  void setOn(bool isOn);
  bool isOn() const { return isOn_; }
  /// What is heard from now on, if it is on.
  void show(Force onHand);

Q_SIGNALS:
  /// Whether anything can be heard here.
  /// @param trouble  Why not; empty if it can.
  void known(const QString& reason);

private:
  ForceVoice* voice_;
  QThread thread_;
  bool isOn_ = false;
};

}  // namespace perilymph::gui
