// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PlanStore.h"

#include "gui/setup/Setup.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

namespace {

namespace fs = std::filesystem;

constexpr const char* notesFile = "notes.txt";
constexpr std::size_t keyLength = 8;  // hexadecimal digits

}  // namespace

fs::path folderOfPlan(const planning::PlanRequest& request)
{
  Sha256 hash;
  const auto add = [&hash](const std::string& text) {
    hash.add(std::to_string(text.size()) + ":" + text);
  };
  add(buildId());
  // a request that cannot be planned gets a folder, too, and then an error
  const auto fingerprint = planning::fingerprintOf(request);
  add(fingerprint ? *fingerprint : fingerprint.error().message);
  const char* ear = request.patient.side == anatomy::Side::left ? "-left-" : "-right-";
  return plansFolder() /
         (fileNameOf(request.patient.label) + ear + hash.hex().substr(0, keyLength));
}

std::vector<StoredPlan> storedPlans() { return planning::planFoldersIn(plansFolder()).plans; }

QString notesOf(const fs::path& folder)
{
  const auto notes = readWhole(folder / notesFile);
  return notes ? QString::fromStdString(*notes) : QString();
}

Result<void> saveNotes(const fs::path& folder, const QString& notes)
{
  return writeWhole(folder / notesFile, notes.toStdString());
}

}  // namespace perilymph::gui
