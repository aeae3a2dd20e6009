"""The public headers as pages, from Doxygen's XML: a page to each folder, a section to each header."""

import re
import xml.etree.ElementTree as ElementTree
from collections import defaultdict

TYPES = ("class", "struct", "concept", "union")


def anchor_of(header):
    return header.replace(".", "-")


def flat(element):
    """All text of an element, as it stands in the source."""
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def prose(element):
    """Markdown of a description: paragraphs, code, lists, quotations."""
    if element is None:
        return ""
    if element.tag == "itemizedlist":
        return "\n".join(f"- {prose(item).strip()}" for item in element) + "\n"
    if element.tag == "verbatim":
        return "\n\n```text\n" + (element.text or "").strip("\n") + "\n```\n\n"
    words = escaped(element.text or "")
    for child in element:
        words += prose(child) + escaped(child.tail or "")
    if element.tag == "computeroutput":
        return f"`{flat(element)}`"
    if element.tag == "blockquote":
        return "".join(f"> {line}\n" for line in words.strip().splitlines())
    return words + "\n\n" if element.tag == "para" else words


def escaped(text):
    return re.sub(r"([\\`*_<>|\[\]])", r"\\\1", text)


def description(definition):
    parts = (prose(definition.find(f"{kind}description")).strip() for kind in ("brief", "detailed"))
    return "\n\n".join(part for part in parts if part)


def declaration(member):
    """As it would be written: return type, name, arguments, default."""
    kind, name = member.get("kind"), flat(member.find("name"))
    if kind == "enum":
        values = ", ".join(flat(value.find("name")) for value in member.findall("enumvalue"))
        return f"enum class {name} {{ {values} }}"
    if kind == "typedef":
        return f"using {name} = {flat(member.find('type'))}"
    template = member.find("templateparamlist")
    before = f"template <{', '.join(flat(one) for one in template)}> " if template is not None else ""
    initial = flat(member.find("initializer"))
    return f"{before}{flat(member.find('type'))} {name}{flat(member.find('argsstring'))} {initial}".strip()


def members_of(compound):
    """Public members and what stands free in a header, in the order of the source."""
    for section in compound.findall("sectiondef"):
        if not section.get("kind").startswith("private"):
            for member in section.findall("memberdef"):
                if member.get("prot") != "private" and member.get("kind") != "friend":
                    yield member


def line_of(definition):
    return int(definition.find("location").get("line"))


def shown_member(member):
    yield f"```cpp\n{declaration(member)}\n```\n"
    words = description(member)
    if words:
        yield words + "\n"
    for value in member.findall("enumvalue"):
        meaning = description(value)
        if meaning:
            yield f"- `{flat(value.find('name'))}`: {meaning}"
    yield ""


def fields_and_functions(members):
    """Fields as a table, since they are many and short; all else one by one."""
    fields = [member for member in members if member.get("kind") == "variable"]
    if fields:
        yield "| Field | | Meaning |\n|---|---|---|"
        for field in fields:
            initial = flat(field.find("initializer"))
            kind = flat(field.find("type")) + (f" {initial}" if initial else "")
            meaning = " ".join(description(field).split())
            yield f"| `{flat(field.find('name'))}` | `{kind.replace('|', chr(92) + '|')}` | {meaning} |"
        yield ""
    for member in members:
        if member.get("kind") != "variable":
            yield from shown_member(member)


def shown_type(compound):
    name = flat(compound.find("compoundname")).removeprefix("linkwright::")
    yield f"### {compound.get('kind')} {escaped(name)}\n"
    bases = ", ".join(f"`{flat(base)}`" for base in compound.findall("basecompoundref"))
    if bases:
        yield f"Derived from {bases}.\n"
    yield description(compound) + "\n"
    yield from fields_and_functions(list(members_of(compound)))


def shown_header(header, types, free):
    yield f"## {header} {{ #{anchor_of(header)} }}\n"
    parts = [(line_of(one), shown_type(one)) for one in types] + [(line_of(one), shown_member(one)) for one in free]
    for _, lines in sorted(parts, key=lambda part: part[0]):
        yield from lines


def header_of(definition):
    return definition.find("location").get("file").removeprefix("linkwright/")


def pages(xml):
    """Markdown by folder of include/linkwright, from the folder of Doxygen's XML."""
    headers, types, free = set(), defaultdict(list), defaultdict(list)
    for path in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            kind = compound.get("kind")
            if kind == "file":
                headers.add(header_of(compound))
            if kind in TYPES and compound.get("prot") != "private":
                types[header_of(compound)].append(compound)
            if kind in ("file", "namespace"):
                for member in members_of(compound):
                    free[header_of(member)].append(member)
    made = defaultdict(list)
    for place in sorted(headers):
        folder, _, header = place.rpartition("/")
        made[folder] += shown_header(header, types[place], free[place])
    return {folder: f"# {folder}\n\nHeaders of `linkwright/{folder}/`, namespace `linkwright`.\n\n" + "\n".join(lines)
            for folder, lines in made.items()}
