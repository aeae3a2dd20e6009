#!/usr/bin/python3
"""Manual pages and the completion of bash, from what the program says of itself.

usage: script/manual.py PROGRAM VERSION FOLDER

Asks PROGRAM and each of its commands for --help, and writes FOLDER/man1/*.1.gz and, for bash, FOLDER/<its name>.
"""

import gzip
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

DESCRIPTIONS_AT = 30  # the column of descriptions in a help text; longer names have a line to themselves


@dataclass
class Item:
    """One line of a list in a help text: an argument, an option or a command."""

    name: str
    description: str

    @property
    def spellings(self):
        return self.name.split()[0].split(",")

    @property
    def value(self):
        """What an option takes, as the help words it; empty of a switch."""
        words = re.sub(r" ?(REQUIRED|Needs:.*)", "", self.name).partition(" ")[2]
        return re.sub(r"^TEXT:(?=\{)|^INT:(?=INT)", "", words)

    @property
    def choices(self):
        found = re.fullmatch(r"\{(.*)\}", self.value)
        return found[1].split(",") if found else []

    @property
    def needs(self):
        found = re.search(r"Needs: (\S+)", self.name)
        return found[1] if found else None


@dataclass
class Command:
    program: str  # its name
    path: tuple[str, ...]  # ("attitude", "convert"); of the program itself ()
    purpose: str
    usage: str
    arguments: list[Item] = field(default_factory=list)
    options: list[Item] = field(default_factory=list)
    below: list["Command"] = field(default_factory=list)

    def with_all_below(self):
        yield self
        for command in self.below:
            yield from command.with_all_below()


def items_of(lines):
    items = []
    for line, next_line in zip(lines, [*lines[1:], ""]):
        if line.startswith(" " * DESCRIPTIONS_AT):
            items[-1].description = line.strip()
        elif next_line.startswith(" " * DESCRIPTIONS_AT):
            items.append(Item(line.strip(), ""))
        else:
            items.append(Item(line[:DESCRIPTIONS_AT].strip(), line[DESCRIPTIONS_AT:].strip()))
    return items


def sections_of(text):
    """The lists of a help text by their titles."""
    sections, title = {}, None
    for line in text.splitlines():
        if re.fullmatch(r"\w+:", line):
            title = sections.setdefault(line[:-1], [])
        elif title is not None and line.strip():
            title.append(line)
    return {name: items_of(lines) for name, lines in sections.items()}


def command_of(program, path=()):
    text = subprocess.run([program, *path, "--help"], check=True, capture_output=True, text=True).stdout
    purpose, usage = text.strip().splitlines()[:2]
    sections = sections_of(text)
    below = [command_of(program, (*path, item.name)) for item in sections.get("Subcommands", [])]
    return Command(Path(program).name, path, purpose, usage.removeprefix("Usage: "), sections.get("Positionals", []), sections["Options"], below)


def page_name(command):
    return "-".join((command.program, *command.path))


def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def page_items(title, items):
    lines = [f".SH {title}"] if items else []
    for item in items:
        value = f" \\fI{roff(item.value)}\\fR" if item.value else ""
        needs = f" (with {item.needs})" if item.needs else ""
        lines += [".TP", ", ".join(f"\\fB{roff(word)}\\fR" for word in item.spellings) + value, roff(item.description + needs)]
    return lines


def page_of(command, version, related):
    name = page_name(command)
    purpose = command.purpose.rstrip(".")
    if command.path:
        purpose = purpose[0].lower() + purpose[1:]
    lines = [
        f'.TH {name.upper()} 1 "" "{command.program} {version}" "User Commands"',
        ".SH NAME",
        f"{name} \\- {roff(purpose.removeprefix('Linkwright '))}",
        ".SH SYNOPSIS",
        f"\\fB{roff(' '.join((command.program, *command.path)))}\\fR {roff(command.usage.split(' ', 1 + len(command.path))[-1])}",
        *page_items("ARGUMENTS", command.arguments),
        *page_items("OPTIONS", command.options),
        *page_items("COMMANDS", [Item(c.path[-1], c.purpose) for c in command.below]),
        ".SH EXIT STATUS",
        "0 where it worked, 1 where something else failed, 2 on a mistake in a file or on the command line, which the message names.",
        ".SH SEE ALSO",
        ", ".join(f"\\fB{roff(other)}\\fR(1)" for other in related if other != name),
    ]
    return "\n".join(lines) + "\n"


def takes_file(item):
    return item.value == "TEXT"


def completion_case(command):
    """What a command offers, and what its options do instead: files, choices, nothing."""
    lines = [
        f'    "{" ".join(command.path)}")',
        f'      options="{" ".join(word for option in command.options for word in option.spellings)}"',
        f'      words="{" ".join(below.path[-1] for below in command.below)}"',
    ]
    if any(map(takes_file, command.arguments)):
        lines.append("      files=yes")
    offers = {}
    for option in command.options:
        if option.value:
            offer = f'words="{" ".join(option.choices)}" files={"yes" if takes_file(option) else ""}'
            offers.setdefault(offer, []).extend(option.spellings)
    if offers:
        lines.append('      case "$previous" in')
        lines += [f"        {' | '.join(words)}) {offer} ;;" for offer, words in offers.items()]
        lines.append("      esac")
    return [*lines, "      ;;"]


COMPLETION = """\
# Completion of {program}'s commands, options and files in bash.
{function}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command= options= words= files= word
  if [[ $current == = ]]; then current=; fi # --format=
  if [[ $previous == = ]]; then previous=${{COMP_WORDS[COMP_CWORD - 2]}}; fi
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case "$command/$word" in
      {known}) command="${{command:+$command }}$word" ;;
    esac
  done
  case "$command" in
{cases}
  esac
  if [[ $current == -* ]]; then
    words=$options
    files=
  fi
  mapfile -t COMPREPLY < <(compgen ${{files:+-f}} -W "$words" -- "$current")
  if [[ $files ]]; then compopt -o filenames 2>/dev/null; fi
}}
complete -F {function} {program}
"""


def completion_of(program):
    commands = list(program.with_all_below())
    known = " | ".join(f'"{" ".join(command.path[:-1])}/{command.path[-1]}"' for command in commands if command.path)
    cases = "\n".join(line for command in commands for line in completion_case(command))
    function = "_" + program.program.replace("-", "_")
    return COMPLETION.format(program=program.program, function=function, known=known, cases=cases)


def main(program, version, folder):
    root = command_of(program)
    names = sorted(page_name(command) for command in root.with_all_below())
    pages = Path(folder, "man1")
    pages.mkdir(parents=True, exist_ok=True)
    for command in root.with_all_below():
        page = page_of(command, version, names).encode()
        (pages / f"{page_name(command)}.1.gz").write_bytes(gzip.compress(page, mtime=0))
    Path(folder, root.program).write_text(completion_of(root))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
