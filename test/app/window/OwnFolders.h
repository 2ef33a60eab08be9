// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Temporary folders for what the program keeps: data (sessions, patients) and state (plans).

#include <QByteArray>
#include <QtGlobal>
#include <filesystem>

#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// A temporary folder that an environment variable names until it is destroyed; then the variable is
/// as it was before.
class OwnFolder {
public:
  /// @param variable  A literal.
  explicit OwnFolder(const char* variable)
      : variable_(variable),
        wasSet_(qEnvironmentVariableIsSet(variable)),
        before_(qgetenv(variable))
  {
    qputenv(variable_, QByteArray::fromStdString(folder_.path().string()));
  }
  ~OwnFolder() { wasSet_ ? qputenv(variable_, before_) : qunsetenv(variable_); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }

private:
  const char* variable_;
  TemporaryFolder folder_;
  bool wasSet_;
  QByteArray before_;
};

/// Stores sessions and patients in a temporary folder.
struct DataFolder : OwnFolder {
  DataFolder() : OwnFolder("XDG_DATA_HOME") {}
};

/// Stores plans in a temporary folder.
struct StateFolder : OwnFolder {
  StateFolder() : OwnFolder("XDG_STATE_HOME") {}
};

}  // namespace perilymph::test
