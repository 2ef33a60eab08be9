// SPDX-License-Identifier: BSD-3-Clause
#include "PlanFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::planning {

namespace {

namespace fs = std::filesystem;
using database::Database;
using database::Statement;
using haptics::InsertionEnd;
using Row = nlohmann::json;

const database::FileKind& planKind()
{
  static const database::FileKind kind = {
      "the draws of a plan of Perilymph",
      "Choose a draws.sqlite that 'perilymph-cli plan' wrote.",
      "Delete it and make the plan again.",
      0x5065506c,  // "PePl"
      2,
      {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
       "CREATE TABLE insertion(draw INTEGER NOT NULL, array INTEGER NOT NULL, content TEXT NOT "
       "NULL, "
       "PRIMARY KEY(draw, array)) WITHOUT ROWID"}};
  return kind;
}

bool isDone(Statement& statement)
{
  const bool done = statement.step() == Statement::Step::done;
  statement.reset();
  return done;
}

/// Creates an empty file: a file with the final name is whole or does not exist.
Result<Done> create(const fs::path& file, const std::string& fingerprint)
{
  const auto failed = [&file](const std::string& reason) {
    return Error{file.string() + " cannot be created: " + reason +
                 ". Check the folder's permissions and the space on the disk."};
  };
  const std::string unfinished = unfinishedPath(file).string();
  const int descriptor =
      ::open(unfinished.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor < 0) return failed("its folder takes no file");
  ::close(descriptor);
  const auto written = [&]() -> Result<Done> {
    auto opened = Database::openNew(unfinished);
    if (!opened) return opened.error();
    if (const auto done = opened->run(database::creationOf(planKind())); !done) return done;
    auto insert = opened->prepare("INSERT INTO meta VALUES(?,?)");
    if (!insert) return insert.error();
    for (const auto& [key, value] :
         {std::pair<std::string, std::string>{"fingerprint", fingerprint},
          std::pair<std::string, std::string>{"program", buildId()}}) {
      insert->bind(0, key);
      insert->bind(1, value);
      if (!isDone(*insert)) return Error{opened->lastError()};
    }
    return opened->run("COMMIT");
  }();
  const bool isLinked = written && ::link(unfinished.c_str(), file.c_str()) == 0;
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  if (!written) return failed(written.error().message);
  if (!isLinked) return failed("there is one already, or its file system has no hard links");
  return Done{};
}

Row contactJson(const analysis::ContactPosition& contact)
{
  return Row::array({contact.isInserted, contact.depth.si(), contact.angle.si(), contact.coverage,
                     contact.frequency_Hz, contact.toModiolus.si()});
}

/// Largest magnitude of a value; no angle, length, frequency or force of an insertion comes near it.
constexpr double maxStoredValue = 1e9;
/// Depth beyond every array: a duct is 45 mm long [m].
constexpr double maxDepth = 0.1;
constexpr std::size_t maxContacts = 1024, maxProfile = 4096;

/// Thrown within this file only: a value that no insertion has.
struct Impossible {};

/// A number of at most this magnitude.
double numberIn(const Row& value, double magnitude = maxStoredValue)
{
  const double number = value.get<double>();
  if (!(std::fabs(number) <= magnitude)) throw Impossible();
  return number;
}

std::size_t countIn(const Row& value)
{
  if (!value.is_number_unsigned()) throw Impossible();
  return value.get<std::size_t>();
}

const Row& listIn(const Row& value, std::size_t maxSize)
{
  if (!value.is_array() || value.size() > maxSize) throw Impossible();
  return value;
}

analysis::ContactPosition contactIn(const Row& values, int number)
{
  analysis::ContactPosition contact;
  contact.number = number;
  contact.isInserted = values.at(0).get<bool>();
  contact.depth = meters(numberIn(values.at(1)));
  contact.angle = radians(numberIn(values.at(2)));
  contact.coverage = numberIn(values.at(3));
  contact.frequency_Hz = numberIn(values.at(4));
  contact.toModiolus = meters(numberIn(values.at(5)));
  return contact;
}

}  // namespace

std::string contentOf(const PlannedInsertion& planned)
{
  const analysis::ClinicalInsertion& found = planned.insertion;
  Row contacts = Row::array(), depths = Row::array(), forces = Row::array();
  for (const auto& contact : found.contacts) contacts.push_back(contactJson(contact));
  for (const auto& point : found.profile) {
    depths.push_back(point.depth.si());
    forces.push_back(point.force.si());
  }
  return Row{{"draw", planned.draw},
             {"array", planned.array},
             {"a_mm", planned.a_mm},
             {"b_mm", planned.b_mm},
             {"h_mm", planned.h_mm},
             {"a1_deviate", planned.a1_deviate},
             {"b1_deviate", planned.b1_deviate},
             {"section", planned.section},
             {"section_second", planned.sectionSecond},
             {"dip_mm", planned.dip_mm},
             {"radius", planned.radius},
             {"height", planned.height},
             {"lining_mm", planned.lining_mm},
             {"membrane_N_m", planned.membrane_N_m},
             {"tilt_deg", planned.tilt_deg},
             {"turn_deg", planned.turn_deg},
             {"stiffness", planned.stiffness},
             {"friction", planned.friction},
             {"speed_mm_s", planned.speed_mm_s},
             {"stop_mN", planned.stop_mN},
             {"end", haptics::nameOf(found.end)},
             {"reason", found.reason},
             {"depth", found.depth.si()},
             {"apical", found.apical.si()},
             {"peak", found.peak.si()},
             {"end_force", found.endForce.si()},
             {"membrane", found.membrane.si()},
             {"is_ruptured", found.isRuptured},
             {"is_translocated", found.isTranslocated},
             {"rupture_angle", found.ruptureAngle.si()},
             {"contacts", contacts},
             {"profile_depth", depths},
             {"profile_force", forces}}
      .dump();
}

std::optional<PlannedInsertion> insertionIn(const std::string& content)
{
  const Row row = Row::parse(content, nullptr, false);
  if (!row.is_object()) return std::nullopt;
  try {
    PlannedInsertion planned;
    planned.draw = countIn(row.at("draw"));
    planned.array = countIn(row.at("array"));
    for (const auto& [key, value] :
         {std::pair{"a_mm", &planned.a_mm}, std::pair{"b_mm", &planned.b_mm},
          std::pair{"h_mm", &planned.h_mm}, std::pair{"a1_deviate", &planned.a1_deviate},
          std::pair{"b1_deviate", &planned.b1_deviate}, std::pair{"section", &planned.section},
          std::pair{"lining_mm", &planned.lining_mm},
          std::pair{"membrane_N_m", &planned.membrane_N_m},
          std::pair{"tilt_deg", &planned.tilt_deg}, std::pair{"turn_deg", &planned.turn_deg},
          std::pair{"stiffness", &planned.stiffness}, std::pair{"friction", &planned.friction},
          std::pair{"speed_mm_s", &planned.speed_mm_s}, std::pair{"stop_mN", &planned.stop_mN}})
      *value = numberIn(row.at(key));
    // not in files of former versions, which drew one factor for all sections
    planned.sectionSecond = planned.section;
    for (const auto& [key, value] :
         {std::pair{"section_second", &planned.sectionSecond}, std::pair{"dip_mm", &planned.dip_mm},
          std::pair{"radius", &planned.radius}, std::pair{"height", &planned.height}})
      if (row.contains(key)) *value = numberIn(row.at(key));
    analysis::ClinicalInsertion& found = planned.insertion;
    found.end = haptics::endNamed(row.at("end").get<std::string>());
    if (found.end == InsertionEnd::none) return std::nullopt;
    found.reason = row.at("reason").get<std::string>();
    found.depth = meters(numberIn(row.at("depth")));
    found.apical = radians(numberIn(row.at("apical")));
    found.peak = newtons(numberIn(row.at("peak")));
    found.endForce = newtons(numberIn(row.at("end_force")));
    found.membrane = newtons(numberIn(row.at("membrane")));
    found.isRuptured = row.at("is_ruptured").get<bool>();
    // plans of before counted forces alone
    found.isTranslocated = row.value("is_translocated", false);
    found.ruptureAngle = radians(numberIn(row.value("rupture_angle", Row(0.0))));
    for (const Row& contact : listIn(row.at("contacts"), maxContacts))
      found.contacts.push_back(contactIn(contact, static_cast<int>(found.contacts.size()) + 1));
    const Row& depths = listIn(row.at("profile_depth"), maxProfile);
    const Row& forces = listIn(row.at("profile_force"), maxProfile);
    for (std::size_t i = 0; i < depths.size(); ++i)
      found.profile.push_back(
          {meters(numberIn(depths.at(i), maxDepth)), newtons(numberIn(forces.at(i)))});
    return planned;
  } catch (const Row::exception&) {
    return std::nullopt;  // a member is missing or of another type
  } catch (const Impossible&) {
    return std::nullopt;
  }
}

Result<PlanFile> PlanFile::open(const fs::path& file, const std::string& fingerprint)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    if (const auto done = create(file, fingerprint); !done) return done.error();
  auto opened = Database::openToAppend(file, planKind());
  if (!opened) return opened.error();
  PlanFile plan(*std::move(opened), file);
  // A commit survives the end of the process and of the machine.
  if (const auto done = plan.database_.run("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
      !done)
    return Error{file.string() + " cannot be continued: " + done.error().message + "."};
  if (const auto done = plan.check(fingerprint); !done) return done.error();
  return plan;
}

Result<PlanFile> PlanFile::openToView(const fs::path& file)
{
  auto opened = Database::open(file, planKind());
  if (!opened) return opened.error();
  return PlanFile(*std::move(opened), file);
}

Result<PlanFile::Origin> PlanFile::origin() const
{
  auto rows = database_.prepare("SELECT key, value FROM meta ORDER BY key");
  if (!rows) return database_.readingError(rows.error().message);
  Origin origin;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) {
    if (rows->text(0) == "fingerprint") origin.fingerprint = rows->text(1);
    if (rows->text(0) == "program") origin.program = rows->text(1);
  }
  if (step == Statement::Step::failed) return database_.readingError(database_.lastError());
  return origin;
}

Result<Done> PlanFile::check(const std::string& fingerprint) const
{
  const auto found = origin();
  if (!found) return found.error();
  const std::string remedy = " Delete it or give another folder.";
  if (found->fingerprint != fingerprint)
    return Error{
        file_.string() +
        " belongs to another plan, or the patient, an array, the scenario, "
        "resources/planning/uncertainty.toml, resources/planning/frequency-allocation.toml, "
        "resources/clinical/hand.toml or resources/reference/surgeons.toml was changed "
        "since." +
        remedy};
  if (found->program != buildId())
    return Error{file_.string() + " was begun by another build of the program (" + found->program +
                 "; this is " + buildId() + ")." + remedy};
  return Done{};
}

Result<std::vector<PlannedInsertion>> PlanFile::read() const
{
  auto rows = database_.prepare("SELECT draw, array, content FROM insertion ORDER BY draw, array");
  if (!rows) return database_.readingError(rows.error().message);
  std::vector<PlannedInsertion> all;
  std::size_t arrays = 0;  // of the first draw
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) {
    auto planned = insertionIn(rows->text(2));
    if (!planned || static_cast<std::int64_t>(planned->draw) != rows->integer(0) ||
        static_cast<std::int64_t>(planned->array) != rows->integer(1))
      return database_.readingError("draw " + std::to_string(rows->integer(0)) +
                                    " is not readable");
    if (planned->draw == 1 && planned->array == arrays) ++arrays;
    if (arrays == 0 || planned->draw != 1 + all.size() / arrays ||
        planned->array != all.size() % arrays)
      return database_.readingError("its draws are not consecutive");
    all.push_back(*std::move(planned));
  }
  if (step == Statement::Step::failed) return database_.readingError(database_.lastError());
  if (arrays > 0 && all.size() % arrays != 0)
    return database_.readingError("its last draw is not whole");
  return all;
}

Result<Done> PlanFile::append(const std::vector<PlannedInsertion>& insertions)
{
  auto insert = database_.prepare("INSERT INTO insertion VALUES(?,?,?)");
  std::string reason;
  if (insert && database_.run("BEGIN")) {
    const bool isWritten =
        std::all_of(insertions.begin(), insertions.end(), [&](const PlannedInsertion& each) {
          insert->bind(0, static_cast<std::int64_t>(each.draw));
          insert->bind(1, static_cast<std::int64_t>(each.array));
          insert->bind(2, contentOf(each));
          return isDone(*insert);
        });
    if (!isWritten) reason = database_.lastError();
    if (isWritten) {
      const auto done = database_.run("COMMIT");
      if (done) return Done{};
      reason = done.error().message;
    }
    static_cast<void>(database_.run("ROLLBACK"));
  } else {
    reason = database_.lastError();
  }
  return Error{file_.string() + " takes no more draws: " + reason +
               ". Those before are kept; make space and make the plan again."};
}

Result<Done> PlanFile::close()
{
  if (const auto done = database_.run("PRAGMA journal_mode=DELETE"); !done)
    return Error{file_.string() + " cannot be closed: " + done.error().message + "."};
  return Done{};
}

}  // namespace perilymph::planning
