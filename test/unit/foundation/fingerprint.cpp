// SPDX-License-Identifier: BSD-3-Clause

// Prints fingerprints of many results: of perilymph's own functions, and of the C library's.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "perilymph/foundation/Hash.h"
#include "perilymph/foundation/Math.h"

int main()
{
  perilymph::Hash own;
  perilymph::Hash library;
  std::mt19937_64 bits(20);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  };
  for (int i = 0; i < 200000; ++i) {
    const double x = between(-700.0, 700.0);
    const double y = between(1e-3, 1e3);
    own.add(perilymph::exponential(x));
    own.add(perilymph::logarithm(y));
    own.add(perilymph::sineCosine(x).sine);
    own.add(perilymph::sineCosine(x).cosine);
    own.add(perilymph::arcTangent(x, y));
    own.add(perilymph::power(y, x / 700.0));

    library.add(std::exp(x));
    library.add(std::log(y));
    library.add(std::sin(x));
    library.add(std::cos(x));
    library.add(std::atan2(x, y));
    library.add(std::pow(y, x / 700.0));
  }
  std::printf("own %016llx\nlibrary %016llx\n", static_cast<unsigned long long>(own.value()),
              static_cast<unsigned long long>(library.value()));
}
