"""Writes docs/validation.md and its pictures from whichever runs have been made so far.

    docs/validation/run_all.py [RESULTS]                          makes the runs
    /usr/bin/python3 docs/validation/make_page.py [RESULTS [PAGE]]    default: results/validation, docs/validation.md
"""
import pathlib
import sys

import spouted_bed
import yue2020

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent


def main():
    results = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE / "results" / "validation"
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else SOURCE / "docs" / "validation.md"
    pictures = page.parent / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    lines = ["# Validation", "",
             "Runs against measurements, and scaled beds against the bed that they stand for. Written by `/usr/bin/python3 "
             "docs/validation/make_page.py` from the runs that `docs/validation/run_all.py` makes, as many as there are: each table says what was "
             "run, how far and on what. Comparisons with closed forms and other codes: [verification](verification.md)."]
    for bed in (yue2020, spouted_bed):
        lines += [""] + bed.section(results, pictures)
    page.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(page)


if __name__ == "__main__":
    main()
