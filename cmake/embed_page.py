# SPDX-License-Identifier: GPL-2.0-or-later
"""C++ with a page in it: embed_page.py OUT.cpp PAGE.html STYLE.css SCRIPT.js...

PAGE.html has the places @POLICY@, @STYLE@, @SCRIPT@, @DATA@ and @SCENE@, in any order but that DATA is before SCENE. The first three are filled here: the
policy permits this script and this style sheet by their SHA-256 and nothing else, neither from the page nor from elsewhere. The page is
cut at the other two, where the program puts its data."""
import base64
import hashlib
import sys


def read(path):
    """Without the licence line, which page.html has once."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines(keepends=True)
    return "".join(line for line in lines if "SPDX-License-Identifier" not in line)


def source_of(text):
    digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
    return f"'sha256-{digest}'"


def array(name, text):
    numbers = ",".join(map(str, text.encode()))
    return f"constexpr unsigned char {name}_bytes[] = {{{numbers}}};\n"


def view(name):
    return f"const std::string_view {name}(reinterpret_cast<const char*>({name}_bytes), sizeof {name}_bytes);\n"


def main():
    out, page, style, *scripts = sys.argv[1:]
    sheet = read(style)
    script = '"use strict";\n' + "".join(map(read, scripts))
    if "</script" in script or "<!--" in script:
        sys.exit("a script that would end its own element")
    policy = f"default-src 'none'; script-src {source_of(script)}; style-src {source_of(sheet)}; base-uri 'none'; form-action 'none'"
    with open(page, encoding="utf-8") as file:
        text = file.read()
    text = text.replace("@POLICY@", policy).replace("@STYLE@", sheet)
    before_data, rest = text.split("@DATA@")
    before_scene, after = rest.split("@SCENE@")
    parts = {"page_before_data": before_data, "page_before_scene": before_scene,
             "page_after_scene": after.replace("@SCRIPT@", script)}
    with open(out, "w", encoding="utf-8") as file:
        file.write('#include "report/page_parts.h"\n\nnamespace {\n')
        file.writelines(array(name, part) for name, part in parts.items())
        file.write("}  // namespace\n\nnamespace mikromakro {\n")
        file.writelines(map(view, parts))
        file.write("}  // namespace mikromakro\n")


main()
