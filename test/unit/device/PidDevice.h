// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The firmware of a force-feedback stick with the descriptor pidDescriptor(). It decodes the bytes
// itself and shares no code with the program.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hid/Transport.h"

namespace perilymph::device::test {

class PidDevice final : public Transport {
public:
  struct Effect {
    bool exists = false;
    bool isConstantForce = false;
    bool isRunning = false;
    bool hasDirection = false;
    unsigned axes = 0;  ///< Enable bits: 1 X, 2 Y.
    int direction = 0;  ///< 0 to 255.
    int magnitude = 0;  ///< -10000 to 10000.
    int duration = 0;
    int gain = 0;
  };

  std::array<Effect, 8> effects{};  ///< By block; block 0 is none.
  std::size_t capacity = 3;         ///< Effects that fit.
  bool actuatorsOn = true;          ///< As left by another program.
  int gain = 7;
  std::vector<std::string> story;  ///< The requests in words.
  int slowAnswers = 0;          ///< Block loads that are answered with an error before one works.
  int writesBeforeUnplug = -1;  ///< -1: it stays plugged in.

  Transfer read(RawReport&, Duration) noexcept override { return Transfer::nothing; }

  Transfer write(const RawReport& report) noexcept override
  {
    if (writesBeforeUnplug == 0) return Transfer::gone;
    if (writesBeforeUnplug > 0) --writesBeforeUnplug;
    const auto& b = report.bytes;
    switch (b[0]) {
      case 0x11:
        return report.size == 12 ? setEffect(b) : Transfer::failed;
      case 0x15:
        if (report.size != 4 || !knows(b[1])) return Transfer::failed;
        effects[b[1]].magnitude = static_cast<std::int16_t>(b[2] | b[3] << 8);
        story.push_back("force");
        return Transfer::done;
      case 0x1a:
        if (report.size != 4 || !knows(b[1])) return Transfer::failed;
        effects[b[1]].isRunning = b[2] != 3 && b[3] > 0;
        story.push_back(b[2] == 3 ? "stop" : "start");
        return Transfer::done;
      case 0x1b:
        if (report.size != 2 || !knows(b[1])) return Transfer::failed;
        effects[b[1]] = {};
        story.push_back("free");
        return Transfer::done;
      case 0x1c:
        return report.size == 2 ? control(b[1]) : Transfer::failed;
      case 0x1d:
        gain = b[1];
        story.push_back("gain");
        return report.size == 2 ? Transfer::done : Transfer::failed;
      default:
        return Transfer::failed;
    }
  }

  Transfer setFeature(const RawReport& report) noexcept override
  {
    if (writesBeforeUnplug == 0) return Transfer::gone;
    if (report.bytes[0] != 0x21 || report.size != 4) return Transfer::failed;
    created_ = 0;
    for (std::size_t block = 1; block <= capacity && created_ == 0; ++block)
      if (!effects[block].exists) created_ = block;
    if (created_ != 0)
      effects[created_] = {true, report.bytes[1] == 2, false, false, 0, 0, 0, 0, 0};
    story.push_back("create");
    return Transfer::done;
  }

  Transfer getFeature(RawReport& report) noexcept override
  {
    if (report.bytes[0] != 0x22 || report.size != 5) return Transfer::failed;
    const bool isSlow = slowAnswers > 0;
    if (isSlow) --slowAnswers;
    report.bytes[1] = static_cast<std::uint8_t>(isSlow ? 0 : created_);
    report.bytes[2] = isSlow ? 3 : created_ != 0 ? 1 : 2;  // error, success, full
    return Transfer::done;
  }

  /// Sum of the running effects along X and Y, as fractions of the maximum force.
  std::array<double, 2> shown() const
  {
    std::array<double, 2> sum{};
    if (!actuatorsOn) return sum;
    for (const Effect& effect : effects) {
      if (!effect.isRunning || !effect.isConstantForce) continue;
      const double fraction = effect.magnitude / 10000.0;
      if (effect.hasDirection) {
        // Where it comes from, clockwise from north (DirectInput, "Effect Direction"): from the
        // north it pushes along +Y, toward the user; from the east along -X.
        const double angle = effect.direction / 255.0 * 6.283185307179586;
        sum[0] -= fraction * sine(angle);
        sum[1] += fraction * sine(angle + 1.5707963267948966);
      } else {
        if ((effect.axes & 1u) != 0) sum[0] += fraction;
        if ((effect.axes & 2u) != 0) sum[1] += fraction;
      }
    }
    return sum;
  }

private:
  static double sine(double angle);

  bool knows(std::size_t block) const
  {
    return block > 0 && block <= capacity && effects[block].exists;
  }

  Transfer setEffect(const std::array<std::uint8_t, longestReport>& b)
  {
    if (!knows(b[1])) return Transfer::failed;
    Effect& effect = effects[b[1]];
    effect.isConstantForce = b[2] == 2;
    effect.duration = b[3] | b[4] << 8;
    effect.gain = b[5];
    effect.axes = b[7] & 3u;
    effect.hasDirection = (b[7] & 4u) != 0;
    effect.direction = b[8];
    story.push_back("effect");
    return Transfer::done;
  }

  Transfer control(std::uint8_t what)
  {
    constexpr std::array<const char*, 5> words{"?", "disable", "enable", "stop all", "reset"};
    if (what == 0 || what > 4) return Transfer::failed;
    if (what <= 2) actuatorsOn = what == 2;
    if (what == 3)
      for (Effect& effect : effects) effect.isRunning = false;
    if (what == 4) effects = {};
    story.emplace_back(words[what]);
    return Transfer::done;
  }

  std::size_t created_ = 0;
};

inline double PidDevice::sine(double angle) { return __builtin_sin(angle); }

}  // namespace perilymph::device::test
