#include "SessionIndex.h"

#include <fstream>
#include <system_error>

namespace perilymph::session {

namespace {

namespace fs = std::filesystem;

// Raised whenever the columns or their meaning change; an index of another number is made anew.
constexpr std::int64_t format = 1;

constexpr const char* columns =
    "name TEXT PRIMARY KEY, bytes INTEGER, modified_ns INTEGER, started_utc TEXT, scenario TEXT,"
    " patient TEXT, side TEXT, array TEXT, device TEXT, version TEXT, ticks INTEGER,"
    " duration_s REAL, deepest_m REAL, deepest_angle_rad REAL, peak_force_N REAL,"
    " peak_travel_m REAL, peak_depth_m REAL, closed INTEGER, trouble TEXT";

constexpr std::string SessionSummary::*texts[] = {
    &SessionSummary::startedUtc, &SessionSummary::scenario, &SessionSummary::patient,
    &SessionSummary::side,       &SessionSummary::array,    &SessionSummary::device,
    &SessionSummary::version};

constexpr double Highlights::*numbers[] = {&Highlights::duration,     &Highlights::deepest,
                                           &Highlights::deepestAngle, &Highlights::peakForce,
                                           &Highlights::peakTravel,   &Highlights::peakDepth};

}  // namespace

SessionIndex::SessionIndex(const fs::path& folder)
{
  const fs::path cache = libraryCache(folder);
  std::error_code failure;
  fs::create_directories(cache, failure);
  if (failure) return;
  const fs::path file = cache / "index.sqlite";
  if (open(file) && read()) return;
  known_.clear();
  database_.reset();
  for (const char* tail : {"", "-journal", "-wal", "-shm"})
    fs::remove(file.string() + tail, failure);
  if (!open(file) || !read()) database_.reset();
}

bool SessionIndex::open(const fs::path& file)
{
  std::error_code ignored;
  if (!fs::exists(file, ignored)) std::ofstream(file, std::ios::binary).flush();
  auto opened = Database::open(file, Database::Access::readWrite);
  if (!opened) return false;
  database_ = std::move(*opened);
  if (database_->number("PRAGMA user_version") == format) return true;
  // Only an empty file is begun; anything else is another format's.
  if (database_->number("SELECT COUNT(*) FROM sqlite_master") != 0 || database_->isDamaged())
    return false;
  return bool(database_->run("BEGIN; CREATE TABLE session(" + std::string(columns) +
                             "); PRAGMA user_version=" + std::to_string(format) + "; COMMIT"));
}

bool SessionIndex::read()
{
  auto rows = database_->prepare("SELECT * FROM session");
  if (!rows) return false;
  Statement::Step step = rows->step();
  for (; step == Statement::Step::row; step = rows->step()) {
    SessionSummary summary;
    int column = 0;
    const std::string name = rows->text(column++);
    summary.bytes = static_cast<std::uint64_t>(rows->integer(column++));
    summary.modified_ns = rows->integer(column++);
    for (const auto text : texts) summary.*text = rows->text(column++);
    summary.highlights.ticks = static_cast<std::uint64_t>(rows->integer(column++));
    for (const auto number : numbers) summary.highlights.*number = rows->real(column++);
    summary.wasClosed = rows->integer(column++) != 0;
    summary.trouble = rows->text(column++);
    known_.emplace(name, std::move(summary));
  }
  return step == Statement::Step::done;
}

std::optional<SessionSummary> SessionIndex::find(const std::string& name, std::uint64_t bytes,
                                                 std::int64_t modified_ns) const
{
  const auto found = known_.find(name);
  if (found == known_.end() || found->second.bytes != bytes ||
      found->second.modified_ns != modified_ns)
    return std::nullopt;
  return found->second;
}

void SessionIndex::keep(const SessionSummary& summary)
{
  if (!database_) return;
  if (!isWriting_) isWriting_ = bool(database_->run("BEGIN"));
  std::string marks = "?";
  for (std::size_t i = 1; i < 5 + std::size(texts) + std::size(numbers) + 1; ++i) marks += ",?";
  auto row = database_->prepare("INSERT OR REPLACE INTO session VALUES(" + marks + ")");
  if (!row) return;
  int parameter = 0;
  row->bind(parameter++, summary.file.filename().string());
  row->bind(parameter++, static_cast<std::int64_t>(summary.bytes));
  row->bind(parameter++, summary.modified_ns);
  for (const auto text : texts) row->bind(parameter++, summary.*text);
  row->bind(parameter++, static_cast<std::int64_t>(summary.highlights.ticks));
  for (const auto number : numbers) row->bind(parameter++, summary.highlights.*number);
  row->bind(parameter++, static_cast<std::int64_t>(summary.wasClosed ? 1 : 0));
  row->bind(parameter++, summary.trouble);
  static_cast<void>(row->step());
}

void SessionIndex::forget(const std::set<std::string>& present)
{
  if (!database_) return;
  for (const auto& [name, summary] : known_) {
    if (present.count(name) != 0) continue;
    if (!isWriting_) isWriting_ = bool(database_->run("BEGIN"));
    auto row = database_->prepare("DELETE FROM session WHERE name = ?");
    if (!row) return;
    row->bind(0, name);
    static_cast<void>(row->step());
  }
}

void SessionIndex::close()
{
  if (database_ && isWriting_) static_cast<void>(database_->run("COMMIT"));
  isWriting_ = false;
}

}  // namespace perilymph::session
