// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <string>

#include "Commands.h"
#include "Terminal.h"
#include "perilymph/ct/Markups.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Normal.h"
#include "perilymph/session/PatientRecord.h"
#if PERILYMPH_HAS_TOOLKIT
#include "perilymph/imaging/MarkupFiles.h"
#endif

namespace perilymph::cli {

#if PERILYMPH_HAS_TOOLKIT

namespace {

/// The markups of the series that a call names by its hash or the beginning of it; of the only one without.
Result<ct::CtMarkups> chosenMarkups(const CtMarkupsOptions& options)
{
  if (const auto there = readWhole(options.patient); !there) return there.error();
  const auto record = session::loadPatientRecord(options.patient);
  if (!record) return record.error();
  if (record->markups.empty())
    return Error{
        "%1 has no markups in its record. Place some on the page CT, with this patient's code.",
        options.patient};
  const ct::CtMarkups* chosen = nullptr;
  for (const ct::CtMarkups& each : record->markups) {
    if (!each.seriesKey.starts_with(options.series)) continue;
    if (chosen != nullptr)
      return Error{"%1 has markups of several CT series. Choose one by --series, e.g. --series %2.",
                   options.patient, each.seriesKey};
    chosen = &each;
  }
  if (chosen == nullptr)
    return Error{"%1 has no markups of the CT series %2. Give one of its own, e.g. --series %3.",
                 options.patient, options.series, record->markups.front().seriesKey};
  return *chosen;
}

}  // namespace

Result<void> ctMarkups(const CtMarkupsOptions& options)
{
  const auto markups = chosenMarkups(options);
  if (!markups) return markups.error();
  const Writing owned{Links::followed, Audience::owner};  // notes may describe a patient
  if (!options.json.empty())
    if (const auto done = writeWhole(options.json, imaging::markupsJson(*markups), owned); !done)
      return done;
  if (!options.markups.empty())
    if (const auto done = writeWhole(options.markups, imaging::slicerMarkups(*markups), owned);
        !done)
      return done;
  if (!options.csv.empty()) {
    if (const auto done = writeWhole(options.csv, imaging::markupsCsv(*markups), owned); !done)
      return done;
    std::filesystem::path dictionary = options.csv;
    dictionary.replace_filename(dictionary.stem().string() + "-dictionary.csv");
    if (const auto done = writeWhole(dictionary, imaging::markupsDictionaryCsv()); !done)
      return done;
  }
  print("CT series {}\n", markups->seriesKey);
  std::size_t number = 0;
  for (const ct::Markup& each : markups->markups) {
    const char* kind = nameIn(ct::markupKinds, each.kind);
    const auto value = ct::valueOf(each, markups->voxelEdges_P);
    const bool isAngle = each.kind == ct::MarkupKind::angle;
    if (value)
      print("{:>3} {:15} {} ± {} {} (95 %)\n", ++number, kind, fixed(value->value, isAngle ? 1 : 2),
            fixed(halfWidth95 * value->sd, isAngle ? 1 : 2), isAngle ? "degrees" : "mm");
    else
      print("{:>3} {:15} points: {}\n", ++number, kind, each.points_P.size());
  }
  return {};
}

#else

Result<void> ctMarkups(const CtMarkupsOptions&)
{
  return Error{
      "This build has no VTK, so it cannot write markups; use a build of the preset release."};
}

#endif

}  // namespace perilymph::cli
