#include "perilymph/visualization/Wording.h"

#include <utility>

namespace perilymph::visualization {

namespace {

Wording& current()
{
  static Wording words;
  return words;
}

}  // namespace

void setWording(Wording wording) { current() = std::move(wording); }
const Wording& wording() { return current(); }

}  // namespace perilymph::visualization
