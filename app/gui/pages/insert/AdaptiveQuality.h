// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Automatic selection of the rendering quality.

#include <optional>
#include <string>

#include "gui/pages/insert/ViewMenu.h"

namespace perilymph::gui {

/// Name of a choice: "auto", "fast", "balanced", "full".
std::string nameOf(QualityChoice choice);
/// The choice with such a name; empty for other names.
std::optional<QualityChoice> qualityNamed(const std::string& name);

/// Starts with the quality suitable for the renderer, and reduces it once if the first second of
/// frames is too slow. A quality selected by the user is kept.
class AdaptiveQuality {
public:
  /// Minimum number of frames and time before the decision.
  static constexpr std::size_t minFrames = 15;
  static constexpr double firstSecond_s = 1.0;
  /// Maximum median frame time: 30 frames per second.
  static constexpr double slowFrame_ms = 33.3;

  /// @param renderer  Name of the OpenGL renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
  explicit AdaptiveQuality(const std::string& renderer = {});

  /// At rest the initial quality is restored, as time does not matter then.
  /// @return Whether the quality changed.
  bool rest(bool isResting);

  void choose(QualityChoice choice);
  QualityChoice choice() const { return choice_; }
  visualization::Quality quality() const;

  /// Evaluates the first frames. @return Whether the quality changed.
  bool weigh(std::size_t frames, double span_s, double median_ms);

private:
  QualityChoice choice_;
  visualization::Quality initial_, measured_;
  bool isDecided_ = false;
  bool isResting_ = false;
};

}  // namespace perilymph::gui
