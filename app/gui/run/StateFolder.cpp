// SPDX-License-Identifier: BSD-3-Clause
#include "gui/run/StateFolder.h"

#include <QDir>
#include <QString>
#include <cstdlib>

namespace perilymph::gui {

std::filesystem::path stateFolder()
{
  // XDG Base Directory Specification: relative paths are ignored.
  const char* given = std::getenv("XDG_STATE_HOME");
  const std::filesystem::path state = given != nullptr ? given : "";
  if (state.is_absolute()) return state / "perilymph";
  return std::filesystem::path(QDir::homePath().toStdString()) / ".local" / "state" / "perilymph";
}

}  // namespace perilymph::gui
