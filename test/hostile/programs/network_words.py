# SPDX-License-Identifier: BSD-3-Clause
"""No source of the programs includes network headers, and no build file links network libraries, but in the
module that --igtl asks for, in that of `archive`, and in the plug-in of a device whose service is asked by a socket, which
no program contains."""

import re
import sys
from pathlib import Path

HEADERS = re.compile(
    r'#\s*include\s*[<"](sys/socket\.h|sys/un\.h|netinet/|arpa/|net/|netdb\.h|curl/|boost/asio|asio|'
    r'QtNetwork|QNetwork|QTcp|QUdp|QSsl|QLocalServer|QLocalSocket|QWebSocket|QDesktopServices|'
    r'dcmtk/|vtkSocket|vtkClientSocket|vtkServerSocket|vtkWeb|spdlog/sinks/(tcp|udp))')
LIBRARIES = re.compile(r"Qt\S*::(Network|WebSockets|WebEngine)|VTK::Web|CURL::|libcurl|OpenSSL::|DCMTK::")
ASKED_FOR = ("modules/archive/", "modules/broadcast/", "plugins/devices/haply/")
CODE = {".h", ".hpp", ".c", ".cc", ".cpp", ".cxx"}


def findings(root):
    for part in ("modules", "app", "plugins"):
        for file in sorted((root / part).rglob("*")):
            pattern = (HEADERS if file.suffix in CODE else
                       LIBRARIES if file.name == "CMakeLists.txt" or file.suffix == ".cmake" else None)
            if pattern is None or file.relative_to(root).as_posix().startswith(ASKED_FOR):
                continue
            for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
                if pattern.search(line):
                    yield f"{file.relative_to(root)}:{number}: {line.strip()}"


def main(root):
    # The patterns themselves work.
    assert HEADERS.search("#include <sys/socket.h>") and LIBRARIES.search("Qt5::Network")
    found = list(findings(root))
    for line in found:
        print(line)
    if found:
        sys.exit("The programs speak to no network; take the lines above out.")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
