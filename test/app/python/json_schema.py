# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with a value by a schema, as far as the schemas of this project use JSON Schema."""

from pathlib import Path

SCHEMAS = Path(__file__).resolve().parents[3] / "resources/schemas"
TYPES = {"object": dict, "array": list, "string": str, "number": (int, float), "integer": int, "boolean": bool, "null": type(None)}
# What the schemas use of JSON Schema 2020-12; any other word would not be checked.
WORDS = {"$schema", "$defs", "$ref", "title", "description", "type", "properties", "required", "additionalProperties", "items", "minItems",
         "maxItems", "enum", "anyOf"}


def is_of(value, name):
    return isinstance(value, TYPES[name]) and (name == "boolean" or not isinstance(value, bool))


def faults(value, schema, root, place="$"):
    """What is wrong with a value, a line each."""
    if "$ref" in schema:
        return faults(value, root["$defs"][schema["$ref"].removeprefix("#/$defs/")], root, place)
    if "anyOf" in schema:
        found = [faults(value, each, root, place) for each in schema["anyOf"]]
        return [] if [] in found else min(found, key=len)
    types = schema.get("type", list(TYPES))
    if not any(is_of(value, name) for name in ([types] if isinstance(types, str) else types)):
        return [f"{place} is {value!r}, not {types}"]
    wrong = [] if value in schema.get("enum", [value]) else [f"{place} is {value!r}, not one of {schema['enum']}"]
    if isinstance(value, dict):
        known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
        wrong += [f"{place} lacks {key}" for key in schema.get("required", []) if key not in value]
        for key, each in value.items():
            if key in known:
                wrong += faults(each, known[key], root, f"{place}.{key}")
            elif others is False:
                wrong.append(f"{place}.{key} is not known")
            elif isinstance(others, dict):
                wrong += faults(each, others, root, f"{place}.{key}")
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            wrong.append(f"{place} has {len(value)} items")
        for number, each in enumerate(value):
            wrong += faults(each, schema.get("items", {}), root, f"{place}[{number}]")
    return wrong
