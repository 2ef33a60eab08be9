// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Numbers of a DICOM header. A tag that is present and unreadable is a fault, never a default.

#include <vtkDICOMTag.h>
#include <vtkDICOMValue.h>

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "perilymph/foundation/Sentence.h"

namespace perilymph::imaging {

/// A decimal number as DICOM writes it (PS3.5, DS and IS): an optional sign, digits, a point, an exponent, blanks
/// around it. None where the text is anything else, or not finite.
std::optional<double> decimalNumber(std::string_view text);

/// "RescaleSlope (0028,1053)"
std::string nameOf(vtkDICOMTag tag);

/// Reads numbers and collects what is there and is none.
class TagNumbers {
public:
  /// `count` numbers of a tag; none where it is absent or empty. A fault is noted where it holds another count or
  /// anything but finite numbers. Text of any representation is read as a number.
  std::optional<Eigen::VectorXd> read(const vtkDICOMValue& value, vtkDICOMTag tag,
                                      std::size_t count);

  /// One number.
  std::optional<double> read(const vtkDICOMValue& value, vtkDICOMTag tag);

  /// One whole number from `minimum` to `maximum`.
  std::optional<int> readWhole(const vtkDICOMValue& value, vtkDICOMTag tag, int minimum,
                               int maximum);

  /// Clauses, each with the tag and its text: "Rows (0028,0010) as \"two\", where one number belongs".
  const std::vector<Sentence>& faults() const { return faults_; }

private:
  void note(vtkDICOMTag tag, const std::string& text, const Sentence& expected);

  std::vector<Sentence> faults_;
};

}  // namespace perilymph::imaging
