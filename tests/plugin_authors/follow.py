#!/usr/bin/env python3
"""Follows tutorials to the letter, those for plugin authors and that of a bed: follow.py [--paraview] PAGE.md…

Of each page, in its order and in one shell that begins in the current folder:
  ```sh            is typed; with `sh paraview` only under --paraview, as it needs ParaView itself
  ```LANGUAGE FILE is written to FILE
  ```text          must be in what the last typed block printed; line breaks and indents count as one space
The current folder should be empty. What fails ends everything, with the page, the line and the output.
"""
import os
import pathlib
import re
import subprocess
import sys


def blocks(page):
    """Line, information string and text of every fenced block."""
    inside, info, begin, lines = False, "", 0, []
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.startswith("```") and not inside:
            inside, info, begin, lines = True, line[3:].split(), number, []
        elif line.startswith("```"):
            inside = False
            yield begin, info, "\n".join(lines) + "\n"
        elif inside:
            lines.append(line)


class Shell:
    """One shell per block, which goes on where the last one was: folder and exported variables."""

    def __init__(self):
        self.folder, self.environment, self.output = pathlib.Path.cwd(), dict(os.environ), ""

    def type(self, commands):
        kept = self.folder / ".shell"
        script = f"set -euo pipefail\n{commands}\npwd >{kept}\nenv -0 >>{kept}\n"
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.output = done.stdout
        if done.returncode != 0:
            return f"ends with status {done.returncode}"
        folder, environment = kept.read_text().split("\n", 1)
        kept.unlink()
        self.folder = pathlib.Path(folder)
        self.environment = dict(entry.split("=", 1) for entry in environment.split("\0") if "=" in entry)
        return ""


def as_one_line(text):
    return re.sub(r"\s+", " ", text).strip()


def follow(page, with_paraview):
    shell, typed = Shell(), 0
    for line, info, text in blocks(page):
        fault = ""
        if info[:1] == ["sh"]:
            if "paraview" not in info or with_paraview:
                fault = shell.type(text)
                typed += 1
        elif info == ["text"]:
            if as_one_line(text) not in as_one_line(shell.output):
                fault = f"\"{as_one_line(text)}\" is not what was printed"
        elif len(info) == 2:
            (shell.folder / info[1]).write_text(text)
        else:
            fault = "a block is neither `sh`, `text` nor a language and a file"
        if fault:
            sys.exit(f"{page}:{line}: {fault}:\n{text}\n---\n{shell.output}")
    print(f"{page.name}: {typed} blocks typed", flush=True)


arguments = sys.argv[1:]
for name in arguments:
    if name != "--paraview":
        follow(pathlib.Path(name).resolve(), "--paraview" in arguments)
