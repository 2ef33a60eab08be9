// SPDX-License-Identifier: BSD-3-Clause
#include "gui/parts/ResultErrors.h"

#include <QCoreApplication>
#include <iterator>

namespace perilymph::gui {

namespace {

constexpr const char* results[] = {
    QT_TRANSLATE_NOOP("Data",
                      "This file carries no seal: it is of an earlier version of the program."),
    QT_TRANSLATE_NOOP("Data",
                      "This file was changed by hand after the program wrote it, so it has no "
                      "number. Do not use its values as results of the program."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 was changed after the program wrote it, so its results are not "
                      "continued. Delete it or give another folder."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 was changed by hand after the program wrote it; its insertions are "
                      "not run again. Use another copy of it."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 carries no seal: it is of an earlier version. Delete it or give "
                      "another folder."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is in use: another program works on it. Wait until it has ended."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is in use: another program works on it, or it cannot be locked "
                      "(%2). Wait until that program has ended."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 cannot be locked: %2. Check the folder's permissions and the space "
                      "on the disk."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 was changed by another program meanwhile; it is not replaced. Read "
                      "it again, and make the change in it."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is not replaced: versions, plans, insertions or outcomes in it "
                      "would be lost. Read it again."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is there already; it is not replaced. Open that patient, or use "
                      "another code."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 holds notes on a patient of this code and ear whose file is "
                      "missing. Rename it first."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 holds notes on a patient of this code and ear whose file is "
                      "missing; an import does not replace it. Rename it first."),
    QT_TRANSLATE_NOOP("Data", "%1 is of a newer program. Open it with that one."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 has landmarks of another CT series than the one that is open. Open "
                      "that CT, or place the landmarks in this one.")};

}  // namespace

std::vector<const char*> resultErrors() { return {std::begin(results), std::end(results)}; }

}  // namespace perilymph::gui
