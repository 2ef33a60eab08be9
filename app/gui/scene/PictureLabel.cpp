// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/PictureLabel.h"

#include <QLabel>
#include <QVariant>

#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

QLabel* onPicture(QLabel* label, const char* name)
{
  label->setObjectName(QLatin1String(name));
  label->setFont(typeface(12));
  label->setProperty("onPicture", true);
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  return label;
}

}  // namespace

QLabel* pictureLabel(QWidget* parent, const char* name)
{
  return onPicture(new QLabel(parent), name);
}

QLabel* elidedPictureLabel(QWidget* parent, const char* name)
{
  return onPicture(new ElidedLabel(parent), name);
}

}  // namespace perilymph::gui
