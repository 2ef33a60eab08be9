// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Search in the pages of the user guide.

#include <QString>
#include <filesystem>
#include <vector>

#include "perilymph/database/Database.h"

namespace perilymph::gui {

/// Part of a page that has the words: from a heading to the next, an entry of the glossary, or a question.
struct GuideHit {
  QString page;     ///< File of the page.
  QString title;    ///< Its title.
  QString heading;  ///< The heading of the part; empty before the first one.
  int place = 0;    ///< 1 for the page's first part of this heading, 2 for the second.
  QString excerpt;  ///< HTML: some words around the found ones, which are bold.
};

class GuideSearch {
public:
  /// Reads the guide that has a first page, once: its pages, and where they are a translation the
  /// original's pages that it lacks.
  static Result<GuideSearch> read(const std::filesystem::path& start);

  /// Parts that have all words in any inflection, the best first; if these are few, parts that have
  /// the letters of all words, as German compounds do, then parts that have some of the words.
  std::vector<GuideHit> find(const QString& words) const;

private:
  explicit GuideSearch(database::Database index) : index_(std::move(index)) {}

  database::Database index_;  // in memory
};

}  // namespace perilymph::gui
