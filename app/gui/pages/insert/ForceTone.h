#pragma once

// The force on the hand as a tone, for eyes that stay on the array.

#include <cstdint>

#include "perilymph/foundation/Units.h"

namespace perilymph::gui {

/// What is heard at a moment; a loudness of 0 is silence, 1 the most.
struct Tone {
  double frequency_Hz = 0.0;
  double loudness = 0.0;
};

/// 220 Hz at no force and an octave more for each 100 mN, at most four of them; pulling sounds as
/// pushing does. Silent below 5 mN: hands and friction make so much at rest. A choice, made for
/// hearing a change; no source names a scale for it.
Tone toneOf(Force onHand);

/// Writes a tone as samples. A change of pitch or loudness takes 10 ms, so that nothing clicks, and
/// a tone nobody renews for a quarter of a second fades: then the window is busy or at rest.
class ToneWriter {
public:
  static constexpr int samplesPerSecond = 44100;

  /// The tone from now on.
  void hear(const Tone& tone);
  /// Fills the next samples of one channel.
  void write(std::int16_t* samples, int count);

private:
  Tone wished_;
  double frequency_Hz_ = 0.0, loudness_ = 0.0;
  double phase_ = 0.0;  ///< In turns.
  int left_ = 0;        ///< Samples until the tone counts as forgotten.
};

}  // namespace perilymph::gui
