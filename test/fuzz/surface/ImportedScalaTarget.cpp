// SPDX-License-Identifier: BSD-3-Clause

// Fuzzes the import with small changes to the surface of a scala tympani: points moved or made
// infinite, triangles reversed, duplicated or given wrong corners.

#include <cmath>
#include <cstring>
#include <limits>

#include "FuzzTarget.h"
#include "perilymph/anatomy/ImportedScala.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::fuzz {

namespace {

using anatomy::Surface;

/// The published scala tympani as a coarse surface.
const Surface& scala()
{
  static const Surface surface =
      anatomy::wallSurface(*anatomy::buildPublished(anatomy::Patient(), millimeters(1)), 1500);
  return surface;
}

double oddNumber(InputReader& input)
{
  switch (input.byte() % 8) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return 1e300;
    case 3:
      return 0.0;
    default:
      return 1e-4 * (input.byte() - 128);
  }
}

std::size_t place(InputReader& input, std::size_t count)
{
  const std::size_t high = input.byte();
  return count == 0 ? 0 : (high << 8 | input.byte()) % count;
}

void change(Surface& surface, InputReader& input)
{
  const std::size_t point = place(input, surface.points.size());
  const std::size_t triangle = place(input, surface.triangles.size());
  const std::size_t corner = input.byte() % 3;
  if (surface.points.empty() || surface.triangles.empty()) return;
  switch (input.byte() % 8) {
    case 0:
      surface.points[point][corner] = oddNumber(input);
      break;
    case 1:
      surface.triangles[triangle][corner] = static_cast<int>(point);
      break;
    case 2:
      std::swap(surface.triangles[triangle][0], surface.triangles[triangle][1]);
      break;
    case 3:
      surface.triangles.push_back(surface.triangles[triangle]);
      break;
    case 4:
      surface.triangles.erase(surface.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
      break;
    case 5: {  // scale everything: larger, smaller, flat or inside out
      const double factor = 0.02 * (input.byte() - 50);
      for (auto& each : surface.points) each[corner] *= factor;
      break;
    }
    case 6:  // make a hole
      surface.triangles.resize(triangle);
      break;
    default:  // refer to a missing corner
      surface.triangles[triangle][corner] = input.byte() % 2 ? -1 : 1 << 30;
      break;
  }
}

}  // namespace

std::vector<Bytes> seeds()
{
  // No change, one point moved, one triangle removed, everything flat.
  return {{}, {0, 100, 0, 0, 1, 0, 7, 200}, {0, 0, 1, 0, 0, 4}, {0, 0, 0, 0, 2, 5, 50}};
}

}  // namespace perilymph::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace perilymph;
  fuzz::InputReader input({data, size});
  anatomy::Surface surface = fuzz::scala();
  for (int i = 0; i < 8 && !input.isEmpty(); ++i) fuzz::change(surface, input);
  const auto imported = anatomy::importScala(surface);
  if (!imported) {
    fuzz::promise(!imported.error().message.empty(), "a refusal has a sentence");
    return 0;
  }
  for (const Length length : {imported->a, imported->b, imported->h})
    fuzz::promise(std::isfinite(length.si()) && length.si() > 0.0, "a measure is a length");
  fuzz::promise(std::isfinite(imported->volume) && imported->volume > 0.0, "a volume");
  return 0;
}
