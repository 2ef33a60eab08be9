// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers as outputs print them, and whether those of one quantity agree.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace perilymph::test {

/// What an output prints of a quantity: "8.87 ± 0.25" is 8.87 with 2 decimals and a half width of 0.25.
struct Reading {
  std::string output;
  double value = 0.0;
  int decimals = -1;  ///< -1: as many as the number has, in a file for programs.
  std::optional<double> half = {};
};

/// The number of decimals of a printed number.
inline int decimalsIn(const std::string& number)
{
  const auto point = number.find('.');
  return point == std::string::npos ? 0 : int(number.size() - point - 1);
}

/// What outputs say of the quantities of one patient.
class Readings {
public:
  /// From a file for programs: all digits.
  void add(const std::string& quantity, const std::string& output, double value,
           std::optional<double> half = {})
  {
    readings_[quantity].push_back({output, value, -1, half});
  }

  /// From a text: the first number after a label, and the one after ± if it has one. The label is a
  /// regular expression without groups.
  void addText(const std::string& quantity, const std::string& output, const std::string& text,
               const std::string& label)
  {
    std::smatch found;
    const std::regex pattern(label +
                             "\\s*(-?[0-9]+(?:\\.[0-9]+)?)(?:\\s*±\\s*([0-9]+(?:\\.[0-9]+)?))?");
    if (!std::regex_search(text, found, pattern)) {
      ADD_FAILURE() << output << " has no " << quantity << " after '" << label << "': " << text;
      return;
    }
    Reading reading{output, std::stod(found[1]), decimalsIn(found[1])};
    if (found[2].matched) {
      reading.half = std::stod(found[2]);
      EXPECT_EQ(decimalsIn(found[2]), reading.decimals) << output << ", " << quantity;
    }
    readings_[quantity].push_back(reading);
  }

  /// Compares every reading of a quantity with the one of most digits.
  ///
  /// @param outputs   Who has to say it, in this order.
  /// @param decimals  Of every printed text; CLI texts may have more.
  void expectOne(const std::string& quantity, const std::vector<std::string>& outputs,
                 int decimals) const
  {
    const auto& all = readings_.at(quantity);
    std::vector<std::string> found;
    for (const Reading& each : all) found.push_back(each.output);
    EXPECT_EQ(found, outputs) << quantity;
    const Reading* exact = &all.front();
    for (const Reading& each : all)
      if (each.decimals < 0 && (exact->decimals >= 0 || (each.half && !exact->half))) exact = &each;
    for (const Reading& each : all) {
      SCOPED_TRACE(quantity + ": " + each.output + " against " + exact->output);
      const bool isOfCli = each.output.find("text") != std::string::npos;
      const bool isShown = each.decimals >= 0 && !isOfCli;
      EXPECT_EQ(isShown ? each.decimals : decimals, decimals);
      expectSame(each.value, exact->value, each.decimals);
      if (each.half && exact->half) expectSame(*each.half, *exact->half, each.decimals);
    }
  }

private:
  /// Half a unit of the last digit; six digits of a file.
  static void expectSame(double printed, double exact, int decimals)
  {
    const double unit = decimals < 0 ? 1e-5 * std::fabs(exact) : std::pow(10.0, -decimals);
    EXPECT_NEAR(printed, exact, 0.5 * unit * (1.0 + 1e-9) + 1e-12);
  }

  std::map<std::string, std::vector<Reading>> readings_;
};

}  // namespace perilymph::test
