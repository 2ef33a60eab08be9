// SPDX-License-Identifier: BSD-3-Clause
#include "PlanFile.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "perilymph/analysis/PhysicalRanges.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/planning/ResistanceGrid.h"

namespace perilymph::planning {

namespace {

using haptics::InsertionEnd;
using Row = nlohmann::json;

Row contactJson(const analysis::ContactPosition& contact)
{
  return Row::array({contact.isInserted, contact.depth.si(), contact.angle.si(), contact.coverage,
                     contact.frequency_Hz, contact.toModiolus.si()});
}

constexpr std::size_t maxContacts = 1024, maxProfile = 4096;

/// Thrown within this file only: why a row is of no insertion.
struct InvalidRow {
  std::string reason = "a value has another type";
};

std::size_t countIn(const Row& value)
{
  if (!value.is_number_unsigned()) throw InvalidRow();
  return value.get<std::size_t>();
}

const Row& listIn(const Row& value, std::size_t maxSize)
{
  if (!value.is_array() || value.size() > maxSize) throw InvalidRow();
  return value;
}

analysis::ContactPosition contactIn(const Row& values, int number)
{
  analysis::ContactPosition contact;
  contact.number = number;
  contact.isInserted = values.at(0).get<bool>();
  contact.depth = meters(values.at(1).get<double>());
  contact.angle = radians(values.at(2).get<double>());
  contact.coverage = values.at(3).get<double>();
  contact.frequency_Hz = values.at(4).get<double>();
  contact.toModiolus = meters(values.at(5).get<double>());
  return contact;
}

/// A number of a draw, and what it can be.
struct Drawn {
  const char* key;
  double PlannedInsertion::*value;
  Range range;
  bool isInAllVersions = true;  ///< Otherwise its default in files without it.
};
constexpr Range factor{0.0, 20.0}, deviates{-20.0, 20.0};
constexpr Drawn drawn[] = {
    {"a_mm", &PlannedInsertion::a_mm, analysis::physical::a_mm},
    {"b_mm", &PlannedInsertion::b_mm, analysis::physical::b_mm},
    {"h_mm",
     &PlannedInsertion::h_mm,
     {0.0, analysis::physical::h_mm.high}},  // 0: none was measured
    {"a1_deviate", &PlannedInsertion::a1_deviate, deviates},
    {"b1_deviate", &PlannedInsertion::b1_deviate, deviates},
    {"section", &PlannedInsertion::section, factor},
    {"section_second", &PlannedInsertion::sectionSecond, factor, false},
    {"dip_mm", &PlannedInsertion::dip_mm, {-10.0, 10.0}, false},
    {"radius", &PlannedInsertion::radius, factor, false},
    {"height", &PlannedInsertion::height, factor, false},
    {"lining_mm", &PlannedInsertion::lining_mm, {0.0, 5.0}},
    {"membrane_N_m", &PlannedInsertion::membrane_N_m, {0.0, 1e6}},
    {"tilt_deg", &PlannedInsertion::tilt_deg, {-180.0, 180.0}},
    {"turn_deg", &PlannedInsertion::turn_deg, {-180.0, 180.0}},
    {"stiffness", &PlannedInsertion::stiffness, factor},
    {"packing", &PlannedInsertion::packing, factor, false},
    {"last_contact_mm", &PlannedInsertion::lastContact_mm, {0.0, 2.0}, false},
    {"friction", &PlannedInsertion::friction, factor},
    {"speed_mm_s", &PlannedInsertion::speed_mm_s, {0.0, 1000.0}},
    {"stop_mN", &PlannedInsertion::stop_mN, analysis::physical::force_mN},
    {"intended_mm", &PlannedInsertion::intended_mm, analysis::physical::depth_mm, false},
    {"free_mm", &PlannedInsertion::free_mm, analysis::physical::depth_mm, false}};

/// The depths of a plan with a clinic's resistance.
void addStops(PlannedInsertion& planned, const Row& row)
{
  planned.push_mm = row.at("push_mm").get<double>();
  planned.isPushedFully = row.at("is_pushed_fully").get<bool>();
  const Row& stops = listIn(row.at("stop_mm"), stopShifts);
  if (stops.size() != stopShifts) throw InvalidRow{"its stops have gaps"};
  for (const Row& stop : stops) {
    planned.stop_mm.push_back(stop.is_null() ? std::numeric_limits<double>::infinity()
                                             : stop.get<double>());
    if (!stop.is_null() &&
        !analysis::isWithin(planned.stop_mm.back(), analysis::physical::depth_mm))
      throw InvalidRow{"a stop is at an impossible depth"};
  }
}

/// A force at rest, which insertions of first versions lack.
struct Rested {
  const char* key;
  std::optional<Force> analysis::ClinicalInsertion::*force;
};
constexpr Rested rested[] = {{"force_after_1s", &analysis::ClinicalInsertion::forceAfter1s},
                             {"force_after_10s", &analysis::ClinicalInsertion::forceAfter10s}};

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
  Row row{{"draw", planned.draw},
          {"array", planned.array},
          {"end", haptics::nameOf(found.end)},
          {"reason", found.reason},
          {"depth", found.depth.si()},
          {"apical", found.apical.si()},
          {"peak", found.peak.si()},
          {"end_force", found.endForce.si()},
          {"partition", found.partition.si()},
          {"is_ruptured", found.isRuptured},
          {"is_translocated", found.isTranslocated},
          {"rupture_angle", found.ruptureAngle.si()},
          {"contacts", contacts},
          {"profile_depth", depths},
          {"profile_force", forces}};
  for (const Drawn& each : drawn) row[each.key] = planned.*each.value;
  for (const Rested& each : rested)
    if (const auto& force = found.*each.force) row[each.key] = force->si();
  if (!planned.stop_mm.empty()) {
    row["push_mm"] = planned.push_mm;
    row["is_pushed_fully"] = planned.isPushedFully;
    Row stops = Row::array();  // null: the force stays below
    for (const double stop : planned.stop_mm)
      stops.push_back(std::isfinite(stop) ? Row(stop) : Row(nullptr));
    row["stop_mm"] = stops;
  }
  return row.dump();
}

Result<PlannedInsertion> insertionIn(const std::string& content)
{
  const Row row = Row::parse(content, nullptr, false);
  if (!row.is_object()) return Error{"it is not JSON"};
  try {
    PlannedInsertion planned;
    planned.draw = countIn(row.at("draw"));
    planned.array = countIn(row.at("array"));
    for (const Drawn& each : drawn) {
      if (!each.isInAllVersions && !row.contains(each.key)) {
        if (each.value == &PlannedInsertion::sectionSecond) planned.sectionSecond = planned.section;
        continue;
      }
      planned.*each.value = row.at(each.key).get<double>();
      if (auto reason = analysis::impossibility(each.key, "", planned.*each.value, each.range);
          !reason.empty())
        throw InvalidRow{std::move(reason)};
    }
    analysis::ClinicalInsertion& found = planned.insertion;
    found.end = haptics::endNamed(row.at("end").get<std::string>());
    if (found.end == InsertionEnd::none) throw InvalidRow{"its end has no known name"};
    found.reason = row.at("reason").get<std::string>();
    found.depth = meters(row.at("depth").get<double>());
    found.apical = radians(row.at("apical").get<double>());
    found.peak = newtons(row.at("peak").get<double>());
    found.endForce = newtons(row.at("end_force").get<double>());
    for (const Rested& each : rested)
      if (row.contains(each.key)) found.*each.force = newtons(row.at(each.key).get<double>());
    // version 0.2 kept the force on the membrane alone
    const char* const partition = row.contains("partition") ? "partition" : "membrane";
    found.partition = newtons(row.at(partition).get<double>());
    found.isRuptured = row.at("is_ruptured").get<bool>();
    // plans of before counted forces alone
    found.isTranslocated = row.value("is_translocated", false);
    found.ruptureAngle = radians(row.value("rupture_angle", 0.0));
    for (const Row& contact : listIn(row.at("contacts"), maxContacts))
      found.contacts.push_back(contactIn(contact, static_cast<int>(found.contacts.size()) + 1));
    const Row& depths = listIn(row.at("profile_depth"), maxProfile);
    const Row& forces = listIn(row.at("profile_force"), maxProfile);
    if (depths.size() != forces.size()) throw InvalidRow{"its profile has gaps"};
    for (std::size_t i = 0; i < depths.size(); ++i)
      found.profile.push_back({meters(depths[i].get<double>()), newtons(forces[i].get<double>())});
    if (auto reason = analysis::impossibility(found); !reason.empty())
      throw InvalidRow{std::move(reason)};
    if (row.contains("stop_mm")) addStops(planned, row);
    return planned;
  } catch (const Row::exception&) {
    return Error{"a value is missing or has another type"};
  } catch (const InvalidRow& impossible) {
    return Error{impossible.reason};
  }
}

const session::InsertionTableKind& planKind()
{
  static const session::InsertionTableKind kind = {
      {Sentence{"the draws of a plan of Perilymph"},
       Sentence{"Choose a draws.sqlite that 'perilymph-cli plan' wrote."},
       Sentence{"Delete it and make the plan again."},
       0x5065506c,  // "PePl"
       3,
       {"CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL)",
        "CREATE TABLE insertion(draw INTEGER NOT NULL, array INTEGER NOT NULL, content TEXT NOT "
        "NULL, "
        "PRIMARY KEY(draw, array)) WITHOUT ROWID"},
       {},
       {},
       1,
       {},
       session::lastingRows("insertion", "draw, array")},
      3,
      {{"insertion", "iit", 2}},
      Sentence{"belongs to another plan, or the patient, an array, the scenario, "
               "resources/planning/uncertainty.toml, resources/planning/frequency-allocation.toml, "
               "resources/clinical/hand.toml, resources/clinical/wires.toml or "
               "resources/reference/surgeons.toml "
               "was changed since."},
      Sentence{"draws"},
      Audience::owner};
  return kind;
}

SealedFacts planFacts(const std::string& fingerprint)
{
  return {{session::fingerprintFact, fingerprint}, {session::programFact, buildId()}};
}

std::vector<session::InsertionRows> rowsOf(const std::vector<PlannedInsertion>& insertions)
{
  std::vector<session::InsertionRows> rows;
  rows.reserve(insertions.size());
  for (const PlannedInsertion& each : insertions)
    rows.push_back({{static_cast<std::int64_t>(each.draw), static_cast<std::int64_t>(each.array),
                     contentOf(each)}});
  return rows;
}

Result<std::vector<PlannedInsertion>> insertionsIn(const session::InsertionTable& table)
{
  std::vector<PlannedInsertion> all;
  std::size_t arrays = 0;  // of the first draw
  const auto done = table.read([&](const session::InsertionRows& one) -> Result<void> {
    const auto draw = std::get<std::int64_t>(one.row[0]),
               array = std::get<std::int64_t>(one.row[1]);
    auto planned = insertionIn(std::get<std::string>(one.row[2]));
    if (!planned)
      return table.damaged(Sentence{"draw %1 is not readable: %2", draw, planned.error().message});
    if (static_cast<std::int64_t>(planned->draw) != draw ||
        static_cast<std::int64_t>(planned->array) != array)
      return table.damaged(Sentence{"draw %1 is not readable: it is another one", draw});
    if (planned->draw == 1 && planned->array == arrays) ++arrays;
    if (arrays == 0 || planned->draw != 1 + all.size() / arrays ||
        planned->array != all.size() % arrays)
      return table.damaged(Sentence{"its draws are not consecutive"});
    all.push_back(*std::move(planned));
    return {};
  });
  if (!done) return done.error();
  if (arrays > 0 && all.size() % arrays != 0)
    return table.damaged(Sentence{"its last draw is not whole"});
  return all;
}

}  // namespace perilymph::planning
