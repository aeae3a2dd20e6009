"""JSON schemas as pages that people read: each definition a section, each object a table of its members."""

import json


def code(value):
    return f"`{json.dumps(value, ensure_ascii=False)}`"


def link(reference):
    """To a definition of this file ("#/$defs/pose") or of another ("problem.schema.json#/$defs/pose"), or to a whole file."""
    file, _, place = reference.partition("#")
    page = file.replace(".schema.json", ".md")
    name = place.rsplit("/", 1)[-1]
    return f"[{name or page.removesuffix('.md')}]({page}{'#' + name if name else ''})"


def numbers_of(schema):
    """ " ≥ 0", " 1 … 5": the range of a number, or the count of a list's items."""
    bounds = {key: schema[key] for key in ("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum") if key in schema}
    signs = {"minimum": "≥", "maximum": "≤", "exclusiveMinimum": ">", "exclusiveMaximum": "<"}
    return "".join(f", {signs[key]} {value}" for key, value in bounds.items())


def count_of(schema):
    least, most = schema.get("minItems"), schema.get("maxItems")
    if least is None and most is None:
        return ""
    return f"{least} " if least == most else f"{least or 0} to {most} " if most is not None else f"{least} or more "


def choices_of(schemas):
    return " or ".join(dict.fromkeys(filter(None, map(type_of, schemas))))


def type_of(schema):
    """One phrase: what a value is."""
    if not isinstance(schema, dict):
        return "anything" if schema else ""
    if "$ref" in schema:
        return link(schema["$ref"])
    if "const" in schema:
        return code(schema["const"])
    if "enum" in schema:
        return ", ".join(map(code, schema["enum"]))
    for key in ("oneOf", "anyOf"):
        if key in schema:
            return choices_of(schema[key])
    kind = schema.get("type")
    if isinstance(kind, list):
        return " or ".join(type_of({**schema, "type": one}) for one in kind)
    if kind == "array":
        if "prefixItems" in schema:
            return f"[{', '.join(map(type_of, schema['prefixItems']))}]"
        return f"list of {count_of(schema)}{type_of(schema.get('items', True))}"
    if kind is None and "allOf" in schema:
        return " and ".join(filter(None, map(type_of, schema["allOf"])))
    return f"{kind or ''}{numbers_of(schema) if kind in ('number', 'integer') else ''}"


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def objects_in(schema, step=""):
    """The objects that a member may be, and the way to their members: "." or, of those of a list, "[]."."""
    if "properties" in schema:
        yield schema, step + "."
    if isinstance(schema.get("items"), dict):
        yield from objects_in(schema["items"], step + "[]")
    for variant in (*schema.get("oneOf", ()), *schema.get("anyOf", ())):
        yield from objects_in(variant, step)


def members(schema, within=""):
    """Rows of a table: the members of an object, and theirs where they have no name of their own."""
    for name, member in schema.get("properties", {}).items():
        if not isinstance(member, dict):
            continue
        place = f"{within}{name}"
        words = member.get("description", "")
        if "default" in member:
            words += f" Default: {code(member['default'])}."
        needed = "required" if name in schema.get("required", ()) else ""
        yield f"| `{place}` | {cell(type_of(member))} | {needed} | {cell(words)} |"
        for inner, step in objects_in(member):
            yield from members(inner, place + step)


def section(schema):
    if schema.get("description"):
        yield schema["description"] + "\n"
    rows = list(members(schema))
    if rows:
        yield "\n".join(["| Member | Value | | Meaning |", "|---|---|---|---|", *rows]) + "\n"
    elif type_of(schema) not in ("object", ""):
        yield f"{type_of(schema)}\n"
    for key, words in (("oneOf", "One of:"), ("anyOf", "Any of:")):
        variants = [variant for variant in schema.get(key, ()) if "properties" in variant]
        for number, variant in enumerate(variants, start=1):
            yield f"{words} {number}.\n" if len(variants) > 1 else ""
            yield from section(variant)


def page(path):
    """The schema at `path` as Markdown."""
    schema = json.loads(path.read_text(encoding="utf-8"))
    parts = [f"# {schema['title']}\n", f"The schema itself: [{path.name}]({path.name}) (JSON Schema 2020-12).\n", *section(schema)]
    for name, definition in schema.get("$defs", {}).items():
        parts += [f"## {name} {{ #{name} }}\n", *section(definition)]
    return "\n".join(parts)
