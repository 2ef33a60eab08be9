// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A temporary folder for a window's data.

#include <QByteArray>
#include <QtGlobal>
#include <filesystem>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// Stores sessions and patients in a temporary folder until it is destroyed.
class DataFolder {
public:
  DataFolder() : wasSet_(qEnvironmentVariableIsSet(name)), before_(qgetenv(name))
  {
    qputenv(name, QByteArray::fromStdString(folder_.path().string()));
  }
  ~DataFolder() { wasSet_ ? qputenv(name, before_) : qunsetenv(name); }
  DataFolder(const DataFolder&) = delete;
  DataFolder& operator=(const DataFolder&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }

private:
  static constexpr const char* name = "XDG_DATA_HOME";
  TemporaryFolder folder_;
  bool wasSet_;
  QByteArray before_;
};

}  // namespace perilymph::test
