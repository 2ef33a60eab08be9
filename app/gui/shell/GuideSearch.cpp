// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/GuideSearch.h"

#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace perilymph::gui {

namespace {

using database::Database;
using database::Statement;
namespace fs = std::filesystem;

constexpr std::size_t maxHits = 20, fewHits = 5;

// Whoever uses the program comes before whoever changes it, and the language of the window before
// English (choices).
constexpr double ofDevelopers = 0.25, ofOtherLanguage = 0.5, ofGlossary = 2.0;

constexpr const char* tables =
    "CREATE TABLE part(id INTEGER PRIMARY KEY, page, place, worth);"
    // Stems of English words; ä is found as a, too.
    "CREATE VIRTUAL TABLE word USING fts5(title, heading, body,"
    " tokenize=\"porter unicode61 remove_diacritics 2\");"
    // Any three letters in a row.
    "CREATE VIRTUAL TABLE piece USING fts5(title, heading, body, tokenize=\"trigram\")";

bool isForDevelopers(const fs::path& page)
{
  static const std::set<std::string> names = {"contributing.md", "performance.md", "proof.md",
                                              "reference.md", "structure.md"};
  return names.count(page.filename().string()) > 0;
}

/// A line of Markdown as it is shown, nearly: without links, pictures and emphasis.
QString shown(QString line)
{
  static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\([^)]*\\)")),
      link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)")),
      emphasis(QStringLiteral("\\*\\*?|`|\\\\(?=[|*_])"));
  line.remove(picture).replace(link, QStringLiteral("\\1")).remove(emphasis);
  return line.simplified();
}

/// Writes the parts of pages into the index.
class Reader {
public:
  Reader(Statement part, Statement word, Statement piece)
      : part_(std::move(part)), word_(std::move(word)), piece_(std::move(piece))
  {
  }

  void read(const fs::path& page, double worth)
  {
    QFile file(QString::fromStdString(page.string()));
    if (!file.open(QIODevice::ReadOnly)) return;
    page_ = page;
    worth_ = worth;
    title_ = heading_ = QString();
    counts_.clear();
    const bool isGlossary = page.stem() == "glossary";
    static const QRegularExpression rule(QStringLiteral("^[|:\\s-]*$")),
        heading(QStringLiteral("^#+ ")), bar(QStringLiteral("(?<!\\\\)\\|")),
        question(QStringLiteral("^\\*\\*\\d+\\. ([^*]+)\\*\\*"));
    bool isInTable = false;
    while (!file.atEnd()) {
      QString line = QString::fromUtf8(file.readLine());
      const bool isHead = line.startsWith('|') && !isInTable;
      isInTable = line.startsWith('|');
      if (line.contains(rule) || line.startsWith(QLatin1String("<!--"))) continue;
      if (line.contains(heading)) {
        line = shown(line.remove(heading));
        if (title_.isEmpty())
          title_ = line;
        else
          begin(line);
      } else if (const auto asked = question.match(line); asked.hasMatch()) {
        begin(asked.captured(1));
        add(shown(line.mid(asked.capturedLength())));
      } else if (line.startsWith('|')) {
        QStringList cells = line.split(bar);
        std::transform(cells.begin(), cells.end(), cells.begin(), shown);
        cells.removeAll({});
        if (isHead || cells.isEmpty()) continue;  // of columns, which an excerpt does not show
        const QString first = cells.takeFirst();
        if (isGlossary)
          begin(first);
        else
          add(cells.isEmpty() ? first : first + ':');
        add(cells.join("; ") + (cells.isEmpty() ? "" : "."));
      } else {
        add(shown(line));
      }
    }
    end();
  }

private:
  void begin(const QString& heading)
  {
    end();
    heading_ = heading;
    ++counts_[heading];
  }
  void add(const QString& text)
  {
    if (!text.isEmpty()) body_ += (body_.isEmpty() ? QString() : QString(' ')) + text;
  }
  void end()
  {
    if (body_.isEmpty()) return;
    ++id_;
    part_.reset();
    part_.bind(0, id_);
    part_.bind(1, page_.string());
    part_.bind(2, std::int64_t{counts_[heading_]});
    part_.bind(3, worth_);
    part_.step();
    for (Statement* text : {&word_, &piece_}) {
      text->reset();
      text->bind(0, id_);
      text->bind(1, title_.toStdString());
      text->bind(2, heading_.toStdString());
      text->bind(3, body_.toStdString());
      text->step();
    }
    body_.clear();
  }

  Statement part_, word_, piece_;
  std::int64_t id_ = 0;
  fs::path page_;
  double worth_ = 1.0;
  QString title_, heading_, body_;
  std::map<QString, int> counts_;
};

/// Words of a question, without those that every question has.
QStringList wordsOf(const QString& text)
{
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
  static const std::set<QString> common = {
      "a",   "an",   "the",  "is", "are", "of",   "to",  "in",  "on",   "my",    "what",    "how",
      "why", "do",   "does", "i",  "it",  "der",  "die", "das", "was",  "wie",   "warum",   "ist",
      "ein", "eine", "ich",  "im", "und", "oder", "and", "or",  "mean", "means", "bedeutet"};
  QStringList words = text.toLower().split(between, Qt::SkipEmptyParts), rare;
  std::copy_if(words.begin(), words.end(), std::back_inserter(rare),
               [](const QString& word) { return common.count(word) == 0; });
  return rare.isEmpty() ? words : rare;
}

/// An expression of FTS5; the words have letters and digits alone.
std::string expression(const QStringList& words, const char* after, const char* between)
{
  QStringList quoted;
  for (const QString& word : words) quoted += '"' + word + '"' + after;
  return quoted.join(between).toStdString();
}

}  // namespace

Result<GuideSearch> GuideSearch::read(const fs::path& start)
{
  auto index = Database::inMemory();
  if (!index) return index.error();
  if (const auto made = index->run(std::string("BEGIN;") + tables); !made) return made.error();
  auto part = index->prepare("INSERT INTO part VALUES(?,?,?,?)");
  auto word = index->prepare("INSERT INTO word(rowid, title, heading, body) VALUES(?,?,?,?)");
  auto piece = index->prepare("INSERT INTO piece(rowid, title, heading, body) VALUES(?,?,?,?)");
  if (!part || !word || !piece) return Error{index->lastError()};
  Reader reader(*std::move(part), *std::move(word), *std::move(piece));
  const fs::path folder = start.parent_path();
  const bool isOriginal = fs::is_directory(folder / "de");
  std::vector<fs::path> places = {folder};
  if (!isOriginal) places.push_back(folder.parent_path());
  std::set<fs::path> names;
  std::error_code ignored;
  for (const fs::path& place : places)
    for (const auto& entry : fs::directory_iterator(place, ignored)) {
      const fs::path& page = entry.path();
      if (page.extension() != ".md" || !names.insert(page.filename()).second) continue;
      reader.read(page, (page.stem() == "glossary" ? ofGlossary : 1.0) *
                            (isForDevelopers(page) ? ofDevelopers : 1.0) *
                            (place == folder ? 1.0 : ofOtherLanguage));
    }
  if (const auto ended = index->run("COMMIT"); !ended) return ended.error();
  return GuideSearch(*std::move(index));
}

std::vector<GuideHit> GuideSearch::find(const QString& text) const
{
  const QStringList words = wordsOf(text);
  std::vector<GuideHit> hits;
  if (words.isEmpty()) return hits;
  std::set<std::int64_t> known;
  const auto add = [&](const std::string& name, const std::string& expression) {
    const std::string length = name == "piece" ? "64" : "20";  // of the excerpt: letters, or words
    auto rows = index_.prepare("SELECT part.id, part.page, part.place, title, heading, snippet(" +
                               name + ", 2, char(1), char(2), '…', " + length + ") FROM " + name +
                               " JOIN part ON part.id=" + name + ".rowid WHERE " + name +
                               " MATCH ? ORDER BY bm25(" + name +
                               ", 4.0, 8.0, 1.0)*part.worth LIMIT " + std::to_string(maxHits));
    if (!rows) return;
    rows->bind(0, expression);
    while (hits.size() < maxHits && rows->step() == Statement::Step::row) {
      if (!known.insert(rows->integer(0)).second) continue;
      const auto column = [&](int i) { return QString::fromStdString(rows->text(i)); };
      QString excerpt = column(5).toHtmlEscaped();
      excerpt.replace(QChar(1), "<b>").replace(QChar(2), "</b>");
      hits.push_back(
          {column(1), column(3), column(4), static_cast<int>(rows->integer(2)), excerpt});
    }
  };
  add("word", expression(words, "*", " AND "));
  if (hits.size() < fewHits) add("piece", expression(words, "", " AND "));
  if (hits.size() < fewHits && words.size() > 1) add("word", expression(words, "*", " OR "));
  if (hits.size() < fewHits && words.size() > 1) add("piece", expression(words, "", " OR "));
  return hits;
}

}  // namespace perilymph::gui
