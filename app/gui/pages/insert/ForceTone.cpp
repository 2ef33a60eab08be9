// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/ForceTone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace perilymph::gui {

namespace {

constexpr Force quietest = millinewtons(5);
constexpr Force perOctave = millinewtons(100);
constexpr double lowest_Hz = 220.0;
constexpr double maxOctaves = 4.0;
constexpr double change_s = 0.01;
constexpr double forgotten_s = 0.25;
constexpr double amplitude = 0.2 * 32767.0;  // the speaker has its own volume control

}  // namespace

Tone toneOf(Force onHand)
{
  const double force = std::fabs(onHand.si());
  if (!(force >= quietest.si())) return {};  // includes NaN
  return {lowest_Hz * std::exp2(std::min(maxOctaves, force / perOctave.si())), 1.0};
}

void ToneWriter::setTone(const Tone& tone)
{
  wished_ = tone;
  left_ = int(forgotten_s * samplesPerSecond);
}

void ToneWriter::write(std::int16_t* samples, int count)
{
  constexpr double fraction = 1.0 / (change_s * samplesPerSecond);
  for (int i = 0; i < count; ++i) {
    left_ = std::max(0, left_ - 1);
    const double loudness = left_ > 0 ? wished_.loudness : 0.0;
    loudness_ += std::clamp(loudness - loudness_, -fraction, fraction);
    if (wished_.frequency_Hz > 0.0) {
      // after silence a tone starts at its pitch
      if (frequency_Hz_ == 0.0) frequency_Hz_ = wished_.frequency_Hz;
      frequency_Hz_ += fraction * (wished_.frequency_Hz - frequency_Hz_);
    }
    if (loudness_ == 0.0) frequency_Hz_ = 0.0;
    phase_ += frequency_Hz_ / samplesPerSecond;
    phase_ -= std::floor(phase_);
    samples[i] = static_cast<std::int16_t>(amplitude * loudness_ *
                                           std::sin(2.0 * std::numbers::pi * phase_));
  }
}

}  // namespace perilymph::gui
