// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/electrode/ArrayText.h"

#include <cmath>
#include <cstdio>

#include "perilymph/foundation/TomlReader.h"

namespace perilymph::electrode {
namespace {

// Ranges of any array: wider than every known device, narrow enough to detect an error of the unit.
constexpr Range length_mm{5.0, 60.0};
constexpr Range diameter_mm{0.1, 2.0};
constexpr Range bending_N_m2{1e-9, 1e-4};
constexpr Range curvature_per_mm{-2.0, 2.0};
constexpr Range contactLength_mm{0.05, 5.0};
constexpr Range ribHeight_mm{0.01, 1.0};
constexpr Range ribLength_mm{0.05, 3.0};
constexpr double minTipRadius_mm = 0.02;
constexpr Range yield_MPa{20.0, 3000.0};

/// A number in its shortest form: "0.4", not "0.400000".
std::string plain(double value)
{
  char buffer[32];
  const int length = std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return std::string(buffer, static_cast<std::size_t>(length));
}

constexpr std::array confidences{Choice<Confidence>{Confidence::high, "high"},
                                 Choice<Confidence>{Confidence::medium, "medium"},
                                 Choice<Confidence>{Confidence::low, "low"}};

TableSource readTableSource(TomlReader& table)
{
  TableSource provenance;
  provenance.source = table.text("source");
  provenance.confidence = table.choice("confidence", confidences);
  return provenance;
}

/// Reads the tables of one file; errors are kept in the reader.
class ArrayReader {
public:
  explicit ArrayReader(TomlReader& file) : file_(file) {}

  ArrayDesign read()
  {
    ArrayDesign design;
    design.name = file_.text("name");
    design.maker = file_.text("maker");
    design.note = file_.text("note");
    readLengths(design);

    readSections(design);
    if (file_.has("tip")) readTip(design);
    readStiffness(design);
    readRestCurvature(design);
    readContacts(design);
    if (file_.has("taper")) readTaper(design);
    if (file_.has("ribs")) readRibs(design);
    if (file_.has("wires")) readWires(design);
    if (file_.has("stylet")) readStylet(design);
    design.provenance = std::move(provenance_);
    return design;
  }

private:
  TomlReader tableOf(const char* name)
  {
    TomlReader table = file_.table(name);
    provenance_.emplace_back(name, readTableSource(table));
    return table;
  }

  void readLengths(ArrayDesign& design)
  {
    TomlReader length = tableOf("length");
    max_mm_ = length.number("value_mm", length_mm);
    design.length = millimeters(max_mm_);
    TomlReader insertable = tableOf("insertable");
    design.insertable = millimeters(insertable.number("value_mm", {1.0, max_mm_}));
  }

  /// Positions along the array: within its length and strictly increasing.
  std::vector<double> places(TomlReader& table)
  {
    const std::vector<double> places = table.numbers("from_tip_mm", {0.0, max_mm_}, 1);
    for (std::size_t i = 1; i < places.size(); ++i)
      if (places[i] <= places[i - 1])
        table.refuse("from_tip_mm", "from_tip_mm has " + plain(places[i]) + " after " +
                                        plain(places[i - 1]) +
                                        "; each place must be greater than the one before.");
    return places;
  }

  /// Values at positions; `quantity` converts a number in the file's unit.
  template <class Value>
  AlongArray<Value> along(TomlReader& table, const char* key, Range allowed,
                          Value (*quantity)(double))
  {
    const std::vector<double> where = places(table);
    const std::vector<double> values = table.numbers(key, allowed, 1);
    if (values.size() != where.size())
      table.refuse(key, std::string(key) + " has " + std::to_string(values.size()) +
                            " numbers and from_tip_mm has " + std::to_string(where.size()) +
                            "; give one value for each place.");
    AlongArray<Value> result;
    for (const double place : where) result.fromTip.push_back(millimeters(place));
    for (const double value : values) result.value.push_back(quantity(value));
    result.value.resize(result.fromTip.size(), result.value.front());
    return result;
  }

  void readSections(ArrayDesign& design)
  {
    TomlReader table = tableOf("diameter");
    design.diameter = along<Length>(table, "diameter_mm", diameter_mm, millimeters);
    design.thickness = table.has("thickness_mm")
                           ? along<Length>(table, "thickness_mm", diameter_mm, millimeters)
                           : design.diameter;
  }

  void readTip(ArrayDesign& design)
  {
    TomlReader table = tableOf("tip");
    const double maximum = inMillimeters(design.tipRadius());
    design.tip.radius = millimeters(table.number("radius_mm", {minTipRadius_mm, maximum}));
    design.tip.taper = millimeters(table.number("taper_mm", {0.0, 0.5 * max_mm_}, 0.0));
  }

  void readStiffness(ArrayDesign& design)
  {
    TomlReader table = tableOf("bending");
    const auto read = [&](const char* key) {
      return along<BendingStiffness>(table, key, bending_N_m2, newtonSquareMeters);
    };
    design.bending = read("bending_N_m2");
    design.bendingAcross =
        table.has("bending_across_N_m2") ? read("bending_across_N_m2") : design.bending;
    if (table.has("twisting_N_m2")) design.twisting = read("twisting_N_m2");
  }

  void readRibs(ArrayDesign& design)
  {
    TomlReader table = tableOf("ribs");
    for (const double place : places(table)) design.ribsFromTip.push_back(millimeters(place));
    design.ribHeight = millimeters(table.number("height_mm", ribHeight_mm));
    design.ribLength = millimeters(table.number("length_mm", ribLength_mm));
  }

  void readRestCurvature(ArrayDesign& design)
  {
    AlongArray<Curvature>& rest = design.restCurvature;
    rest = {{millimeters(0.0)}, {perMillimeter(0.0)}};
    if (!file_.has("rest_curvature")) return;
    TomlReader table = tableOf("rest_curvature");
    rest = along<Curvature>(table, "curvature_per_mm", curvature_per_mm, perMillimeter);

    // A carrier cannot curl more tightly than its own half thickness.
    for (std::size_t i = 0; i < rest.value.size(); ++i) {
      const double radius_mm = 0.5 * inMillimeters(design.thickness.at(rest.fromTip[i]));
      const double curvature = inPerMillimeter(rest.value[i]);
      if (std::fabs(curvature) * radius_mm < 1.0) continue;
      table.refuse("curvature_per_mm", "curvature_per_mm has " + plain(curvature) + " at " +
                                           plain(inMillimeters(rest.fromTip[i])) +
                                           " mm; it must be between " + plain(-1.0 / radius_mm) +
                                           " and " + plain(1.0 / radius_mm) +
                                           ", one over the carrier's radius there.");
    }
  }

  void readContacts(ArrayDesign& design)
  {
    TomlReader table = tableOf("contacts");
    const std::vector<double> centers = places(table);
    const double contact = table.number("contact_length_mm", contactLength_mm);
    design.contactLength = millimeters(contact);
    design.plates = table.choice("plates", platesTable, Plates::single);
    design.singlePlates =
        static_cast<int>(table.integer("single_plates", 0, static_cast<long>(centers.size()), 0));
    if (table.has("maker_numbering"))
      design.makerNumbering = table.choice("maker_numbering", makerNumberings);
    for (const double center : centers) design.contactsFromTip.push_back(millimeters(center));

    const auto refuse = [&](const std::string& what) {
      table.refuse("from_tip_mm", "a contact of " + plain(contact) + " mm at " + what);
    };
    // Decimal fractions are inexact: an overlap below a nanometer is ignored.
    constexpr double slack_mm = 1e-6;
    for (std::size_t i = 1; i < centers.size(); ++i)
      if (centers[i] - centers[i - 1] < contact - slack_mm)
        refuse(plain(centers[i]) + " mm overlaps the one at " + plain(centers[i - 1]) +
               " mm; centers must be at least a contact's length apart.");
    if (centers.front() < 0.5 * contact - slack_mm)
      refuse(plain(centers.front()) + " mm reaches beyond the tip; its center must be at least " +
             plain(0.5 * contact) + " mm from it.");
    if (centers.back() > max_mm_ - 0.5 * contact + slack_mm)
      refuse(plain(centers.back()) + " mm reaches beyond the array's " + plain(max_mm_) +
             " mm; its center must be at most " + plain(max_mm_ - 0.5 * contact) +
             " mm from the tip.");
  }

  void readTaper(ArrayDesign& design)
  {
    TomlReader table = tableOf("taper");
    const Length last = design.contactsFromTip.back();
    const double tip = inMillimeters(design.diameter.at(millimeters(0))),
                 base = inMillimeters(design.diameter.value.back());
    const std::vector<double> range = table.numbers("last_contact_mm", diameter_mm, 2);
    const bool isRange =
        range.size() == 2 && range[0] < range[1] && range[0] >= tip && range[1] <= base;
    if (!isRange)
      table.refuse("last_contact_mm",
                   "last_contact_mm must be two widths at the most basal contact, the smaller "
                   "first, between the tip's " +
                       plain(tip) + " mm and the base's " + plain(base) + " mm.");
    if (design.diameter.fromTip.back() <= last)
      table.refuse("last_contact_mm",
                   "last_contact_mm needs the width of the base: give [diameter] a place behind "
                   "the most basal contact, at " +
                       plain(inMillimeters(last)) + " mm.");
    const Modulus carrier = megapascals(table.number("carrier_MPa", {0.1, 20.0}));
    // the array's stiffness includes that of its silicone; both have few digits
    for (std::size_t i = 0; i < design.bending.fromTip.size(); ++i) {
      const Length place = design.bending.fromTip[i];
      const double w = design.diameter.at(place).si(), t = design.thickness.at(place).si(),
                   silicone = carrier.si() * pi * w * t * t * t / 64.0,
                   all = design.bending.value[i].si();
      if (silicone <= 1.01 * all) continue;
      table.refuse("carrier_MPa", "silicone of " + plain(inMegapascals(carrier)) + " MPa gives " +
                                      "the section at " + plain(inMillimeters(place)) +
                                      " mm a bending stiffness of " + plain(silicone) +
                                      " N m2, and bending_N_m2 states " + plain(all) +
                                      " for the whole array there; state a softer one.");
    }
    if (isRange) design.taper = {millimeters(range[0]), millimeters(range[1]), carrier};
  }

  /// The range of a yield stress, which must be given, and a value within it, which may.
  YieldStress readYieldStress(TomlReader& table)
  {
    const std::vector<double> range = table.numbers("yield_range_MPa", yield_MPa, 2);
    const bool isRange = range.size() == 2 && range[0] < range[1];
    if (!isRange)
      table.refuse("yield_range_MPa",
                   "yield_range_MPa must be two numbers, the smallest and the greatest yield "
                   "stress that is possible, the smallest first.");
    const Range allowed = isRange ? Range{range[0], range[1]} : yield_MPa;
    const double value = table.has("yield_MPa") ? table.number("yield_MPa", allowed) : 0.0;
    return {megapascals(value), megapascals(allowed.low), megapascals(allowed.high)};
  }

  void readWires(ArrayDesign& design)
  {
    TomlReader table = tableOf("wires");
    Wires wires;
    wires.number = along<double>(table, "number", {0.0, 100.0}, [](double n) { return n; });
    wires.diameter = millimeters(1e-3 * table.number("diameter_um", {5.0, 150.0}));
    wires.modulus = megapascals(1e3 * table.number("modulus_GPa", {20.0, 400.0}));
    wires.coupling = table.number("coupling", {0.0, 2.0});
    wires.yieldStress = readYieldStress(table);
    // the array's stiffness includes that of its wires; both have few digits
    for (const Length place : wires.number.fromTip) {
      const double minimum = std::min(design.bending.at(place), design.bendingAcrossAt(place)).si();
      const double all = wires.singleAt(place).bending.si() + wires.bundleAt(place).bending.si();
      if (all <= 1.01 * minimum) continue;
      table.refuse("number", "the wires at " + plain(inMillimeters(place)) +
                                 " mm have a bending "
                                 "stiffness of " +
                                 plain(all) + " N m2, and bending_N_m2 states " + plain(minimum) +
                                 " for the whole array there; state fewer or thinner "
                                 "wires, or a lower coupling.");
    }
    design.wires = std::move(wires);
  }

  void readStylet(ArrayDesign& design)
  {
    TomlReader table = tableOf("stylet");
    design.hasStylet = true;
    design.stylet.fromTip = millimeters(table.number("from_tip_mm", {0.0, max_mm_}));
    design.stylet.bending = newtonSquareMeters(table.number("bending_N_m2", bending_N_m2));
    design.stylet.residualCurvature = table.number("residual_curvature_fraction", {0.0, 1.0}, 0.0);
    if (table.has("hold_depth_mm"))
      design.stylet.holdDepth =
          millimeters(table.number("hold_depth_mm", {0.0, inMillimeters(design.insertable)}));
    design.stylet.provenance = provenance_.back().second;
    if (table.has("diameter_mm"))
      design.stylet.diameter = millimeters(table.number("diameter_mm", {0.02, 0.5}));
    if (table.has("yield_MPa") || table.has("yield_range_MPa"))
      design.stylet.yieldStress = readYieldStress(table);
  }

  TomlReader& file_;
  double max_mm_ = 0.0;
  std::vector<std::pair<std::string, TableSource>> provenance_;
};

}  // namespace

std::string nameOf(Confidence confidence) { return std::string(nameIn(confidences, confidence)); }

namespace {

Result<ArrayDesign> arrayIn(Result<TomlReader> reader)
{
  if (!reader) return reader.error();
  ArrayDesign design = ArrayReader(*reader).read();
  if (const Result<void> done = reader->finish(); !done) return done.error();
  return design;
}

}  // namespace

Result<ArrayDesign> loadArray(const std::filesystem::path& file)
{
  return arrayIn(TomlReader::open(file));
}

Result<ArrayDesign> parseArray(const std::string& text, const std::string& name)
{
  return arrayIn(TomlReader::parse(text, name));
}

}  // namespace perilymph::electrode
