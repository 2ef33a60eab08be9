// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/outcome/OutcomeText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "perilymph/analysis/ColumnDictionary.h"
#include "perilymph/foundation/CsvField.h"
#include "perilymph/foundation/FieldMeaning.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::outcome {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;
constexpr std::size_t maxFoundContacts = 64, maxCourse = 4000;
constexpr double farthest_mm = 10'000.0;

// Writing.

Json described(const Uncertain& value)
{
  return {{"value", value.value}, {"sd", value.sd}, {"ci95", value.interval95()}};
}

Json described(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json described(const std::array<double, 3>& frequency)
{
  return {{"value", frequency[0]}, {"ci95", {frequency[1], frequency[2]}}};
}

template <class Value>
void put(Json& json, const char* key, const std::optional<Value>& value)
{
  if (value) json[key] = *value;
}

Json described(const FoundContact& contact)
{
  Json json{{"number", contact.number},       {"position_lps_mm", described(contact.position_P)},
            {"error_mm", contact.error_mm()}, {"seen_singly", contact.isSeenSingly},
            {"by_hand", contact.isByHand},    {"inside", contact.isInside}};
  put(json, "maker_electrode", contact.makerElectrode);
  if (!contact.isInside) return json;
  json["angle_deg"] = described(contact.angle_deg);
  json["modiolus_mm"] = contact.modiolus_mm;
  json["outer_wall_mm"] = contact.outerWall_mm;
  json["in_scala_tympani"] = contact.inScalaTympani;
  json["greenwood_Hz"] = described(contact.greenwood_Hz);
  json["spiral_ganglion_Hz"] = described(contact.spiralGanglion_Hz);
  if (contact.filter_Hz > 0.0) {
    json["filter_Hz"] = contact.filter_Hz;
    json["mismatch_semitones"] = contact.mismatch_semitones;
  }
  return json;
}

Json described(const Surgery& surgery)
{
  Json json;
  json["array"] = surgery.array;
  if (!surgery.lot.empty()) json["lot"] = surgery.lot;
  json["opening"] = nameIn(openings, surgery.opening);
  json["tool"] = nameIn(tools, surgery.tool);
  if (!surgery.lubricant.empty()) json["lubricant"] = surgery.lubricant;
  put(json, "tilt_deg", surgery.tilt_deg);
  put(json, "turn_deg", surgery.turn_deg);
  if (surgery.intendedDepth) json["intended_depth_mm"] = inMillimeters(*surgery.intendedDepth);
  put(json, "intended_contacts", surgery.intendedContacts);
  put(json, "mark_reached", surgery.isMarkReached);
  if (surgery.outside) json["outside_mm"] = inMillimeters(*surgery.outside);
  put(json, "contacts_outside", surgery.contactsOutside);
  json["stop_reason"] = nameIn(stopReasons, surgery.stopReason);
  put(json, "contact_at_resistance", surgery.contactAtResistance);
  put(json, "attempts", surgery.attempts);
  put(json, "pull_backs", surgery.pullBacks);
  put(json, "days_to_ct", surgery.daysToCt);
  return json;
}

// Reading.

/// Objects in objects, of which an outcome has four.
constexpr int deepest = 8;

/// A JSON text, discarded where it is none.
/// @param fault  Why it is no outcome although it is JSON: an object gives one name two values, of which a parser
///               takes the last, or objects are in one another without an end.
Json parsedJson(const std::string& text, Sentence& fault)
{
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const Json::parser_callback_t check = [&](int depth, Json::parse_event_t event,
                                            const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_start || event == Event::array_start) {
      if (depth >= deepest && fault.empty())
        fault = Sentence{"its values are nested more than %1 deep", deepest};
      if (depth >= deepest) return false;
    }
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second &&
        fault.empty())
      fault = Sentence{"it states \"%1\" twice", parsed.get<std::string>().substr(0, 60)};
    return true;
  };
  return Json::parse(text, check, false);
}

/// Reads values of one object; keeps the first that does not hold.
class Reader {
public:
  /// @param name   Of the outcome, for sentences.
  /// @param place  Of the object in it: "contacts[3]."; empty for the whole.
  Reader(const Json& json, const Sentence& name, std::string place = {})
      : json_(json), name_(name), place_(std::move(place))
  {
  }

  double number(const char* key, double low, double high)
  {
    if (!json_.is_object() || !json_.contains(key) || !json_[key].is_number())
      return refuse(key, Sentence{"a number"});
    const double value = json_[key].get<double>();
    if (!(value >= low && value <= high))
      return refuse(key, Sentence{"a number from %1 to %2", shown(low), shown(high)});
    return value;
  }
  std::optional<double> maybe(const char* key, double low, double high)
  {
    if (!json_.is_object() || !json_.contains(key) || json_[key].is_null()) return std::nullopt;
    return number(key, low, high);
  }
  std::optional<int> maybeWhole(const char* key, int low, int high)
  {
    if (!json_.is_object() || !json_.contains(key) || json_[key].is_null()) return std::nullopt;
    return whole(key, low, high);
  }
  int whole(const char* key, int low, int high)
  {
    const double value = number(key, low, high);
    if (value != std::floor(value)) refuse(key, Sentence{"a whole number"});
    return static_cast<int>(value);
  }
  bool flag(const char* key)
  {
    if (json_.is_object() && json_.contains(key) && json_[key].is_boolean())
      return json_[key].get<bool>();
    refuse(key, Sentence{"true or false"});
    return false;
  }
  std::optional<bool> maybeFlag(const char* key)
  {
    if (!json_.is_object() || !json_.contains(key) || json_[key].is_null()) return std::nullopt;
    return flag(key);
  }
  std::string text(const char* key, std::size_t longest, bool isNeeded)
  {
    if (!json_.is_object() || !json_.contains(key)) {
      if (isNeeded) refuse(key, Sentence{"a text"});
      return {};
    }
    if (!json_[key].is_string() || json_[key].get<std::string>().size() > longest) {
      refuse(key, Sentence{"a text of up to %1 characters", longest});
      return {};
    }
    return json_[key].get<std::string>();
  }
  template <class Value, std::size_t size>
  Value choice(const char* key, const std::array<Choice<Value>, size>& table)
  {
    const std::string name = text(key, 60, true);
    if (const auto value = valueIn(table, name)) return *value;
    std::string names;
    for (const auto& row : table) names += (names.empty() ? "" : ", ") + std::string(row.name);
    refuse(key, Sentence{"one of %1", names});
    return table.front().value;
  }
  Eigen::Vector3d point(const Json& json, const char* key)
  {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    if (!json.is_array() || json.size() != 3) {
      refuse(key, Sentence{"three numbers"});
      return point;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!json[i].is_number() || !(std::fabs(json[i].get<double>()) <= farthest_mm)) {
        refuse(key, Sentence{"three numbers up to 10,000 mm"});
        return point;
      }
      point[static_cast<Eigen::Index>(i)] = json[i].get<double>();
    }
    return point;
  }
  Uncertain uncertain(const char* key, double low, double high)
  {
    if (!json_.is_object() || !json_.contains(key)) {
      refuse(key, Sentence{"an object with value and sd"});
      return {};
    }
    Reader inner(json_[key], name_, place_ + key + ".");
    const Uncertain value{inner.number("value", low, high), inner.number("sd", 0.0, 1e6)};
    take(inner);
    return value;
  }
  std::array<double, 3> frequency(const char* key)
  {
    if (!json_.is_object() || !json_.contains(key)) {
      refuse(key, Sentence{"an object with value and ci95"});
      return {};
    }
    Reader inner(json_[key], name_, place_ + key + ".");
    std::array<double, 3> result{inner.number("value", 0.0, 1e6), 0.0, 0.0};
    const Json& range =
        json_[key].is_object() && json_[key].contains("ci95") ? json_[key]["ci95"] : Json();
    if (!range.is_array() || range.size() != 2 || !range[0].is_number() || !range[1].is_number())
      refuse(key, Sentence{"an object with value and ci95"});
    else
      result[1] = range[0].get<double>(), result[2] = range[1].get<double>();
    take(inner);
    return result;
  }
  void take(const Reader& other)
  {
    if (!error_) error_ = other.error_;
  }
  double refuse(const char* key, const Sentence& allowed)
  {
    if (error_) return 0.0;
    if (!json_.is_object() || !json_.contains(key)) {
      error_ = Error{"%1: %2 is missing; %3 is needed.", name_, place_ + key, allowed};
      return 0.0;
    }
    std::string value = json_[key].dump();
    if (value.size() > 60) value = value.substr(0, 60) + "...";
    error_ = Error{"%1: %2 is %3; %4 is needed.", name_, place_ + key, value, allowed};
    return 0.0;
  }
  const std::optional<Error>& error() const { return error_; }

private:
  static std::string shown(double value)
  {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }
  const Json& json_;
  Sentence name_;
  std::string place_;
  std::optional<Error> error_;
};

FoundContact contactIn(const Json& json, Reader& reader)
{
  FoundContact contact;
  contact.number = reader.whole("number", 1, static_cast<int>(maxFoundContacts));
  contact.position_P = reader.point(
      json.is_object() && json.contains("position_lps_mm") ? json["position_lps_mm"] : Json(),
      "position_lps_mm");
  const double error = reader.number("error_mm", 0.0, 100.0);
  contact.covariance_P = error * error * Eigen::Matrix3d::Identity();
  contact.makerElectrode =
      reader.maybeWhole("maker_electrode", 1, static_cast<int>(maxFoundContacts));
  contact.isSeenSingly = reader.flag("seen_singly");
  contact.isByHand = reader.flag("by_hand");
  contact.isInside = reader.flag("inside");
  if (!contact.isInside || reader.error()) return contact;
  contact.angle_deg = reader.uncertain("angle_deg", -90.0, 1800.0);
  contact.modiolus_mm = reader.number("modiolus_mm", -20.0, 20.0);
  contact.outerWall_mm = reader.number("outer_wall_mm", -20.0, 20.0);
  contact.inScalaTympani = reader.number("in_scala_tympani", 0.0, 1.0);
  contact.greenwood_Hz = reader.frequency("greenwood_Hz");
  contact.spiralGanglion_Hz = reader.frequency("spiral_ganglion_Hz");
  contact.filter_Hz = reader.maybe("filter_Hz", 0.0, 1e6).value_or(0.0);
  contact.mismatch_semitones = reader.maybe("mismatch_semitones", -1000.0, 1000.0).value_or(0.0);
  return contact;
}

Surgery surgeryIn(Reader& reader)
{
  Surgery surgery;
  surgery.array = reader.text("array", 60, true);
  surgery.lot = reader.text("lot", 24, false);
  surgery.opening = reader.choice("opening", openings);
  surgery.tool = reader.choice("tool", tools);
  surgery.lubricant = reader.text("lubricant", 40, false);
  surgery.tilt_deg = reader.maybe("tilt_deg", -90.0, 90.0);
  surgery.turn_deg = reader.maybe("turn_deg", -90.0, 90.0);
  if (const auto depth = reader.maybe("intended_depth_mm", 0.0, 40.0))
    surgery.intendedDepth = millimeters(*depth);
  surgery.intendedContacts = reader.maybeWhole("intended_contacts", 0, 64);
  surgery.isMarkReached = reader.maybeFlag("mark_reached");
  if (const auto outside = reader.maybe("outside_mm", 0.0, 40.0))
    surgery.outside = millimeters(*outside);
  surgery.contactsOutside = reader.maybeWhole("contacts_outside", 0, 64);
  surgery.stopReason = reader.choice("stop_reason", stopReasons);
  surgery.contactAtResistance = reader.maybeWhole("contact_at_resistance", 1, 64);
  surgery.attempts = reader.maybeWhole("attempts", 1, 100);
  surgery.pullBacks = reader.maybeWhole("pull_backs", 0, 100);
  surgery.daysToCt = reader.maybeWhole("days_to_ct", 0, 36'500);
  return surgery;
}

/// The columns of the table, with what they mean.
const FieldMeanings& columns()
{
  static const FieldMeanings all{
      {"contact", "", "Number of the contact; 1 is the most apical."},
      {"maker_electrode", "",
       "The electrode's number in its maker's fitting software; empty if that is not known."},
      {"angle_deg", "degrees", "Angle from the center of the round window, full turns included."},
      {"angle_low95_deg", "degrees", "Lower end of its 95 % interval."},
      {"angle_high95_deg", "degrees", "Upper end of its 95 % interval."},
      {"greenwood_Hz", "Hz",
       "Estimated place frequency along the organ of Corti (Greenwood 1990)."},
      {"greenwood_low95_Hz", "Hz",
       "At the upper end of the angle's interval; listeners vary beyond it."},
      {"greenwood_high95_Hz", "Hz",
       "At the lower end of the angle's interval; listeners vary beyond it."},
      {"spiral_ganglion_Hz", "Hz",
       "Estimated place frequency on the spiral ganglion (Stakhovskaya et al. 2007)."},
      {"spiral_ganglion_low95_Hz", "Hz",
       "At the upper end of the angle's interval; listeners vary beyond it."},
      {"spiral_ganglion_high95_Hz", "Hz",
       "At the lower end of the angle's interval; listeners vary beyond it."},
      {"filter_Hz", "Hz",
       "Center of the contact's default filter; empty if its maker states none."},
      {"mismatch_semitones", "semitones", "Spiral-ganglion frequency above the filter's center."},
      {"mismatch_low95_semitones", "semitones", "Of spiral_ganglion_low95_Hz."},
      {"mismatch_high95_semitones", "semitones", "Of spiral_ganglion_high95_Hz."},
      {"in_scala_tympani", "",
       "Probability that it lies below the basilar membrane, which no CT shows."},
      {"error_mm", "mm", "Standard deviation of the position along each direction."},
      {"modiolus_mm", "mm",
       "Distance to the inner wall, toward the modiolar axis; negative beyond it."},
      {"outer_wall_mm", "mm", "Distance to the outer wall; negative beyond it."},
      {"seen_singly", "",
       "1: the contact was seen by itself; 0: it was placed by the array's spacings."},
      {"by_hand", "", "1: a person placed it."},
      {"inside", "",
       "1: past the opening of the cochlea. If 0, angles, frequencies, filter, mismatch, distances "
       "and the probability are empty."},
      {"x_lps_mm", "mm", "Position in the CT after surgery, LPS: toward the patient's left."},
      {"y_lps_mm", "mm", "The same, toward the back."},
      {"z_lps_mm", "mm", "The same, toward the head."},
      {"array", "", "Name or file of the implanted array, the same in each row."},
      {"side", "", "right or left, the same in each row."},
      {"flags", "",
       "Names of what is doubtful, joined by spaces, the same in each row; empty if nothing is. "
       "The guide explains them."}};
  return all;
}

std::string plain(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A frequency to three significant digits, as the report shows it: its interval is wider by far.
std::string significant(double frequency_Hz)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.2e", frequency_Hz);
  return plain(std::strtod(text, nullptr));
}

}  // namespace

std::string outcomeJson(const OutcomeContent& content)
{
  const FoundArray& found = content.found;
  Json json;
  json["format"] = format;
  json["array"] = found.array;
  json["side"] = anatomy::nameOf(found.side);
  json["angular_insertion_depth_deg"] = described(found.angularInsertionDepth_deg);
  json["tip_angle_deg"] = found.tipAngle_deg;
  json["inserted_length_mm"] =
      described(Uncertain{found.insertedLength_mm, found.insertedLengthSd_mm});
  json["contacts_inside"] = found.contactsInside;
  json["outside_mm"] = found.outside_mm;
  json["fold"] = found.isFolded;
  json["translocation"] = {{"probability", found.translocationProbability},
                           {"angle_deg", found.translocationAngle_deg}};
  json["registration"] = {{"from", found.isRegistered ? "CT before surgery" : "this CT"},
                          {"residual_mm", found.residual_mm}};
  json["blur_fwhm_mm"] = found.fwhm_mm;
  json["flags"] = Json::array();
  for (const Flag flag : found.flags) json["flags"].push_back(nameOf(flag));
  json["contacts"] = Json::array();
  for (const FoundContact& contact : found.contacts) json["contacts"].push_back(described(contact));
  json["course_lps_mm"] = Json::array();
  for (const Eigen::Vector3d& point : found.course_P)
    json["course_lps_mm"].push_back(described(point));
  json["surgery"] = described(content.surgery);
  if (!content.plan.empty()) json["plan"] = content.plan;
  if (!content.series.empty()) json["series_sha256"] = content.series;
  if (content.ctAge_days) json["ct_age_days"] = *content.ctAge_days;
  json["seconds"] = found.seconds;
  json["version"] = buildId();
  return json.dump(2) + "\n";
}

Result<OutcomeContent> outcomeIn(const std::string& text, const Sentence& name)
{
  Sentence fault;
  const Json json = parsedJson(text, fault);
  if (!fault.empty())
    return Error{"%1 is no outcome: %2. Make it by perilymph-cli ct contacts.", name, fault};
  if (json.is_discarded() || !json.is_object())
    return Error{"%1 is no outcome: it is not JSON. Make it by perilymph-cli ct contacts.", name};
  Reader reader(json, name);
  if (const int made = reader.whole("format", 1, 1000); !reader.error() && made != format)
    return Error{"%1 has format %2; this program reads %3. Use a newer program.", name,
                 std::to_string(made), std::to_string(format)};
  OutcomeContent content;
  FoundArray& found = content.found;
  found.array = reader.text("array", 60, true);
  found.side = reader.choice("side", anatomy::sides);
  found.angularInsertionDepth_deg = reader.uncertain("angular_insertion_depth_deg", -90.0, 1800.0);
  found.tipAngle_deg = reader.number("tip_angle_deg", -90.0, 1800.0);
  const Uncertain inserted = reader.uncertain("inserted_length_mm", 0.0, 60.0);
  found.insertedLength_mm = inserted.value;
  found.insertedLengthSd_mm = inserted.sd;
  found.contactsInside = reader.whole("contacts_inside", 0, static_cast<int>(maxFoundContacts));
  found.outside_mm = reader.number("outside_mm", 0.0, 60.0);
  found.isFolded = reader.flag("fold");
  const auto part = [&](const char* key) -> const Json& {
    static const Json none = Json::object();
    return json.contains(key) && json[key].is_object() ? json[key] : none;
  };
  Reader translocation(part("translocation"), name, "translocation.");
  found.translocationProbability = translocation.number("probability", 0.0, 1.0);
  found.translocationAngle_deg = translocation.number("angle_deg", -90.0, 1800.0);
  reader.take(translocation);
  Reader registration(part("registration"), name, "registration.");
  const std::string from = registration.text("from", 40, true);
  found.isRegistered = from == "CT before surgery";
  found.residual_mm = registration.number("residual_mm", 0.0, 100.0);
  reader.take(registration);
  found.fwhm_mm = reader.number("blur_fwhm_mm", 0.0, 10.0);
  if (!json.contains("flags") || !json["flags"].is_array()) {
    reader.refuse("flags", Sentence{"a list"});
  } else {
    for (const Json& each : json["flags"]) {
      bool isKnown = false;
      for (const Flag flag : allFlags())
        if (each == nameOf(flag)) found.flags.push_back(flag), isKnown = true;
      if (!isKnown) reader.refuse("flags", Sentence{"a list of flags that the guide names"});
    }
  }
  if (!json.contains("contacts") || !json["contacts"].is_array() || json["contacts"].empty() ||
      json["contacts"].size() > maxFoundContacts) {
    reader.refuse("contacts", Sentence{"a list of 1 to 64 contacts"});
  } else {
    int last = 0;
    for (const Json& each : json["contacts"]) {
      Reader contact(each, name, "contacts[" + std::to_string(found.contacts.size()) + "].");
      found.contacts.push_back(contactIn(each, contact));
      if (!contact.error() && found.contacts.back().number <= last)
        contact.refuse("number", Sentence{"a number above that of the contact before"});
      last = found.contacts.back().number;
      reader.take(contact);
    }
    const auto inside = std::count_if(found.contacts.begin(), found.contacts.end(),
                                      [](const FoundContact& each) { return each.isInside; });
    if (!reader.error() && inside != found.contactsInside)
      reader.refuse("contacts_inside",
                    Sentence{"%1, the number of contacts that are inside,", inside});
  }
  if (json.contains("course_lps_mm") && json["course_lps_mm"].is_array() &&
      json["course_lps_mm"].size() <= maxCourse)
    for (const Json& each : json["course_lps_mm"])
      found.course_P.push_back(reader.point(each, "course_lps_mm"));
  else
    reader.refuse("course_lps_mm", Sentence{"a list of up to 4,000 points"});
  Reader surgery(part("surgery"), name, "surgery.");
  content.surgery = surgeryIn(surgery);
  reader.take(surgery);
  content.plan = reader.text("plan", 64, false);
  content.series = reader.text("series_sha256", 64, false);
  content.ctAge_days = reader.maybeWhole("ct_age_days", -1, 36'500);
  found.seconds = reader.maybe("seconds", 0.0, 1e6).value_or(0.0);
  if (reader.error()) return *reader.error();
  if (const auto checked = checkSurgery(content.surgery); !checked)
    return Error{"%1: %2", name, checked.error().message};
  return content;
}

std::string outcomeCsv(const FoundArray& found)
{
  std::string flags;
  for (const Flag flag : found.flags)
    flags += (flags.empty() ? "" : " ") + std::string(nameOf(flag));
  const std::string whole =
      "," + csvField(found.array) + "," + std::string(anatomy::nameOf(found.side)) + "," + flags;
  std::string csv = headerOf(columns()) + "\n";
  for (const FoundContact& c : found.contacts) {
    csv += std::to_string(c.number) + ",";
    if (c.makerElectrode) csv += std::to_string(*c.makerElectrode);
    if (c.isInside) {
      const auto [low, high] = c.angle_deg.interval95();
      for (const double value : {c.angle_deg.value, low, high}) csv += "," + plain(value);
      for (const auto& frequency : {c.greenwood_Hz, c.spiralGanglion_Hz})
        for (const double value : frequency) csv += "," + significant(value);
      if (c.filter_Hz > 0.0) {
        const auto [mismatchLow, mismatchHigh] = c.mismatch95_semitones();
        csv += "," + significant(c.filter_Hz);
        for (const double value : {c.mismatch_semitones, mismatchLow, mismatchHigh})
          csv += "," + plain(value);
      } else {
        csv += ",,,,";
      }
      csv += "," + plain(c.inScalaTympani) + "," + plain(c.error_mm()) + "," +
             plain(c.modiolus_mm) + "," + plain(c.outerWall_mm);
    } else {
      csv += std::string(15, ',') + plain(c.error_mm()) + ",,";
    }
    csv += std::string(c.isSeenSingly ? ",1" : ",0") + (c.isByHand ? ",1" : ",0") +
           (c.isInside ? ",1" : ",0");
    for (const double value : c.position_P) csv += "," + plain(value);
    csv += whole + "\n";
  }
  return csv;
}

std::string outcomeDictionaryCsv() { return analysis::dictionaryCsv(columns()); }

std::string outcomeMarkups(const FoundArray& found)
{
  Json points = Json::array();
  for (const FoundContact& contact : found.contacts)
    points.push_back({{"id", std::to_string(contact.number)},
                      {"label", std::to_string(contact.number)},
                      {"position", described(contact.position_P)},
                      {"positionStatus", "defined"}});
  Json course = Json::array();
  for (std::size_t i = 0; i < found.course_P.size(); ++i)
    course.push_back({{"id", std::to_string(i + 1)},
                      {"label", ""},
                      {"position", described(found.course_P[i])},
                      {"positionStatus", "defined"}});
  const Json json{{"@schema",
                   "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/"
                   "Markups/Resources/Schema/markups-schema-v1.0.3.json#"},
                  {"markups",
                   {{{"type", "Fiducial"},
                     {"name", "contacts"},
                     {"coordinateSystem", "LPS"},
                     {"coordinateUnits", "mm"},
                     {"controlPoints", points}},
                    {{"type", "Curve"},
                     {"name", "array"},
                     {"coordinateSystem", "LPS"},
                     {"coordinateUnits", "mm"},
                     {"controlPoints", course}}}}};
  return json.dump(2) + "\n";
}

}  // namespace perilymph::outcome
