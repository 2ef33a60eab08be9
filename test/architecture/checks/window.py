"""The window: where text may be markup."""

import re
from pathlib import Path

from checks import sources

# Text of a file or of a person is text: labels and tips are plain (Application.cpp). Where markup is
# made, everything that comes from outside is escaped; these are the only places.
MARKUP = re.compile(r"\b(?:RichText|AutoText|setHtml|insertHtml|setMarkdown|QStaticText|QMessageBox|"
                    r"QTextEdit|QTextBrowser|QTextDocument)\b")
MARKUP_PLACES = {"Application.cpp", "GuideSheet.cpp", "Report.cpp"}


def check_markup(root, wrong):
    for file in sources.files(root, "app/gui", suffixes=sources.CODE):
        if file.name in MARKUP_PLACES:
            continue
        text = sources.without_comments(sources.read(file))
        for match in MARKUP.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            wrong.append(f"{file.relative_to(root)}:{line}: '{match.group(0)}' may draw text as markup, "
                         f"which belongs to {', '.join(sorted(MARKUP_PLACES))}.")


def check(root):
    root = Path(root)
    wrong = []
    check_markup(root, wrong)
    return wrong
