"""Validates cases against a JSON Schema: validate_cases.py SCHEMA CASE...

Prints "valid NAME" or "invalid NAME" for each case, then exits with 0.
"""
import json
import sys

import jsonschema
import yaml

with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for path in sys.argv[2:]:
    with open(path, encoding="utf-8") as file:
        case = yaml.safe_load(file)
    print("valid" if validator.is_valid(case) else "invalid", path)
