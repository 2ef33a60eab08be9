// SPDX-License-Identifier: BSD-3-Clause
#include "gui/kiosk/QrView.h"

#include <qrencode.h>

#include <QPainter>
#include <algorithm>
#include <memory>

namespace perilymph::gui {

namespace {

constexpr int quietZone = 4;  // modules

}  // namespace

QImage qrCode(const QString& text)
{
  const QByteArray bytes = text.toUtf8();
  if (bytes.isEmpty()) return {};
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(
      QRcode_encodeData(int(bytes.size()),
                        reinterpret_cast<const unsigned char*>(bytes.constData()), 0, QR_ECLEVEL_L),
      &QRcode_free);
  if (!code) return {};
  const int side = code->width + 2 * quietZone;
  QImage image(side, side, QImage::Format_RGB32);
  image.fill(Qt::white);
  for (int y = 0; y < code->width; ++y)
    for (int x = 0; x < code->width; ++x)
      if ((code->data[y * code->width + x] & 1) != 0)
        image.setPixel(x + quietZone, y + quietZone, qRgb(0, 0, 0));
  return image;
}

QrView::QrView(QWidget* parent) : QWidget(parent)
{
  setObjectName(QStringLiteral("qrView"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void QrView::setText(const QString& text)
{
  if (text == text_) return;
  text_ = text;
  code_ = qrCode(text);
  setAccessibleName(text);
  update();
}

void QrView::paintEvent(QPaintEvent*)
{
  if (code_.isNull()) return;
  const double pixels = devicePixelRatioF();
  const int room = static_cast<int>(std::min(width(), height()) * pixels);
  const int module = std::max(1, room / code_.width());
  QImage shown = code_.scaled(code_.size() * module, Qt::IgnoreAspectRatio, Qt::FastTransformation);
  shown.setDevicePixelRatio(pixels);
  const double side = shown.width() / pixels;
  QPainter painter(this);
  // at whole pixels of the display, so that every module is as large as the others
  const auto whole = [pixels](double place) { return static_cast<int>(place * pixels) / pixels; };
  painter.drawImage(QPointF(whole(0.5 * (width() - side)), whole(0.5 * (height() - side))), shown);
}

}  // namespace perilymph::gui
