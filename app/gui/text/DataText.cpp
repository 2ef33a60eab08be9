// SPDX-License-Identifier: BSD-3-Clause
#include "gui/text/DataText.h"

#include <QCoreApplication>
#include <QLocale>
#include <charconv>

namespace perilymph::gui {

namespace {

/// A number with the window's decimal sign; another value as it is.
std::string localized(std::string value)
{
  double number = 0.0;
  const char* const end = value.data() + value.size();
  const auto [stop, problem] = std::from_chars(value.data(), end, number, std::chars_format::fixed);
  if (problem != std::errc{} || stop != end) return value;
  if (const std::size_t point = value.find('.'); point != std::string::npos)
    value.replace(point, 1, QString(QLocale().decimalPoint()).toStdString());
  return value;
}

std::string inLanguage(const char* english)
{
  return QCoreApplication::translate("Data", english).toStdString();
}

std::string translation(const Sentence& sentence)
{
  if (sentence.phrase() == nullptr) return localized(sentence);
  std::vector<std::string> values;
  for (const Sentence& value : sentence.values()) values.push_back(translation(value));
  return filled(inLanguage(sentence.phrase()), values);
}

}  // namespace

QString dataText(const Sentence& text)
{
  if (text.empty()) return {};
  // a text of a shipped file has no phrase: it is one
  return QString::fromStdString(text.phrase() == nullptr ? inLanguage(text.c_str())
                                                         : translation(text));
}

figures::Figure translated(figures::Figure figure)
{
  const auto translate = [](Sentence& text) { text = dataText(text).toStdString(); };
  translate(figure.title);
  translate(figure.x.title);
  translate(figure.y.title);
  for (auto& band : figure.bands) translate(band.label);
  for (auto& level : figure.levels) translate(level.label);
  for (auto& curve : figure.curves) translate(curve.label);
  for (auto& values : figure.values) translate(values.label);
  for (Sentence& note : figure.notes) translate(note);
  return figure;
}

}  // namespace perilymph::gui
