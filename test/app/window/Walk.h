// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A walk of the user guide, taken in the real window: what a step tells people to press is there,
// and pictures of the steps are kept for the guide.

#include <QString>
#include <QWidget>
#include <map>
#include <string>

namespace perilymph::test {

/// One page of the guide: its steps are the headings "## 1. ..." and so on.
class Walk {
public:
  /// @param page  "surgeon", of resources/guide/surgeon.md.
  explicit Walk(const char* page);

  /// Checks that every word in bold type of a step stands on the window now. Where the
  /// environment's PERILYMPH_GUIDE_PICTURES names a folder, the window is kept there as
  /// surgeon-1.png.
  void step(int number, QWidget& window);

  /// Steps of the page that were not taken.
  std::string left() const;

private:
  std::string page_;
  std::map<int, QString> steps_;  ///< Those to come.
};

}  // namespace perilymph::test
