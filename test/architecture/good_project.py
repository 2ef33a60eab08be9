# SPDX-License-Identifier: BSD-3-Clause
"""A small project that every check accepts."""

TABLES = """
<!-- arrows -->
| Layer | Module | May use, directly | Read first | What it knows |
|---|---|---|---|---|
| 0 | `ground` | - | `g.h` | words |
| 1 | `upper` | `ground` | `u.h` | sentences |
| 1 | `beside` | `ground` | `b.h` | others |
| 2 | `top` | `upper` | `t.h` | stories |
| 8 | `app/gui` | every module | `main.cpp` | the window |
<!-- /arrows -->
<!-- libraries -->
| Library | Included as | Where |
|---|---|---|
| Qt | `Q[A-Z]*` | `app/gui` |
| VTK | `vtk*` | `app/gui` |
<!-- /libraries -->
"""


GUI_TABLE = """# The window

<!-- gui-arrows -->
| Folder | May use, directly | What it knows |
|---|---|---|
| `run` | - | what works without widgets |
| `pages/one` | `run` | a page |
| `pages/two` | `run` | another page |
| `frame` | `pages/one` `pages/two` | the frame |
<!-- /gui-arrows -->
"""


def good_project():
    """Path -> text of a project without errors."""
    project = {
        "CMakeLists.txt": "", "packaging/run": "", "test/CMakeLists.txt": "",
        "modules/README.md": TABLES,
        "README.md": "# Good\n\n## The map\n\n```\napp/   what starts\n  gui  the window\n"
                     "modules/   what it knows\n  beside  others\n  ground  words\n"
                     "  top     stories\n  upper   sentences\n"
                     "packaging/  how it travels\ntest/  how we know\n```\n",
        "app/gui/main.cpp": '#include <QWidget>\n#include "perilymph/top/t.h"\n#include "gui/frame/frame.h"\n',
        "app/gui/README.md": GUI_TABLE,
    }
    for name, uses in (("run", ""), ("pages/one", "USES run"), ("pages/two", "USES run"), ("frame", "USES pages/one pages/two")):
        home, leaf = f"app/gui/{name}", name.split("/")[-1]
        project[f"{home}/CMakeLists.txt"] = f"perilymph_gui_part({name} {uses}\n  SOURCES {leaf}.cpp)\n"
        project[f"{home}/{leaf}.h"] = "#pragma once\n"
        project[f"{home}/{leaf}.cpp"] = f'#include "gui/{name}/{leaf}.h"\n'
    for name, uses in (("ground", ""), ("upper", "USES ground"), ("beside", "USES ground"), ("top", "USES upper")):
        home = f"modules/{name}"
        project[f"{home}/README.md"] = f"# {name}\n\nRead `{name[0]}.h` first.\n"
        project[f"{home}/CMakeLists.txt"] = (f'perilymph_module({name} LAYER engine\n  SUMMARY "USES (of) {name}"\n  {uses}\n'
                                             f"  SOURCES src/{name[0]}.cpp)\n")
        project[f"{home}/include/perilymph/{name}/{name[0]}.h"] = "#pragma once\n"
        project[f"{home}/src/{name[0]}.cpp"] = f'#include "perilymph/{name}/{name[0]}.h"\n'
    return project
