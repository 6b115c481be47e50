"""Runs the verification tests and writes docs/verification.md with its pictures from what they report.

    /usr/bin/python3 docs/verification/make_page.py [BUILD [PAGE]]
"""
import collections
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAMS = {"Contacts and motion": "dem_verification", "Gas": "gas_verification_test", "Gas and particles": "bed_verification",
            "Scaling": "scaling_verification"}
PICTURES = {"haff": ("Cooling of an inelastic gas", False), "settling": ("Hindered settling", False),
            "manufactured": ("Errors of a manufactured flow", True)}


def results_of(program, build, folder):
    """GoogleTest's own account of a program, and the rows of its figures in `folder`."""
    report = folder / f"{program}.json"
    subprocess.run([build / "tests" / program, f"--gtest_output=json:{report}"], stdout=subprocess.DEVNULL, check=False,
                   env={**os.environ, "SIMILITUDE_CURVES": str(folder), "OMP_NUM_THREADS": "1"})
    tests = []
    for suite in json.loads(report.read_text(encoding="utf-8"))["testsuites"]:
        tests += suite["testsuite"]
    return tests


def name_of(test):
    suite = test["classname"].split("/")[-1]
    return f"{suite}.{test['name'].split('/')[0]}"


def rows_of(tests):
    """A row per test with a record; those that differ by a parameter share one where they verify the same."""
    rows = collections.OrderedDict()
    for test in tests:
        if "feature" not in test:
            continue
        key = (name_of(test), test["feature"], test["reference"], test.get("others", ""))
        rows.setdefault(key, []).append((test["ours"], "failures" not in test))
    for (name, feature, reference, others), seen in rows.items():
        yield [feature, reference, errors_in_words([ours for ours, _ in seen]), others or "-", name,
               "passed" if all(passed for _, passed in seen) else "**failed**"]


def errors_in_words(errors):
    if len(errors) == 1:
        return errors[0]
    try:
        numbers = [float(error.split()[0]) for error in errors]
    except ValueError:
        return "; ".join(errors)
    return f"at most {max(numbers):g} {errors[0].split(None, 1)[1]} ({len(errors)} cases)"


def draw(folder, pictures):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, len(PICTURES), figsize=(12, 3.8), constrained_layout=True)
    for axis, (name, (title, logarithmic)) in zip(axes, PICTURES.items()):
        with open(folder / f"{name}.csv", encoding="utf-8") as file:
            table = list(csv.reader(file))
        x, ours, reference = ([float(row[n]) for row in table[1:]] for n in range(3))
        if logarithmic:
            axis.loglog(x, ours, "o-", label=table[0][1])
            axis.loglog(x, reference, "s-", label=table[0][2])
            axis.loglog(x, [ours[0] * (x[0] / n) ** 2 for n in x], "k:", label="second order")
        else:
            axis.plot(x, reference, "k-", label=table[0][2])
            axis.plot(x, ours, "o", label=table[0][1])
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(table[0][0])
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    pictures.mkdir(parents=True, exist_ok=True)
    figure.savefig(pictures / "verification.png", dpi=110)


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def main():
    build = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE / "build"
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else SOURCE / "docs" / "verification.md"
    lines = ["# Verification", "", "Written by `/usr/bin/python3 docs/verification/make_page.py` from the results of the tests of "
             "tests/verification, which it runs. Errors are the tests' own measurements on the machine that wrote this page; what other "
             "codes reach is their authors' figure for the same test, where there is one.", "", "![three of the tests](pictures/verification.png)"]
    others = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for heading, program in PROGRAMS.items():
            tests = results_of(program, build.resolve(), folder)
            rows = list(rows_of(tests))
            if rows:
                lines += ["", f"## {heading}", ""] + table(["verified", "against", "our error", "other codes", "test", ""], rows)
            plain = collections.Counter(name_of(test) for test in tests if "feature" not in test)
            failed = {name_of(test) for test in tests if "failures" in test}
            others += [[f"{name}", str(number), "**failed**" if name in failed else "passed"] for name, number in sorted(plain.items())]
        draw(folder, page.parent / "pictures")
    lines += ["", "## Held without a figure", "", "Identities, bounds and equal bits: a test holds or does not.", ""]
    lines += table(["test", "cases", ""], others)
    page.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(page)


if __name__ == "__main__":
    main()
