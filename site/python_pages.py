"""The Python interface as a page, from the docstrings of the module as it was built."""

import importlib
import inspect
import sys

NOT_BUILT = "# Python\n\nThe Python module was not built when this site was made.\n"


def folder_of_module(build):
    """What belongs on PYTHONPATH; None where the module is not built."""
    for library in sorted(build.glob("*/**/_linkwright*.so")):
        return library.parent.parent if library.parent.name == "linkwright" else library.parent
    return None


def signature_of(name, value):
    """Of a compiled function its docstring's first line has it."""
    try:
        return f"{name}{inspect.signature(value)}"
    except (TypeError, ValueError):
        first = (inspect.getdoc(value) or "").partition("\n")[0]
        return first if first.startswith(f"{name.rpartition('.')[2]}(") else f"{name}(…)"


def words_of(value, signature):
    """Its docstring without the line that is shown as its signature."""
    words = inspect.getdoc(value) or ""
    return words.removeprefix(signature).strip()


def is_property(value):
    return isinstance(value, property) or inspect.isdatadescriptor(value)


def members_of(value):
    """Public members of a class with a docstring of their own, in the order of the source where there is one."""
    for name, member in vars(value).items():
        if not name.startswith("_") and (callable(member) or is_property(member) or isinstance(member, (classmethod, staticmethod))):
            yield name, member


def shown_function(name, value, level):
    signature = signature_of(name, value)
    yield f"{'#' * level} {name} {{ #{name} }}\n"
    yield f"```text\n{signature}\n```\n"
    yield indented(words_of(value, signature))


def shown_class(name, value):
    yield f"## class {name} {{ #{name} }}\n"
    yield indented(inspect.getdoc(value) or "")
    for member_name, member in members_of(value):
        if is_property(member):
            yield f"### {name}.{member_name} {{ #{name}.{member_name} }}\n"
            yield indented(inspect.getdoc(member) or "")
        else:
            yield from shown_function(f"{name}.{member_name}", getattr(value, member_name), 3)


def indented(words):
    """Docstrings are laid out by hand: shown as they are written."""
    return f"```text\n{words}\n```\n" if words else ""


def page(folder):
    """Markdown; `folder`: what belongs on PYTHONPATH, or None."""
    if folder is None:
        return NOT_BUILT
    sys.path.insert(0, str(folder))
    module = importlib.import_module("linkwright")
    names = getattr(module, "__all__", None) or [name for name in vars(module) if not name.startswith("_")]
    parts = ["# Python\n", indented(inspect.getdoc(module) or "")]
    for name in names:
        value = getattr(module, name)
        if inspect.isclass(value):
            parts += shown_class(name, value)
        elif callable(value):
            parts += shown_function(name, value, 2)
    return "\n".join(parts)
