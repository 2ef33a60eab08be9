# SPDX-License-Identifier: BSD-3-Clause
"""Line coverage by module, and untaken branches of the safety files, from gcovr's JSON.

A branch of a safety file that no test takes is a failure, unless test/support/coverage_unreached.txt
says why it cannot be taken; a reason there for what is taken by now is one, too, except where the threads
take it by chance.
"""

import json
import re
import sys
from collections import defaultdict
from pathlib import Path

ENGINE = {"foundation", "realtime", "anatomy", "electrode", "device", "mechanics", "haptics",
          "session", "analysis"}
MIN_FRACTION = 0.9
# The safety code: force and slew limits, passivity, validation of samples, faults of the workflow,
# the coupling limit, and time-outs of a device.
SAFETY = re.compile(r"modules/(haptics/.*/(Safety|Passivity|SampleValidator|CouplingLimit|"
                    r"WorkflowEvent|checkedSettings|InsertionEngine)|"
                    r"device/.*/(HidDevice|ForceWriter|OpeningMeasurement|PlugWatch|ReportReader))\.(cpp|h)$")
BY_CHANCE = "By chance: "  # how the reason of a race begins
REASONS = Path(__file__).with_name("coverage_unreached.txt")


def lines_of(file):
    return [line for line in file["lines"] if not line.get("gcovr/noncode")]


def print_table(files):
    runs = defaultdict(lambda: [0, 0])
    for file in files:
        module = file["file"].split("/")[1]
        for line in lines_of(file):
            runs[module][0] += line["count"] > 0
            runs[module][1] += 1
    print(f"{'module':<14}{'lines':>8}{'run':>8}{'share':>9}")
    for module, (run, of) in sorted(runs.items()):
        print(f"{module:<14}{of:>8}{run:>8}{100 * run / of:>8.1f}%")
    run = sum(runs[module][0] for module in ENGINE if module in runs)
    of = sum(runs[module][1] for module in ENGINE if module in runs)
    print(f"{'engine':<14}{of:>8}{run:>8}{100 * run / of:>8.1f}%")
    return run / of


def read_reasons(text):
    """{(file's name, line of code): reason} of 'file: code' followed by an indented reason."""
    reasons, key = {}, None
    for line in text.splitlines():
        if line.startswith("#") or not line.strip():
            continue
        if line.startswith("    "):
            reasons[key] = (reasons.get(key, "") + " " + line.strip()).strip()
        else:
            key = tuple(part.strip() for part in line.split(":", 1))
    return reasons


def missed_branches(files, code_of):
    """(file, line, code, taken, all) of each line of a safety file with an untaken branch."""
    for file in files:
        if not SAFETY.search(file["file"]):
            continue
        for line in lines_of(file):
            branches = line.get("branches", [])
            taken = sum(branch["count"] > 0 for branch in branches)
            if taken < len(branches):
                yield file["file"], line["line_number"], code_of(file["file"], line["line_number"]), taken, len(branches)


def check_branches(files, reasons, code_of):
    """Prints every untaken branch; returns error messages for those without a reason."""
    errors, used = [], set()
    print("\nBranches of what guards safety that no test takes:")
    for name, number, code, taken, of in missed_branches(files, code_of):
        key = (Path(name).name, code)
        reason = reasons.get(key)
        used.add(key)
        print(f"  {name}:{number}: {taken} of {of}: {reason or 'MISSED'}")
        if reason is None:
            errors.append(f"{name}:{number}: '{code}' has a branch that no test takes.")
    print(f"  {len(used)} lines in all, {len(errors)} of them without a reason")
    errors += [f"{REASONS.name} gives a reason for '{code}' of {name}, which is taken or gone."
              for (name, code), reason in reasons.items()
              if (name, code) not in used and not reason.startswith(BY_CHANCE)]
    return errors


def main(report, root):
    def code_of(name, number):
        return (Path(root) / name).read_text().splitlines()[number - 1].strip()

    files = json.load(open(report, encoding="utf-8"))["files"]
    share = print_table(files)
    errors = check_branches(files, read_reasons(REASONS.read_text()), code_of)
    if share < MIN_FRACTION:
        errors.append(f"The engine's tests run through {100 * share:.1f} % of its lines; "
                     f"{100 * MIN_FRACTION:.0f} % are wanted.")
    if errors:
        sys.exit("\n".join(errors))


if __name__ == "__main__":
    main(*sys.argv[1:])
