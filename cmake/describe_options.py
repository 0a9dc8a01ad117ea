# SPDX-License-Identifier: GPL-2.0-or-later
"""Man pages and bash completion of a program, from what its --help says: describe_options.py PROGRAM FOLDER

Writes FOLDER/man/PROGRAM.1, FOLDER/man/PROGRAM-VERB.1 for each verb, and FOLDER/completions/PROGRAM."""
import os
import re
import subprocess
import sys


def help_of(program, *verb):
    return subprocess.run([program, *verb, "--help"], check=True, capture_output=True, text=True).stdout


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def entries(text):
    """Of a help text: (title of the section, [(what stands left, its description)])."""
    sections = []
    for line in text.split("\n"):
        line = re.sub(r"^ {3,10}(?=--)|^ {2}(?=-\w,)", "  ", line)  # CLI11 >= 2.5 sets long names in a column of their own
        line = re.sub(r"^(  -\w,) +(?=--)", r"\1", line)
        if re.match(r"^\S.*:$", line):
            sections.append((line[:-1], []))
        elif sections and (match := re.match(r"^  (\S.*?)(?:  +(\S.*))?$", line)) and not line.startswith("   "):
            sections[-1][1].append([match[1], match[2] or ""])
        elif sections and sections[-1][1] and line.strip():
            sections[-1][1][-1][1] = (sections[-1][1][-1][1] + " " + line.strip()).strip()
    return [section for section in sections if section[1]]


def man_page(name, version, summary, text):
    usage = re.search(r"^(?:Usage: )?(\S+(?: \w+)? \[OPTIONS\].*)$", text, re.MULTILINE)
    lines = [f'.TH "{name.upper()}" 1 "" "{version}" "User commands"', ".SH NAME", f"{escaped(name)} \\- {escaped(summary)}"]
    if usage:
        lines += [".SH SYNOPSIS", escaped(usage[1])]
    for title, options in entries(text):
        lines.append(f'.SH "{title.upper()}"')
        for left, description in options:
            lines += [".TP", f"\\fB{escaped(left)}\\fR", escaped(description) or "\\&"]
    return "\n".join(lines) + "\n"


def completion(name, verbs):
    """Verbs, then the options of the verb, then files."""
    cases = "\n".join(f'    {verb}) words="{" ".join(options)}" ;;' for verb, options in verbs.items())
    return f"""# bash completion of {name}
_{name}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} words=
  case ${{COMP_CWORD}}:${{COMP_WORDS[1]}} in 1:*) COMPREPLY=($(compgen -W "{' '.join(verbs)} --help --version" -- "$current")); return ;; esac
  case ${{COMP_WORDS[1]}} in
{cases}
  esac
  case $current in
    -*) COMPREPLY=($(compgen -W "$words" -- "$current")) ;;
    *) COMPREPLY=($(compgen -f -- "$current")) ;;
  esac
}}
complete -o filenames -F _{name} {name}
"""


def main():
    program, folder = sys.argv[1:]
    name = os.path.basename(program)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.strip()
    whole = help_of(program)
    verbs = dict(option for title, options in entries(whole) if title.lower() == "subcommands" for option in options)
    for part in ("man", "completions"):
        os.makedirs(os.path.join(folder, part), exist_ok=True)
    pages = {name: man_page(name, version, whole.split("\n")[0].rstrip("."), whole)}
    options = {}
    for verb, summary in verbs.items():
        text = help_of(program, verb)
        pages[f"{name}-{verb}"] = man_page(f"{name}-{verb}", version, summary, text)
        options[verb] = sorted(set(re.findall(r"--[a-z][a-z-]*", " ".join(left for _, all_of in entries(text) for left, _ in all_of))))
    for page, text in pages.items():
        with open(os.path.join(folder, "man", page + ".1"), "w", encoding="utf-8") as file:
            file.write(text)
    with open(os.path.join(folder, "completions", name), "w", encoding="utf-8") as file:
        file.write(completion(name, options))


main()
