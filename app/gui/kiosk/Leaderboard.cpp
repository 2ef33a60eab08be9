// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/Leaderboard.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr auto heading = "perilymph booth 1";
constexpr double maxPeak_mN = 1e5;
constexpr double maxDuration_s = 86'400.0;
constexpr int maxReversals = 100'000;
constexpr int maxVisitors = 1'000'000;
constexpr auto visitorsKey = "visitors ";

bool isGentler(const KioskEntry& a, const KioskEntry& b)
{
  return a.peak_mN != b.peak_mN ? a.peak_mN < b.peak_mN : a.at < b.at;
}

/// "14:03:21 83.21 12.4 0": time of day, peak [mN], duration [s], reversals.
std::optional<KioskEntry> entryOf(const QString& line)
{
  const QStringList label = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (label.size() != 4) return std::nullopt;
  bool isPeak = false, isDuration = false, isCount = false;
  KioskEntry entry;
  entry.at = QTime::fromString(label[0], QStringLiteral("HH:mm:ss"));
  entry.peak_mN = label[1].toDouble(&isPeak);
  entry.duration_s = label[2].toDouble(&isDuration);
  entry.reversals = label[3].toInt(&isCount);
  const bool isWell = entry.at.isValid() && isPeak && isDuration && isCount &&
                      entry.peak_mN >= 0.0 && entry.peak_mN < maxPeak_mN &&
                      entry.duration_s >= 0.0 && entry.duration_s < maxDuration_s &&
                      entry.reversals >= 0 && entry.reversals < maxReversals;
  if (!isWell) return std::nullopt;
  return entry;
}

/// "visitors 17"
std::optional<int> visitorsOf(const QString& line)
{
  const QLatin1String key(visitorsKey);
  if (!line.startsWith(key)) return std::nullopt;
  bool isCount = false;
  const int count = line.mid(key.size()).toInt(&isCount);
  if (!isCount || count < 0 || count > maxVisitors) return std::nullopt;
  return count;
}

/// As it is stored: in hundredths of a millinewton.
double rounded(double peak_mN) { return std::round(100.0 * peak_mN) / 100.0; }

QString lineOf(const KioskEntry& entry)
{
  return QStringLiteral("%1 %2 %3 %4\n")
      .arg(entry.at.toString(QStringLiteral("HH:mm:ss")))
      .arg(entry.peak_mN, 0, 'f', 2)
      .arg(entry.duration_s, 0, 'f', 1)
      .arg(entry.reversals);
}

}  // namespace

void Leaderboard::load(const QDate& day)
{
  if (day == day_) return;
  day_ = day;
  entries_.clear();
  visitors_ = 0;
  const Result<std::string> text = readWhole(file_);
  if (!text) return;  // no list has been saved yet
  const QStringList lines = QString::fromStdString(*text).split(QLatin1Char('\n'));
  if (lines.size() < 2 || lines[0] != QLatin1String(heading)) return;
  if (lines[1] != day.toString(Qt::ISODate)) return;
  for (int i = 2; i < lines.size(); ++i) {
    if (const auto entry = entryOf(lines[i])) entries_.push_back(*entry);
    if (const auto count = visitorsOf(lines[i])) visitors_ = *count;
  }
  std::sort(entries_.begin(), entries_.end(), isGentler);
  if (entries_.size() > capacity) entries_.resize(capacity);
}

const std::vector<KioskEntry>& Leaderboard::entriesOf(const QDate& day)
{
  load(day);
  return entries_;
}

DayStatistics Leaderboard::statisticsOf(const QDate& day)
{
  load(day);
  DayStatistics statistics;
  statistics.insertions = static_cast<int>(entries_.size());
  statistics.visitors = visitors_;
  if (entries_.empty()) return statistics;
  const std::size_t count = entries_.size();
  statistics.best_mN = entries_.front().peak_mN;
  statistics.median_mN = 0.5 * (entries_[(count - 1) / 2].peak_mN + entries_[count / 2].peak_mN);
  return statistics;
}

std::optional<int> Leaderboard::enter(const QDate& day, const KioskEntry& entry)
{
  load(day);
  if (!std::isfinite(entry.peak_mN)) return std::nullopt;
  KioskEntry stored = entry;
  stored.peak_mN = rounded(entry.peak_mN);
  const auto place = std::upper_bound(entries_.begin(), entries_.end(), stored, isGentler);
  const auto rank = static_cast<std::size_t>(place - entries_.begin());
  if (rank >= capacity) return std::nullopt;
  entries_.insert(place, stored);
  if (entries_.size() > capacity) entries_.resize(capacity);
  save();
  return static_cast<int>(rank) + 1;
}

void Leaderboard::addVisitor(const QDate& day)
{
  load(day);
  visitors_ = std::min(visitors_ + 1, maxVisitors);
  save();
}

void Leaderboard::save()
{
  QString text = QLatin1String(heading) + QLatin1Char('\n') + day_.toString(Qt::ISODate) +
                 QLatin1Char('\n') + QLatin1String(visitorsKey) + QString::number(visitors_) +
                 QLatin1Char('\n');
  for (const KioskEntry& entry : entries_) text += lineOf(entry);
  std::error_code ignored;  // an error is reported when the file is written
  std::filesystem::create_directories(file_.parent_path(), ignored);
  const Result<void> written = writeWhole(file_, text.toStdString());
  error_ = written ? Sentence() : written.error().message;
}

std::filesystem::path kioskBoardFile()
{
  return sessionFolder().parent_path() / "booth" / "best-of-the-day.txt";
}

}  // namespace perilymph::gui
