// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/figures/Svg.h"

#include <charconv>
#include <cstdio>

#include "perilymph/foundation/Utf8.h"

namespace perilymph::figures {

namespace {

/// Hundredths of a point exceed any printer's resolution.
std::string number(double value)
{
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 2);
  std::string result(text, end.ptr);
  return result == "-0.00" ? "0.00" : result;
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char letter : onOneLine(text)) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else if (letter == '"')
      result += "&quot;";
    else
      result += letter;
  }
  return result;
}

std::string color(const Ink& ink)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", ink.rgb[0], ink.rgb[1], ink.rgb[2]);
  return text;
}

/// fill="#..." with its opacity if not 1.
std::string painted(const char* what, const Ink& ink)
{
  std::string result = std::string(" ") + what + "=\"" + color(ink) + "\"";
  if (ink.opacity < 1.0)
    result += std::string(" ") + what + "-opacity=\"" + number(ink.opacity) + "\"";
  return result;
}

std::string places(const std::vector<PagePoint>& points)
{
  std::string result;
  for (const PagePoint& point : points)
    result += (result.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return result;
}

struct Writer {
  std::string operator()(const Area& area) const
  {
    return "<polygon points=\"" + places(area.points) + "\"" + painted("fill", area.ink) + "/>\n";
  }

  std::string operator()(const Stroke& stroke) const
  {
    std::string dashes;
    if (stroke.dash > 0.0)
      dashes = " stroke-dasharray=\"" + number(stroke.dash) + " " + number(stroke.dash) + "\"";
    return "<polyline points=\"" + places(stroke.points) + "\" fill=\"none\"" +
           painted("stroke", stroke.ink) + " stroke-width=\"" + number(stroke.width) + "\"" +
           dashes + "/>\n";
  }

  std::string operator()(const Disk& disk) const
  {
    return "<circle cx=\"" + number(disk.center.x) + "\" cy=\"" + number(disk.center.y) +
           "\" r=\"" + number(disk.radius) + "\"" + painted("fill", disk.fill) +
           painted("stroke", disk.outline) + "/>\n";
  }

  std::string operator()(const Label& label) const
  {
    constexpr const char* anchors[] = {"start", "middle", "end"};
    const std::string place = " x=\"" + number(label.at.x) + "\" y=\"" + number(label.at.y) + "\"";
    std::string turned;
    if (label.direction == Direction::upward)
      turned = " transform=\"rotate(-90 " + number(label.at.x) + " " + number(label.at.y) + ")\"";
    return "<text" + place + turned + " font-size=\"" + number(label.size) + "\" text-anchor=\"" +
           anchors[static_cast<int>(label.anchor)] + "\"" +
           (label.isBold ? " font-weight=\"bold\"" : "") + painted("fill", label.ink) + ">" +
           escaped(label.text) + "</text>\n";
  }
};

}  // namespace

std::string svg(const Drawing& drawing)
{
  const std::string size = number(drawing.width) + " " + number(drawing.height);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"" +
      number(drawing.width) + "pt\" height=\"" + number(drawing.height) + "pt\" viewBox=\"0 0 " +
      size +
      "\" font-family=\"Inter, Helvetica, Arial, sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const Mark& mark : drawing.marks) text += std::visit(Writer{}, mark);
  return text + "</svg>\n";
}

}  // namespace perilymph::figures
