#pragma once

// Which tier of drawing the machine can keep up with.

#include <optional>
#include <string>

#include "gui/pages/insert/ViewMenu.h"

namespace perilymph::gui {

/// The words of a choice: "auto", "fast", "balanced", "full".
std::string nameOf(QualityChoice choice);
/// The choice of such a word; nothing for another one.
std::optional<QualityChoice> qualityNamed(const std::string& name);

/// Begins with what the renderer promises, and steps down once when the first second of frames took
/// too long. A tier chosen by hand stays.
class QualityPilot {
public:
  /// Frames that the decision waits for, over at least so long.
  static constexpr std::size_t minFrames = 15;
  static constexpr double firstSecond_s = 1.0;
  /// A median above this is too slow: 15 frames a second.
  static constexpr double slowFrame_ms = 66.0;

  /// @param renderer  What OpenGL calls itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
  explicit QualityPilot(const std::string& renderer = {});

  void choose(QualityChoice choice);
  QualityChoice choice() const { return choice_; }
  visualization::Quality quality() const;

  /// What the first frames took. @return Whether the tier changed.
  bool weigh(std::size_t frames, double span_s, double median_ms);

  /// Whether a renderer of this name draws on the CPU.
  static bool isSoftware(const std::string& renderer);

private:
  QualityChoice choice_;
  visualization::Quality measured_;
  bool isDecided_ = false;
};

}  // namespace perilymph::gui
