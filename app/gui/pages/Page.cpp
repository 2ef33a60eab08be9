// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/Page.h"

#include <utility>

namespace perilymph::gui {

Page::Page(const char* id, QString name, Icon icon, QWidget* parent)
    : QWidget(parent), id_(QLatin1String(id)), name_(std::move(name)), icon_(icon)
{
  setObjectName(id_ + QLatin1String("Page"));
}

Page::Acceptance Page::accepts(const std::filesystem::path& /*file*/) const
{
  return Acceptance::none;
}

void Page::open(const std::filesystem::path& /*file*/) {}

bool Page::takeKey(const QKeyEvent& /*event*/) { return false; }

}  // namespace perilymph::gui
