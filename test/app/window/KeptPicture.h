// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pictures of windows under test, for people who look at them.

#include <gtest/gtest.h>

#include <QPixmap>
#include <QString>
#include <QWidget>
#include <string>

#include "gui/scene/OperationView.h"

namespace perilymph::test {

/// Saves a window into the folder that PERILYMPH_SCREEN_PICTURES names; does nothing without it.
inline void keepPicture(QWidget& window, const std::string& name)
{
  const QString folder = qEnvironmentVariable("PERILYMPH_SCREEN_PICTURES");
  if (folder.isEmpty()) return;
  // what has its new size since the last frame
  for (gui::OperationView* view : window.findChildren<gui::OperationView*>()) view->renderIfDirty();
  const QString place = folder + QLatin1Char('/') + QString::fromStdString(name) + ".png";
  EXPECT_TRUE(window.grab().save(place)) << place.toStdString();
}

}  // namespace perilymph::test
