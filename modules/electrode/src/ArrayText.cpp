// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/ArrayText.h"

#include <charconv>
#include <cmath>

namespace perilymph::electrode {
namespace {

/// The shortest decimal that reads back as the same number, with a point or an exponent, as TOML
/// requires of a number that is not whole.
std::string decimal(double value)
{
  char digits[32];
  std::string text(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

/// The number that a unit makes the value of: of the neighbors of the quotient, the one that gives the
/// same bits.
template <class Value, class Unit>
double numberIn(Value value, double near, const Unit& unit)
{
  for (const double each : {near, std::nextafter(near, -INFINITY), std::nextafter(near, INFINITY)})
    if (unit(each) == value) return each;
  return near;
}

double mm(Length length) { return numberIn(length, inMillimeters(length), millimeters); }
double MPa(Modulus modulus) { return numberIn(modulus, inMegapascals(modulus), megapascals); }
double perMm(Curvature curvature)
{
  return numberIn(curvature, inPerMillimeter(curvature), perMillimeter);
}
double Nm2(BendingStiffness stiffness) { return stiffness.si(); }

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char each : text) {
    constexpr const char* digits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(each);
    if (each == '"' || each == '\\')
      result += {'\\', each};
    else if (code < 0x20 || code == 0x7f)
      result += std::string("\\u00") + digits[code >> 4] + digits[code & 0xf];
    else
      result += each;
  }
  return result + '"';
}

/// Writes the tables of one file.
class ArrayWriter {
public:
  explicit ArrayWriter(const ArrayDesign& array) : array_(array) {}

  std::string write()
  {
    text("name", array_.name);
    text("maker", array_.maker);
    text("note", array_.note);
    table("length");
    number("value_mm", mm(array_.length));
    table("insertable");
    number("value_mm", mm(array_.insertable));
    writeSections();
    writeStiffness();
    if (isStated("rest_curvature") || array_.restCurvature.value != std::vector{Curvature()}) {
      table("rest_curvature");
      along("curvature_per_mm", array_.restCurvature, perMm);
    }
    table("contacts");
    numbers("from_tip_mm", array_.contactsFromTip, mm);
    number("contact_length_mm", mm(array_.contactLength));
    if (array_.plates != Plates::single) text("plates", nameIn(platesTable, array_.plates));
    if (array_.singlePlates > 0)
      text_ += "single_plates = " + std::to_string(array_.singlePlates) + '\n';
    if (array_.makerNumbering)
      text("maker_numbering", nameIn(makerNumberings, *array_.makerNumbering));
    if (array_.taper) {
      table("taper");
      numbers("last_contact_mm", std::vector{array_.taper->thinnest, array_.taper->thickest}, mm);
      number("carrier_MPa", MPa(array_.taper->carrier));
    }
    if (!array_.ribsFromTip.empty()) {
      table("ribs");
      numbers("from_tip_mm", array_.ribsFromTip, mm);
      number("height_mm", mm(array_.ribHeight));
      number("length_mm", mm(array_.ribLength));
    }
    if (array_.wires) writeWires(*array_.wires);
    if (array_.hasStylet) writeStylet(array_.stylet);
    return text_;
  }

private:
  void writeSections()
  {
    table("diameter");
    along("diameter_mm", array_.diameter, mm);
    if (array_.thickness.value != array_.diameter.value)
      numbers("thickness_mm", array_.thickness.value, mm);
    if (array_.tip.radius.si() <= 0.0) return;
    table("tip");
    number("radius_mm", mm(array_.tip.radius));
    number("taper_mm", mm(array_.tip.taper));
  }

  void writeStiffness()
  {
    table("bending");
    along("bending_N_m2", array_.bending, Nm2);
    if (array_.bendingAcross.value != array_.bending.value)
      numbers("bending_across_N_m2", array_.bendingAcross.value, Nm2);
    if (array_.twisting) numbers("twisting_N_m2", array_.twisting->value, Nm2);
  }

  void writeWires(const Wires& wires)
  {
    table("wires");
    along("number", wires.number, [](double number) { return number; });
    const auto micrometers = [](double value) { return millimeters(1e-3 * value); };
    number("diameter_um",
           numberIn(wires.diameter, 1e3 * inMillimeters(wires.diameter), micrometers));
    const auto gigapascals = [](double value) { return megapascals(1e3 * value); };
    number("modulus_GPa",
           numberIn(wires.modulus, 1e-3 * inMegapascals(wires.modulus), gigapascals));
    number("coupling", wires.coupling);
    writeYield(wires.yieldStress);
  }

  void writeStylet(const Stylet& stylet)
  {
    table("stylet");
    number("from_tip_mm", mm(stylet.fromTip));
    number("bending_N_m2", Nm2(stylet.bending));
    number("residual_curvature_fraction", stylet.residualCurvature);
    if (stylet.holdDepth) number("hold_depth_mm", mm(*stylet.holdDepth));
    if (stylet.diameter.si() > 0.0) number("diameter_mm", mm(stylet.diameter));
    if (stylet.yieldStress.maximum.si() > 0.0) writeYield(stylet.yieldStress);
  }

  void writeYield(const YieldStress& yield)
  {
    numbers("yield_range_MPa", std::vector{yield.minimum, yield.maximum}, MPa);
    if (yield.value.si() > 0.0) number("yield_MPa", MPa(yield.value));
  }

  const TableSource* sourceOf(const std::string& name) const
  {
    for (const auto& [table, source] : array_.provenance)
      if (table == name) return &source;
    return nullptr;
  }
  bool isStated(const char* name) const { return sourceOf(name) != nullptr; }

  /// Begins a table with its source.
  void table(const char* name)
  {
    text_ += std::string("\n[") + name + "]\n";
    const TableSource source =
        isStated(name) ? *sourceOf(name) : TableSource{"not stated", Confidence::low};
    text("source", source.source);
    text("confidence", nameOf(source.confidence));
  }

  void text(const char* key, const std::string& value)
  {
    text_ += std::string(key) + " = " + quoted(value) + '\n';
  }
  void number(const char* key, double value)
  {
    text_ += std::string(key) + " = " + decimal(value) + '\n';
  }
  template <class Value, class Unit>
  void numbers(const char* key, const std::vector<Value>& values, const Unit& unit)
  {
    std::string list;
    for (const Value& each : values) list += (list.empty() ? "" : ", ") + decimal(unit(each));
    text_ += std::string(key) + " = [" + list + "]\n";
  }
  template <class Value, class Unit>
  void along(const char* key, const AlongArray<Value>& values, const Unit& unit)
  {
    numbers("from_tip_mm", values.fromTip, mm);
    numbers(key, values.value, unit);
  }

  const ArrayDesign& array_;
  std::string text_;
};

}  // namespace

std::string arrayText(const ArrayDesign& array) { return ArrayWriter(array).write(); }

}  // namespace perilymph::electrode
