// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The beam of a simulated CT, and what attenuates it.

#include <array>

namespace perilymph::test {

/// The beam's energies in bins, with attenuation per mm of water, of bone of 2 g/cm^3, of platinum and of
/// platinum with 10 % iridium.
struct XrayBeam {
  static constexpr std::size_t bins = 9;
  std::array<float, bins>
      weight{};  ///< Parts of the detected signal without an object; their sum is 1.
  std::array<float, bins> water{}, bone{}, platinum{}, wire{};

  /// Attenuation of water in a water-corrected image [1/mm].
  double reference() const;
  /// Intensity of a bone without metal of this density in such an image behind a head [HU].
  double boneHu() const;
};

/// A tube of 120 kV: Kramers' spectrum behind 6 mm of aluminum, an energy-integrating detector. The bins end at
/// the K-edges of iridium (76.1 keV) and platinum (78.4 keV).
XrayBeam tubeBeam();

}  // namespace perilymph::test
