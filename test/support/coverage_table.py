"""Lines by module, and branches of the safety files that no test takes, from gcovr's JSON."""

import json
import re
import sys
from collections import defaultdict

ENGINE = {"foundation", "realtime", "anatomy", "electrode", "device", "mechanics", "haptics",
          "session", "analysis"}
LEAST_SHARE = 0.9
# What stands between a mistake and a hand.
SAFETY = re.compile(r"modules/(haptics/.*/(Safety|Passivity|SampleWatch|CouplingLimit|"
                    r"WorkflowEvent|checkedSettings|InsertionEngine)|"
                    r"device/.*/(HidHand|ForceWriter|ListenFirst|PlugWatch|ReportReader))\.(cpp|h)$")


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


def print_branches(files):
    print("\nBranches of what guards safety that no test takes:")
    missing = 0
    for file in files:
        if not SAFETY.search(file["file"]):
            continue
        for line in lines_of(file):
            branches = line.get("branches", [])
            taken = sum(branch["count"] > 0 for branch in branches)
            if taken < len(branches):
                missing += len(branches) - taken
                print(f"  {file['file']}:{line['line_number']}: {taken} of {len(branches)}")
    print(f"  {missing} in all")


def main(report):
    files = json.load(open(report, encoding="utf-8"))["files"]
    share = print_table(files)
    print_branches(files)
    if share < LEAST_SHARE:
        sys.exit(f"The engine's tests run through {100 * share:.1f} % of its lines; "
                 f"{100 * LEAST_SHARE:.0f} % are wanted.")


if __name__ == "__main__":
    main(sys.argv[1])
