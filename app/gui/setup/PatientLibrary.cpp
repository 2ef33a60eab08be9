// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PatientLibrary.h"

#include <QCoreApplication>
#include <QStringList>
#include <system_error>
#include <utility>

#include "gui/text/Numbers.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/foundation/UtcTime.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

// lupdate assigns texts of free functions to their namespace.
QString tr(const char* text) { return QCoreApplication::translate("perilymph::gui", text); }

QString earText(anatomy::Side side)
{
  return side == anatomy::Side::left ? tr("left ear") : tr("right ear");
}

fs::path fileOf(const anatomy::Patient& patient)
{
  const char* ear = anatomy::nameOf(patient.side);
  return patientFolder() / (patient.label + "-" + ear + ".toml");
}

}  // namespace

std::vector<SavedPatient> savedPatients()
{
  return session::readPatients(patientFolder()).patients;
}

std::optional<SavedPatient> findSavedPatient(const std::string& code, anatomy::Side side)
{
  for (SavedPatient& each : savedPatients())
    if (each.patient.label == code && each.patient.side == side) return std::move(each);
  return std::nullopt;
}

bool isMeasuredInCt(const anatomy::Patient& patient)
{
  if (!patient.origin.seriesKey.empty()) return true;
  const auto saved = findSavedPatient(patient.label, patient.side);
  return saved && !saved->patient.origin.seriesKey.empty();
}

fs::path libraryFileOf(const anatomy::Patient& patient)
{
  const auto known = findSavedPatient(patient.label, patient.side);
  return known ? known->file : fileOf(patient);
}

Result<fs::path> savePatientInLibrary(const anatomy::Patient& patient,
                                      const std::optional<fs::path>& replaced)
{
  if (const auto code = anatomy::checkPatientCode(patient.label); !code) return code.error();
  if (const auto possible = anatomy::checkPatient(patient); !possible) return possible.error();
  const auto known = findSavedPatient(patient.label, patient.side);
  if (known && known->file != replaced)
    return Error{tr("%1 is saved already; open that patient, or use another code.")
                     .arg(nameOfPatient(patient))
                     .toStdString()};
  const fs::path file = libraryFileOf(patient);
  std::error_code ignored;  // an error is reported when the file is written
  fs::create_directories(file.parent_path(), ignored);
  const bool isRenamed = replaced && *replaced != file;
  const fs::path record = session::recordFileOf(file);
  if (isRenamed && fs::exists(record, ignored))
    return Error{
        "%1 holds notes on a patient of this code and ear whose file is missing. Rename it first.",
        record};
  // a copy: the former file is whole until the new one is
  if (isRenamed) fs::copy_file(session::recordFileOf(*replaced), record, ignored);
  const auto saved = session::savePatientVersion(
      patient, file, {utcNow(), {}, {}, anatomy::unusualMeasures(patient)}, !known);
  if (!saved) {
    if (isRenamed) fs::remove(record, ignored);
    return saved.error();
  }
  if (isRenamed) {
    fs::remove(session::recordFileOf(*replaced), ignored);
    fs::remove(*replaced, ignored);
  }
  return file;
}

void markUsed(const fs::path& file)
{
  std::error_code ignored;  // only the order of the list depends on it
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
}

QString nameOfPatient(const anatomy::Patient& patient)
{
  return tr("%1 · %2").arg(QString::fromStdString(patient.label), earText(patient.side));
}

QString tagsText(const session::PatientRecord& record)
{
  QStringList tags;
  for (const std::string& tag : record.tags) tags << QString::fromStdString(tag);
  return tags.join(QStringLiteral(", "));
}

QString handChange(const anatomy::Patient& patient)
{
  return patient.seal == Seal::changed ? tr(" · measures changed by hand") : QString();
}

QString numbersOfPatient(const anatomy::Patient& patient)
{
  const auto text = [](Length length) { return numberText(inMillimeters(length), 2); };
  QString numbers;
  if (const auto& turn = patient.basalTurn)
    numbers = turn->h ? tr("A %1, B %2, H %3 mm").arg(text(turn->a), text(turn->b), text(*turn->h))
                      : tr("A %1, B %2 mm").arg(text(turn->a), text(turn->b));
  else
    numbers = tr("scala %1 mm, section %2 × %3 mm")
                  .arg(text(patient.scalaTympaniLength), text(patient.roundWindowWidth),
                       text(patient.roundWindowHeight));
  return patient.seal == Seal::changed ? tr("changed by hand: %1").arg(numbers) : numbers;
}

}  // namespace perilymph::gui
