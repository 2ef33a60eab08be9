// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Why a volume in a file of its own cannot be read, and what files state twice.

#include <QString>
#include <optional>
#include <span>

namespace perilymph::gui {

/// Sentences with placeholders %1 and so on, behind the name of a file.
std::span<const char* const> volumeErrors();

/// A quantity, place or remedy of a sentence about two statements, in the window's language; another
/// word as it is.
QString statedWord(const QString& word);

/// Numbers with the window's decimal sign; other words as statedWord().
QString localized(const QString& word);

/// What is before a sentence: "The file ", with a name or without, "The series ", or a path.
QString subjectOf(const QString& english);

/// A sentence of imaging::disagreement() in the window's language; empty for another one.
std::optional<QString> statedTwice(const QString& english);

}  // namespace perilymph::gui
