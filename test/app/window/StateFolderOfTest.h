// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A temporary folder for the state of the program.

#include <QByteArray>
#include <QtGlobal>
#include <filesystem>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// Keeps plans in a temporary folder until it is destroyed.
class StateFolderOfTest {
public:
  StateFolderOfTest() : before_(qgetenv(name))
  {
    qputenv(name, QByteArray::fromStdString(folder_.path().string()));
  }
  ~StateFolderOfTest() { qputenv(name, before_); }
  StateFolderOfTest(const StateFolderOfTest&) = delete;
  StateFolderOfTest& operator=(const StateFolderOfTest&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }

private:
  static constexpr const char* name = "XDG_STATE_HOME";
  TemporaryFolder folder_;
  QByteArray before_;
};

}  // namespace perilymph::test
