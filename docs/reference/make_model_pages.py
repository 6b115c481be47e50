#!/usr/bin/env python3
"""Makes a page per model from the plugin's README and its own parameter table.

  docs/reference/make_model_pages.py build/bin/similitude            writes docs/reference/models/
  docs/reference/make_model_pages.py build/bin/similitude --check    says which pages are out of date, exit status 1 if any

A README (plugins/<kind>/<id>/README.md) is a heading and paragraphs that open with a bold word; those of SECTIONS must be
there. The table of parameters follows the paragraph **Parameters.**"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ROOT / "docs/reference/models"
KINDS = {"drag": "Drag laws", "contact": "Contact laws", "fluid": "Gas solvers", "scaling": "Scaling laws", "effect": "Effects"}
SECTIONS = ["Equation", "Parameters", "Valid range", "Assumptions", "Example", "Tests", "Related", "Reference"]
FOOT = "<!-- Made by docs/reference/make_model_pages.py from plugins/{kind}/{id}: edit those, not this page. -->\n"


def ask(program, *words):
    return json.loads(subprocess.run([program, "plugins", *words, "--json"], check=True, capture_output=True, text=True).stdout)


def paragraph_start(section):
    return f"**{section}.**"


def quantity(value, unit):
    if isinstance(value, bool):
        return "true" if value else "false"
    text = f"{value:.6g}" if isinstance(value, (int, float)) else str(value)
    return text if unit in ("", "1") else f"{text} {unit}"


def default_of(row):
    if row["required"]:
        return "required"
    return "not given" if row["default"] is None else quantity(row["default"], row["unit"])


def span(low, high):
    if low is None and high is None:
        return ""
    if high is None:
        return f"≥ {low:.6g}"
    if low is None:
        return f"≤ {high:.6g}"
    return f"{low:.6g} … {high:.6g}"


def range_of(row):
    if row["type"] == "flag":
        return "true, false"
    if row["choices"]:
        choices = row["choices"]
        return ", ".join(choices if isinstance(choices, list) else choices.split("|"))
    hard, typical = span(row["minimum"], row["maximum"]), span(row["typical_minimum"], row["typical_maximum"])
    return f"{hard}{'; ' if hard and typical else ''}{'mostly ' + typical if typical else ''}"


def meaning_of(row):
    words = row["doc"]
    if row["scales_as"]:
        words = words.rstrip(".") + f". Scales as a {row['scales_as']}."
    if row["reference"]:
        words += f" ({row['reference']})"
    return words.replace("|", "\\|")


def parameter_table(rows):
    if not rows:
        return "None."
    lines = ["| parameter | unit | default | range | meaning |", "|---|---|---|---|---|"]
    for row in rows:
        unit = row["unit"] if row["type"] in ("real", "integer") else ""
        lines.append(f"| `{row['name']}` | {unit} | {default_of(row)} | {range_of(row)} | {meaning_of(row)} |")
    return "\n".join(lines) + "\n"


def page_of(plugin):
    folder = ROOT / "plugins" / plugin["kind"] / plugin["id"]
    readme = (folder / "README.md").read_text()
    missing = [s for s in SECTIONS if f"\n{paragraph_start(s)}" not in readme]
    if missing:
        raise SystemExit(f"{folder.relative_to(ROOT)}/README.md has no paragraph {', '.join(map(paragraph_start, missing))}.")
    body = readme.split("\n", 1)[1].strip("\n")
    paragraphs = body.split("\n\n")
    place = next(i for i, p in enumerate(paragraphs) if p.startswith(paragraph_start("Parameters")))
    table = parameter_table(plugin["parameters"])
    if plugin["parameters"]:
        paragraphs.insert(place + 1, table.rstrip("\n"))
    elif paragraphs[place] == paragraph_start("Parameters"):
        paragraphs[place] += " " + table
    head = f"# {plugin['id']}\n\n*{KINDS[plugin['kind']]}. {plugin['title']}. Version {plugin['version']}.*\n\n"
    return head + "\n\n".join(paragraphs) + "\n\n" + FOOT.format(**plugin)


def index_of(plugins):
    lines = ["# Models", "", "A page per plugin that ships. Which one when: [choosing](../choosing.md).", ""]
    for kind, title in KINDS.items():
        rows = [p for p in plugins if p["kind"] == kind]
        if rows:
            lines += [f"## {title}", "", "| id | |", "|---|---|"]
            lines += [f"| [{p['id']}]({kind}_{p['id']}.md) | {p['title']} |" for p in rows] + [""]
    return "\n".join(lines) + "\n" + "<!-- Made by docs/reference/make_model_pages.py. -->\n"


def pages(program):
    listed = [p for p in ask(program, "list")["plugins"] if (ROOT / "plugins" / p["kind"] / p["id"]).is_dir()]
    made = {}
    for entry in listed:
        infos = ask(program, "info", entry["id"])["plugins"]
        plugin = next(p for p in infos if p["kind"] == entry["kind"])
        made[f"{plugin['kind']}_{plugin['id']}.md"] = page_of(plugin)
    made["README.md"] = index_of(listed)
    return made


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("similitude", help="the program, with the shipped plugins beside it")
    words.add_argument("--check", action="store_true", help="write nothing")
    given = words.parse_args()
    made = pages(given.similitude)
    there = {p.name: p.read_text() for p in PAGES.glob("*.md")}
    stale = sorted(name for name in made.keys() | there.keys() if made.get(name) != there.get(name))
    if given.check:
        for name in stale:
            print(f"docs/reference/models/{name} is out of date. Run docs/reference/make_model_pages.py build/bin/similitude.")
        return 1 if stale else 0
    PAGES.mkdir(exist_ok=True)
    for name in stale:
        if name in made:
            (PAGES / name).write_text(made[name])
        else:
            (PAGES / name).unlink()
    print(f"{len(made)} pages, {len(stale)} of them new or changed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
