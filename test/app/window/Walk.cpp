// SPDX-License-Identifier: BSD-3-Clause
#include "Walk.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QCursor>
#include <QFile>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QRegularExpression>
#include <QTableView>
#include <algorithm>
#include <map>
#include <unordered_map>
#include <vector>

#include "gui/pages/insert/Pane.h"
#include "gui/widgets/ReadOut.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::test {

namespace {

/// All text in a window except that drawn by VTK.
QStringList textOn(const QWidget& window)
{
  QStringList sentence;
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    if (!each->isVisible()) continue;
    sentence << each->accessibleName();
    if (const auto* label = qobject_cast<const QLabel*>(each)) sentence << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) sentence << button->text();
    if (const auto* line = qobject_cast<const QLineEdit*>(each)) sentence << line->text();
    if (const auto* list = qobject_cast<const QComboBox*>(each)) sentence << list->currentText();
    if (const auto* number = qobject_cast<const gui::ReadOut*>(each)) sentence << number->caption();
    if (const auto* table = qobject_cast<const QTableView*>(each))
      for (int column = 0; column < table->model()->columnCount(); ++column)
        sentence << table->model()->headerData(column, Qt::Horizontal).toString();
  }
  return sentence;
}

/// The image with a palette: each next color is the one that most pixels miss most, as number times squared distance
/// to the nearest color before it. Half the size of a file.
QImage withPalette(const QImage& image)
{
  constexpr int size = 256;
  struct Color {
    QRgb color;
    double count, missed;
    int nearest;
  };
  std::map<QRgb, double> counts;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  std::vector<Color> colors;
  for (const auto& [color, count] : counts) colors.push_back({color, count, 1e9, 0});
  const auto isLess = [](const Color& a, const Color& b) {
    return a.count * a.missed < b.count * b.missed;
  };
  QImage indexed(image.size(), QImage::Format_Indexed8);
  for (int i = 0; i < size; ++i) {
    const auto worst = std::max_element(colors.begin(), colors.end(), isLess);
    if (worst->missed == 0.0) break;
    const QRgb added = worst->color;
    indexed.setColorCount(i + 1);
    indexed.setColor(i, added);
    for (Color& each : colors) {
      const double r = qRed(each.color) - qRed(added), g = qGreen(each.color) - qGreen(added),
                   b = qBlue(each.color) - qBlue(added);
      const double apart = r * r + g * g + b * b;
      if (apart < each.missed) each.missed = apart, each.nearest = i;
    }
  }
  std::unordered_map<QRgb, uchar> places;
  for (const Color& each : colors) places[each.color] = uchar(each.nearest);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) indexed.scanLine(y)[x] = places[image.pixel(x, y)];
  return indexed;
}

/// Rounds every channel: dark ones little, because the eye sees steps in the smooth shades of a dark
/// background, bright ones more, where letters, edges and the noise of a CT hide it. Half the file
/// size.
QImage smallened(QImage image)
{
  constexpr int dark = 56, fine = 2, coarse = 8;
  const auto rounded = [](int channel) {
    const int step = channel < dark ? fine : coarse;
    return std::min(255, (channel + step / 2) / step * step);
  };
  image = image.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < image.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x)
      line[x] = qRgb(rounded(qRed(line[x])), rounded(qGreen(line[x])), rounded(qBlue(line[x])));
  }
  return image;
}

}  // namespace

QImage pictureOf(QWidget& window)
{
  QCursor::setPos(window.mapToGlobal(QPoint(0, window.height() - 1)));
  // layouts within layouts answer a longer text one after another
  for (int i = 0; i < 8; ++i) QCoreApplication::processEvents();
  return smallened(window.grab().toImage());
}

void keepForGuide(QWidget& window, const std::string& name)
{
  const QString folder = qEnvironmentVariable("PERILYMPH_GUIDE_PICTURES");
  if (folder.isEmpty()) return;
  const QString place = folder + QLatin1Char('/') + QString::fromStdString(name) + ".png";
  EXPECT_TRUE(withPalette(pictureOf(window)).save(place, "PNG", 0)) << place.toStdString();
}

Walk::Walk(const char* page) : page_(page)
{
  QFile file(QString::fromStdString(resource("resources/guide/" + page_ + ".md").string()));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page;
  const QString text = QString::fromUtf8(file.readAll());
  static const QRegularExpression heading(QStringLiteral("^## (\\d+)\\. "),
                                          QRegularExpression::MultilineOption);
  auto found = heading.globalMatch(text);
  while (found.hasNext()) {
    const auto here = found.next();
    const auto end = text.indexOf(QLatin1String("\n## "), here.capturedEnd());
    steps_[here.captured(1).toInt()] = text.mid(here.capturedStart(), end - here.capturedStart());
  }
}

void Walk::step(int number, QWidget& window)
{
  ASSERT_EQ(steps_.count(number), 1u) << page_ << " has no step " << number;
  const QStringList seen = textOn(window);
  static const QRegularExpression bold(QStringLiteral("\\*\\*([^*]+)\\*\\*"));
  auto found = bold.globalMatch(steps_[number]);
  while (found.hasNext()) {
    const QString sentence = found.next().captured(1);
    const bool isSeen = std::any_of(seen.begin(), seen.end(),
                                    [&](const QString& each) { return each.contains(sentence); });
    EXPECT_TRUE(isSeen) << page_ << ", step " << number << ": nothing says “"
                        << sentence.toStdString() << "” on the window.";
  }
  steps_.erase(number);

  keepForGuide(window, page_ + "-" + std::to_string(number));
}

std::string Walk::left() const
{
  std::string numbers;
  for (const auto& [number, text] : steps_) numbers += std::to_string(number) + " ";
  return numbers;
}

}  // namespace perilymph::test
