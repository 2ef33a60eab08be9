// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/study/Study.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "LatinHypercube.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/TomlReader.h"
#include "perilymph/foundation/Utf8.h"
#include "perilymph/session/Csv.h"
#include "perilymph/session/InsertionParameters.h"

namespace perilymph::study {

namespace {

namespace fs = std::filesystem;

/// Finest spacing of a force over depth that is kept: finer than any tick moves (choice, high).
constexpr double finestProfile_mm = 0.001;

/// Keys of a scenario that a study does not vary, and why.
struct FixedKey {
  std::string_view key, remedy;
};
constexpr std::array<FixedKey, 7> fixedKeys = {{
    {"anatomy", "it is that of the cochleae: set it in the scenario"},
    {"patient", "list patients under [cochleae]"},
    {"side", "it is that of the patient"},
    {"lead_in_mm", "it belongs to the cochlea: set it in the scenario"},
    {"seed", "the study has a seed of its own"},
    {"title", "it has no effect"},
    {"withdraw", "a study inserts only"},
}};

/// Appends every value of a key to every combination: the last key varies fastest.
void cross(std::vector<session::Overrides>& combinations, const std::string& key,
           const std::vector<std::string>& values)
{
  std::vector<session::Overrides> crossed;
  for (const session::Overrides& before : combinations)
    for (const std::string& value : values) {
      crossed.push_back(before);
      crossed.back().emplace_back(key, value);
    }
  combinations = std::move(crossed);
}

std::string textOf(const session::Overrides& overrides)
{
  std::string text;
  for (const auto& [key, value] : overrides) text += (text.empty() ? "" : ", ") + key + "=" + value;
  return text.empty() ? "the scenario as it is" : text;
}

/// A text without a folder, so that a study that was moved with its files is the same.
std::string without(std::string text, const std::string& folder)
{
  for (std::size_t at = 0; (at = text.find(folder, at)) != std::string::npos;)
    text.erase(at, folder.size());
  return text;
}

std::string hashOf(const std::string& content)
{
  Sha256 hash;
  hash.add(content);
  return hash.hex();
}

}  // namespace

/// Reads and checks the text of a study.
class StudyReader {
public:
  StudyReader(TomlReader reader, const fs::path& file, const std::string& text)
      : reader_(std::move(reader)), file_(file)
  {
    study_.text_ = text;
  }

  Result<Study> read();

private:
  Result<void> readCochleae();
  Result<void> readFactors();
  Result<void> readSamples();
  Result<void> checkCombinations();
  void tellArraysApart();
  void noteFileValues(const session::Overrides& overrides, const session::Scenario& scenario);
  Error error(const std::string& sentence) const { return Error{"%1: %2", file_, sentence}; }

  TomlReader reader_;
  fs::path file_;
  Study study_;
  std::string scenario_;
  std::size_t patients_ = 0;
  Sha256 hash_;
};

Result<Study> StudyReader::read()
{
  study_.title_ = onOneLine(reader_.text("title"));
  scenario_ = reader_.text("scenario");
  study_.seed_ = static_cast<std::uint64_t>(reader_.integer("seed", 0, 1'000'000'000, 1));
  static constexpr std::array depths{Choice<bool>{true, "full"}, Choice<bool>{false, "scenario"}};
  study_.isFullDepth_ = reader_.choice("depth", depths, true);
  TomlReader results = reader_.table("results");
  const double spacing_mm = results.number("profile_spacing_mm", {0.0, 10.0}, 0.0);
  if (spacing_mm > 0.0 && spacing_mm < finestProfile_mm)
    results.refuse("profile_spacing_mm",
                   "'results.profile_spacing_mm' is " + session::shortestDecimal(spacing_mm) +
                       "; it must be 0, for none, or " +
                       session::shortestDecimal(finestProfile_mm) + " to 10 mm.");
  study_.profileSpacing_ = millimeters(spacing_mm);
  study_.keepsContacts_ = results.flag("contacts", false);
  hash_.add(study_.text_);
  if (const auto done = readCochleae(); !done) return done.error();
  if (const auto done = readFactors(); !done) return done.error();
  if (const auto done = readSamples(); !done) return done.error();
  if (const auto done = reader_.finish(); !done) return done.error();
  if (study_.cochleae_.empty())
    return error(
        "there is no cochlea; give mean = true, virtual = 100 or patients under [cochleae].");
  if (study_.size() > maxCases)
    return error("the study has " + std::to_string(study_.size()) + " insertions; at most " +
                 std::to_string(maxCases) + " are allowed. Shorten its lists or divide it.");
  if (const auto done = checkCombinations(); !done) return done.error();
  study_.fingerprint_ = hash_.hex();
  return std::move(study_);
}

Result<void> StudyReader::readCochleae()
{
  TomlReader table = reader_.table("cochleae");
  if (table.flag("mean", false)) study_.cochleae_.push_back({"mean", "", 0});
  const long drawn = table.integer("virtual", 0, 1'000'000, 0);
  for (long i = 1; i <= drawn; ++i)
    study_.cochleae_.push_back({"virtual " + std::to_string(i), "", static_cast<std::uint64_t>(i)});
  if (!table.has("patients")) return {};
  std::vector<std::string> unsealed;
  for (const std::string& name : table.values("patients")) {
    const fs::path place = file_.parent_path() / name;
    if (std::ranges::count(table.values("patients"), name) > 1)
      return error("[cochleae] patients: " + name + " stands twice. Remove one.");
    const auto content = readWhole(place);
    if (!content) return error("[cochleae] patients: " + content.error().message);
    const auto patient = anatomy::loadPatient(place);
    if (!patient) return error("[cochleae] " + name + ": " + patient.error().message);
    hash_.add(std::uint64_t{content->size()});  // no line of one file counts as of the next
    hash_.add(*content);
    study_.files_[fs::absolute(place)];
    study_.cochleae_.push_back(
        {patient->seal == Seal::changed ? name + " (measures changed by hand)" : name,
         fs::absolute(place).string(), 0});
    ++patients_;
    if (const std::string note = onOneLine(noteOn(*patient)); !note.empty())
      (patient->seal == Seal::changed ? study_.notes_ : unsealed).push_back(note);
  }
  study_.notes_.insert(study_.notes_.end(), unsealed.begin(), unsealed.end());
  return {};
}

Result<void> StudyReader::readFactors()
{
  // Before the first of them is made.
  TomlReader vary = reader_.table("vary");
  std::vector<TomlReader> cases = reader_.tables("case");
  std::size_t combinations = std::max<std::size_t>(cases.size(), 1);
  for (const std::string& key : vary.keys()) {
    combinations *= std::max<std::size_t>(vary.values(key).size(), 1);
    if (combinations > maxCombinations)
      return error("its lists under [vary] and its [[case]] have more than " +
                   std::to_string(maxCombinations) +
                   " combinations, the most that are allowed. Shorten them, or divide the study.");
  }
  if (combinations > maxCombinations)
    return error("it has " + std::to_string(combinations) + " [[case]]; at most " +
                 std::to_string(maxCombinations) + " are allowed. Divide the study.");
  study_.combinations_ = {{}};
  for (const std::string& key : vary.keys()) {
    const auto fixed = std::find_if(fixedKeys.begin(), fixedKeys.end(),
                                    [&](const FixedKey& each) { return each.key == key; });
    if (fixed != fixedKeys.end())
      vary.refuse(key, "'vary." + key + "' is not allowed: " + std::string(fixed->remedy) + ".");
    if (key == "stop_travel_mm" && study_.isFullDepth_)
      vary.refuse(key,
                  "'vary.stop_travel_mm' has no effect with depth = \"full\"; give depth = "
                  "\"scenario\".");
    cross(study_.combinations_, key, vary.values(key));
  }
  // Cases written out: each is combined with the lists above.
  std::vector<session::Overrides> combined;
  for (const session::Overrides& before : study_.combinations_)
    for (TomlReader& one : cases) {
      combined.push_back(before);
      for (const std::string& key : one.keys()) combined.back().emplace_back(key, one.value(key));
    }
  if (!cases.empty()) study_.combinations_ = std::move(combined);
  // Twice the same settings would count twice in every mean.
  std::set<std::map<std::string, std::string>> known;
  for (const session::Overrides& overrides : study_.combinations_) {
    std::map<std::string, std::string> settings;
    for (const auto& [key, value] : overrides) settings[key] = value;
    if (!known.insert(settings).second)
      return error("the settings " + textOf(overrides) +
                   " stand twice. Remove the second from [vary] or [[case]].");
  }
  return {};
}

Result<void> StudyReader::readSamples()
{
  TomlReader table = reader_.table("ranges");
  study_.samples_ = static_cast<std::size_t>(reader_.integer("samples", 1, 1'000'000, 1));
  for (const std::string& key : table.keys()) {
    const std::vector<double> ends = table.numbers(key, {}, 2);
    if (ends.size() == 2 && !(ends[0] < ends[1]))
      table.refuse(key,
                   "'ranges." + key + "' goes from " + session::shortestDecimal(ends[0]) + " to " +
                       session::shortestDecimal(ends[1]) +
                       "; the first must be the lower end. Exchange them, or give another end.");
    if (ends.size() != 2)
      table.refuse(key,
                   "'ranges." + key + "' must be the lower and the upper end, such as [0.2, 2.0].");
    const bool isListed =
        std::ranges::any_of(study_.combinations_, [&](const session::Overrides& overrides) {
          return std::ranges::any_of(overrides,
                                     [&](const auto& each) { return each.first == key; });
        });
    if (isListed)
      table.refuse(key,
                   "'" + key + "' has values in [ranges] and in [vary] or [[case]]. Remove one.");
    if (ends.size() == 2) study_.ranges_.push_back({key, ends[0], ends[1]});
  }
  if (study_.ranges_.empty() && study_.samples_ > 1)
    reader_.refuse("samples", "'samples' needs a range: without one every sample is the same.");
  return {};
}

/// Study::fileValues() of a combination.
void StudyReader::noteFileValues(const session::Overrides& overrides,
                                 const session::Scenario& scenario)
{
  const auto isSetting = [&](const std::string& key) {
    const auto is = [&key](const auto& each) { return each.first == key; };
    return std::ranges::any_of(overrides, is) ||
           std::ranges::any_of(study_.ranges_, [&](const auto& each) { return each.key == key; });
  };
  const auto add = [&](const StudyFileValue& one) {
    const bool isThere = std::ranges::any_of(study_.fileValues_, [&](const auto& each) {
      return each.key == one.key && each.value == one.value && each.name == one.name;
    });
    if (!isThere && !isSetting(one.name)) study_.fileValues_.push_back(one);
  };
  const mechanics::FrictionLaw& friction = scenario.friction();
  for (const auto& [key, value] : overrides)
    if (key == "array") {
      add({key, value, "array_name", scenario.array().name});
    } else if (key == "friction") {
      add({key, value, "friction_static", session::shortestDecimal(friction.staticCoefficient)});
      add({key, value, "friction_dynamic", session::shortestDecimal(friction.kineticCoefficient)});
    }
}

/// Gives arrays of the same name, which would count as one, their setting beside it.
void StudyReader::tellArraysApart()
{
  std::map<std::string, int> counts;
  for (const StudyFileValue& each : study_.fileValues_)
    if (each.name == "array_name") ++counts[each.content];
  for (StudyFileValue& each : study_.fileValues_)
    if (each.name == "array_name" && counts[each.content] > 1)
      each.content += " (" + each.value + ")";
}

/// Reads every combination as a scenario, at both ends of every range.
Result<void> StudyReader::checkCombinations()
{
  bool isOfPatient = false;
  for (const session::Overrides& overrides : study_.combinations_) {
    // shipped scenarios by name, others beside the study
    const fs::path beside = file_.parent_path() / scenario_;
    std::error_code ignored;
    session::Overrides values = session::withFilesIn(file_.parent_path(), overrides);
    if (study_.isFullDepth_) values.emplace_back("stop_travel_mm", session::anyStopTravel);
    auto scenario = session::loadScenario(
        fs::is_regular_file(beside, ignored) ? beside.string() : scenario_, values);
    if (!scenario) return error(textOf(overrides) + ": " + scenario.error().message);
    for (const StudyRange& range : study_.ranges_)
      for (const double end : {range.low, range.high})
        if (const auto at = scenario->with({{range.key, session::shortestDecimal(end)}}); !at)
          return error("[ranges] " + range.key + ": " + at.error().message);
    if (scenario->anatomy() != anatomy::AnatomySource::mean && study_.cochleae_.size() > patients_)
      return error("the scenario '" + scenario_ +
                   "' has another anatomy than \"mean\", which mean "
                   "and virtual cochleae have. Name another scenario, or patients.");
    // as it stands between the quotation marks of the text
    const std::string folder = nlohmann::json((fs::absolute(file_).parent_path() / "").string())
                                   .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    hash_.add(without(scenario->text(), folder.substr(1, folder.size() - 2)));
    if (isScaledBy(scenario->anatomy(), scenario->patient())) isOfPatient = true;
    for (const std::string& note : scenario->notes())
      if (!std::ranges::count(study_.notes_, note)) study_.notes_.push_back(note);
    noteFileValues(overrides, *scenario);
    for (const fs::path& named : scenario->files()) study_.files_[named];
    study_.scenarios_.push_back(*std::move(scenario));
  }
  if (isOfPatient)
    study_.notes_.insert(study_.notes_.begin(),
                         "The scenario is of a patient, in whose cochlea nothing is inserted: the "
                         "study runs in the cochleae that it lists.");
  tellArraysApart();
  for (auto& [named, hash] : study_.files_) {
    const auto content = readWhole(named);
    if (!content) return content.error();
    hash = hashOf(*content);
  }
  const std::size_t count = study_.cochleae_.size() * study_.samples_;
  for (std::size_t i = 0; i < study_.ranges_.size(); ++i)
    study_.strata_.push_back(strataOf(study_.seed_, i, count));
  // The first case of every combination and of every patient.
  for (std::size_t i = 0; i < study_.combinations_.size(); ++i)
    if (const auto found = study_.parametersOf(study_.caseAt(i * study_.samples_)); !found)
      return error(textOf(study_.combinations_[i]) + ": " + found.error().message);
  for (std::size_t i = 0; i < study_.cochleae_.size(); ++i) {
    if (study_.cochleae_[i].patient.empty()) continue;
    if (const auto found = study_.parametersOf(study_.caseAt(i * study_.casesPerCochlea())); !found)
      return error("[cochleae] " + study_.cochleae_[i].name + ": " + found.error().message);
  }
  return {};
}

Result<void> Study::checkFiles() const
{
  for (const auto& [named, hash] : files_) {
    const auto content = readWhole(named);
    if (!content) return content.error();
    if (hashOf(*content) != hash)
      return Error{
          "%1 was changed while the study ran. The results before are kept: put the file back to "
          "continue, or run the study into another folder.",
          named};
  }
  return {};
}

Result<Study> loadStudy(const fs::path& file)
{
  const auto text = readWhole(file);
  if (!text) return text.error();
  return parseStudy(*text, file);
}

Result<Study> parseStudy(const std::string& text, const fs::path& file)
{
  auto reader = TomlReader::parse(text, file.string());
  if (!reader) return reader.error();
  return StudyReader(*std::move(reader), file, text).read();
}

}  // namespace perilymph::study
