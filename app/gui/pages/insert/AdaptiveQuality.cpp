// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/AdaptiveQuality.h"

#include <utility>

#include "gui/scene/RendererName.h"

namespace perilymph::gui {

using visualization::Quality;

namespace {

constexpr std::pair<const char*, QualityChoice> names[] = {{"auto", std::nullopt},
                                                           {"fast", Quality::fast},
                                                           {"balanced", Quality::software},
                                                           {"full", Quality::gpu}};

}  // namespace

std::string nameOf(QualityChoice choice)
{
  for (const auto& [name, named] : names)
    if (named == choice) return name;
  return {};
}

std::optional<QualityChoice> qualityNamed(const std::string& name)
{
  for (const auto& [word, choice] : names)
    if (name == word) return choice;
  return std::nullopt;
}

AdaptiveQuality::AdaptiveQuality(const std::string& renderer)
    : initial_(isSoftwareRenderer(renderer) ? Quality::software : Quality::gpu), measured_(initial_)
{
}

void AdaptiveQuality::choose(QualityChoice choice) { choice_ = choice; }

Quality AdaptiveQuality::quality() const
{
  return choice_.value_or(isResting_ ? initial_ : measured_);
}

bool AdaptiveQuality::rest(bool isResting)
{
  const Quality before = quality();
  isResting_ = isResting;
  return quality() != before;
}

bool AdaptiveQuality::weigh(std::size_t frames, double span_s, double median_ms)
{
  if (choice_ || isDecided_ || frames < minFrames || span_s < firstSecond_s) return false;
  isDecided_ = true;
  if (median_ms <= slowFrame_ms || measured_ == Quality::fast) return false;
  measured_ = measured_ == Quality::gpu ? Quality::software : Quality::fast;
  return true;
}

}  // namespace perilymph::gui
