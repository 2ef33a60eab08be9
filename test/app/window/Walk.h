// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A walk through a page of the user guide in the real window: the controls of every step exist, and
// the guide's pictures can be saved.

#include <QImage>
#include <QString>
#include <QWidget>
#include <map>
#include <string>

namespace perilymph::test {

/// A picture of a window without the mouse over it, after its layouts came to rest. Its channels are
/// rounded where the eye does not see it, which halves the size of a file.
QImage pictureOf(QWidget& window);

/// Saves such a picture as "<name>.png" in the folder that PERILYMPH_GUIDE_PICTURES names; does nothing
/// without it.
void keepForGuide(QWidget& window, const std::string& name);

/// One page of the guide; its steps are the headings "## 1. ..." and so on.
class Walk {
public:
  /// @param page  For example "surgeon" for resources/guide/surgeon.md.
  explicit Walk(const char* page);

  /// Checks that the window shows every bold word of a step. If the environment variable
  /// PERILYMPH_GUIDE_PICTURES names a folder, saves a picture of the window there as surgeon-1.png.
  void step(int number, QWidget& window);

  /// Steps of the page that were not visited.
  std::string left() const;

private:
  std::string page_;
  std::map<int, QString> steps_;  ///< The remaining ones.
};

}  // namespace perilymph::test
