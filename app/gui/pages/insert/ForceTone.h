// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The force on the hand as a tone, so that the eyes can stay on the array.

#include <cstdint>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// The current tone; loudness 0 is silence, 1 the maximum.
struct Tone {
  double frequency_Hz = 0.0;
  double loudness = 0.0;
};

/// 220 Hz at zero force and an octave more per 100 mN, at most four octaves; the sign is ignored.
/// Silent below 5 mN, the level of hands and friction at rest. A choice, made to hear changes; no
/// source defines such a scale.
Tone toneOf(Force onHand);

/// Generates samples of a tone. Changes of pitch or loudness take 10 ms, to avoid clicks, and a
/// tone that is not renewed for a quarter of a second fades, because the window is busy or idle.
class ToneWriter {
public:
  static constexpr int samplesPerSecond = 44100;

  /// Sets the tone.
  void setTone(const Tone& tone);
  /// Fills the next samples of one channel.
  void write(std::int16_t* samples, int count);

private:
  Tone wished_;
  double frequency_Hz_ = 0.0, loudness_ = 0.0;
  double phase_ = 0.0;  ///< In cycles.
  int left_ = 0;        ///< Samples until the tone expires.
};

}  // namespace perilymph::gui
