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
    QT_TRANSLATE_NOOP(
        "Data",
        "The measures of %1 were changed by hand after the program wrote them. Do not "
        "use them as measured in a CT."),
    QT_TRANSLATE_NOOP("Data",
                      "The measures of %1 carry no seal: their file is of an earlier version or of "
                      "another program."),
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
    QT_TRANSLATE_NOOP("Data", "%1 would be larger than 4 MiB. Shorten the notes or remove scans."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is empty: the program that began it ended before it wrote anything. "
                      "Delete it."),
    QT_TRANSLATE_NOOP(
        "Data", "%1 is not a recording; an exported patient has nothing else there. Remove it."),
    QT_TRANSLATE_NOOP("Data", "%1 cannot be imported: %2"),
    QT_TRANSLATE_NOOP("Data", "%1 holds more than 10000 recordings. Remove some."),
    QT_TRANSLATE_NOOP(
        "Data", "A record keeps at most 256 versions and 10000 plans, insertions and outcomes."),
    QT_TRANSLATE_NOOP("Data", "Notes have %1 characters; at most 4000 are kept. Shorten them."),
    QT_TRANSLATE_NOOP("Data", "There are %1 tags; at most 16 are kept. Remove some."),
    QT_TRANSLATE_NOOP("Data", "There are %1 scans; at most 64 are kept. Remove some."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The tag \"%1\" is not possible: it has 1 to 24 characters and no comma. Change it."),
    QT_TRANSLATE_NOOP("Data", "The tag \"%1\" stands twice. Remove one."),
    QT_TRANSLATE_NOOP(
        "Data", "%1 The file is not replaced; move it away, or open it with a newer version."),
    QT_TRANSLATE_NOOP("Data", "%1 exists. Give the name of a new folder."),
    QT_TRANSLATE_NOOP("Data", "The copy was canceled; nothing of it was kept."),
    QT_TRANSLATE_NOOP(
        "Data", "The library has %1, right ear, already. Rename or remove that patient first."),
    QT_TRANSLATE_NOOP(
        "Data", "The library has %1, left ear, already. Rename or remove that patient first."),
    QT_TRANSLATE_NOOP("Data", "%1 exists; an import replaces no recording. Rename it first."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is not the record of a patient: it needs format, tags, notes and "
                      "archived. Restore it from a backup, or remove it."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 cannot be created: %2. Check the folder's permissions and the space on the disk."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 cannot be created: its file system has no hard links. Give a folder on another disk."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 was begun by another build of the program (%2; this is %3). Delete it or "
                      "give another folder."),
    QT_TRANSLATE_NOOP("Data", "%1 is for other insertions. Delete it or give another folder."),
    QT_TRANSLATE_NOOP(
        "Data", "%1 takes no more %2: %3. Those before are kept; make space and run it again."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 has %2 insertions, not %3 of each of %4 arrays. Make the plan again."),
    QT_TRANSLATE_NOOP("Data", "The plan.json beside %1 is of another plan. Make the plan again."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 is not a plan: %2. Give the folder that 'perilymph-cli plan' wrote."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 holds no plan.json: the plan was not finished. The same 'perilymph-cli "
                      "plan' continues it."),
    QT_TRANSLATE_NOOP(
        "Data",
        "%1 has no insertions yet. Run 'perilymph-cli study run' or merge its shards first."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 has %2 insertions; at most %3 can be shown. Open one of its shards, or "
                      "query it with SQL."),
    QT_TRANSLATE_NOOP("Data", "%1 is of a newer program. Open it with that one."),
    QT_TRANSLATE_NOOP("Data", "%1 places the landmark %2 at two points. Keep one of them."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 states \"%2\" twice in one object. Save the points in Slicer again."),
    QT_TRANSLATE_NOOP("Data",
                      "%1 has landmarks of another CT series than the one that is open. Open "
                      "that CT, or place the landmarks in this one.")};

}  // namespace

std::vector<const char*> resultErrors() { return {std::begin(results), std::end(results)}; }

}  // namespace perilymph::gui
