// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Sizes of type that is read from a distance.

class QScreen;

namespace perilymph::gui {

/// Distance of visitors from the screen [mm].
inline constexpr double visitorDistance_mm = 1500.0;
/// Visual angle of a capital letter [minutes of arc]: the least for reading, and what is preferred
/// (ISO 9241-3 and 9241-303; NUREG-0700, 1.3.1-4). Footnotes may be smaller.
inline constexpr double minLetter_arcmin = 16.0;
inline constexpr double preferredLetter_arcmin = 20.0;

/// Height of what is seen under an angle from a distance [mm].
double heightSeen_mm(double angle_arcmin, double distance_mm);

/// Size of type whose capitals are seen under an angle by visitors [px, before textScale()].
///
/// @param pitch_mm  Distance of two (logical) pixels of the screen.
int letterSize_px(double angle_arcmin, double pitch_mm);

/// Distance of two (logical) pixels of a screen, by its stated size [mm]. A screen without one, such as
/// a projector, counts as one of 96 pixels per inch.
double pixelPitch_mm(const QScreen* screen);

}  // namespace perilymph::gui
