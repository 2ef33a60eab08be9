// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What reports say of sources: the number of a publication, or that a value is an assumption.

#include <QString>
#include <span>
#include <string>
#include <vector>

namespace perilymph::gui {

/// A publication that texts of sources name.
struct Publication {
  const char* name;      ///< As texts of sources name it: "Dohr et al. 2021".
  const char* citation;  ///< Where it is, and what it holds that is used here.
  /// Its text, a table, its data or its abstract were read; else what is taken of it is an assumption.
  bool wasRead = true;
};

/// All that the shipped files and the pages name.
std::span<const Publication> publications();

/// The publications that one report cites, numbered in the order in which its pages cite them.
class References {
public:
  /// The citation on a page of a text that names sources: "[2]", "[2, 5]", "[2–7]"; where it names none that
  /// was read, "general literature" or "assumption".
  QString label(const std::string& source);
  /// The list of what was cited, as HTML with a heading; empty if nothing was.
  QString list() const;

private:
  std::vector<const Publication*> cited_;
};

}  // namespace perilymph::gui
