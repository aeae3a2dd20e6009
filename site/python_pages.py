"""The Python interface as a page, from the docstrings of the module as it was built."""

import importlib
import inspect
import re
import sys

NOT_BUILT = "# Python\n\nThe Python module was not built when this site was made.\n"
SECTIONS = ("Args:", "Returns:", "Raises:", "Yields:")
ANNOTATION = re.compile(r"(: |-> )(?:'([^']*)'|\"([^\"]*)\")")
ROLE = re.compile(r":\w+:`~?([\w.]+)`")


def folder_of_module(build):
    """What belongs on PYTHONPATH; None where the module is not built."""
    folder = build / "release/python"
    return folder if list(folder.glob("linkwright/_linkwright*.so")) else None


def signature_of(name, value):
    """As it is written, without self; of a compiled function its docstring's first line has it."""
    try:
        signature = ANNOTATION.sub(lambda match: match[1] + (match[2] or match[3]), str(inspect.signature(value)))
        return name + re.sub(r"^\(self(?:, )?", "(", signature)
    except (TypeError, ValueError):
        first = (inspect.getdoc(value) or "").partition("\n")[0]
        return first if first.startswith(f"{name.rpartition('.')[2]}(") else f"{name}(…)"


def linked(words):
    """Inline marks of docstrings as Markdown."""
    words = ROLE.sub(lambda match: f"`{match[1]}`", words)
    return re.sub(r"``([^`]+)``", r"`\1`", words)


def listed(lines):
    """The entries of a section, "name: meaning" over one line or more, as a list; what has no names as a paragraph."""
    entry = re.compile(r"^    (\*{0,2}\w[\w., ]*): (.*)$")
    for line in lines:
        match = entry.match(line)
        yield f"- `{match[1]}`: {linked(match[2])}" if match else f"  {linked(line.strip())}"


def prose(words):
    """A docstring as Markdown: paragraphs, sections as lists, examples as code."""
    for part in re.split(r"\n\s*\n", words.strip()):
        lines = part.split("\n")
        if lines[0] in SECTIONS:
            yield f"**{lines[0].rstrip(':')}**\n"
            yield "\n".join(listed(lines[1:])) + "\n"
        elif lines[0].startswith(("    ", ">>>")):
            yield "```pycon\n" + inspect.cleandoc("\n" + part) + "\n```\n"
        else:
            yield linked(part) + "\n"


def words_of(value, signature):
    """Its docstring without the line that is shown as its signature."""
    return (inspect.getdoc(value) or "").removeprefix(signature).strip()


def is_property(value):
    return isinstance(value, property) or inspect.isdatadescriptor(value)


def members_of(value):
    """Public members of a class or module of ours, in the order of the source."""
    for name, member in vars(value).items():
        own = not inspect.ismodule(value) or getattr(member, "__module__", "") == value.__name__
        if not name.startswith("_") and own and (callable(member) or is_property(member) or isinstance(member, (classmethod, staticmethod))):
            yield name, member


def shown_function(name, value, level):
    signature = signature_of(name, value)
    yield f"{'#' * level} {name} {{ #{name} }}\n"
    yield f"```python\n{signature}\n```\n"
    yield from prose(words_of(value, signature))


def shown_class(name, value, level):
    yield f"{'#' * level} class {name} {{ #{name} }}\n"
    yield from prose(inspect.getdoc(value) or "")
    for member_name, member in members_of(value):
        whole = f"{name}.{member_name}"
        if is_property(member):
            yield f"{'#' * (level + 1)} {whole} {{ #{whole} }}\n"
            yield from prose(inspect.getdoc(member) or "")
        else:
            yield from shown_function(whole, getattr(value, member_name), level + 1)


def shown(name, value, level=2):
    if inspect.isclass(value):
        yield from shown_class(name, value, level)
    elif inspect.ismodule(value):
        yield f"{'#' * level} module {name} {{ #{name} }}\n"
        yield from prose(inspect.getdoc(value) or "")
        for member_name, member in members_of(value):
            yield from shown(f"{name}.{member_name}", member, level + 1)
    elif callable(value):
        yield from shown_function(name, value, level)


def page(folder):
    """Markdown; `folder`: what belongs on PYTHONPATH, or None."""
    if folder is None:
        return NOT_BUILT
    sys.path.insert(0, str(folder))
    module = importlib.import_module("linkwright")
    parts = ["# Python\n", *prose(inspect.getdoc(module) or "")]
    for name in module.__all__:
        if not name.startswith("_"):
            parts += shown(name, getattr(module, name))
    return "\n".join(parts)
