// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/CoverageReference.h"

#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/TomlReader.h"

namespace perilymph::gui {

Result<CoverageReference> coverageReference()
{
  auto reader = TomlReader::open(resource("resources/planning/coverage.toml"));
  if (!reader) return reader.error();
  reader->text("label");
  CoverageReference reference;
  reference.low_percent = reader->number("low_percent", {0.0, 100.0});
  reference.high_percent = reader->number("high_percent", {reference.low_percent, 100.0});
  reference.source = reader->text("source");
  reference.confidence = reader->choice("confidence", {"high", "medium", "low"});
  if (const auto done = reader->finish(); !done) return done.error();
  return reference;
}

}  // namespace perilymph::gui
