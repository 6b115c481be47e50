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
PROGRAMS = {"Contacts and motion": ["dem_verification"], "Gas": ["gas_verification_test"],
            "Gas and particles": ["bed_verification", "coupling_deposit_test"], "Scaling": ["scaling_verification"]}
# Tables that the tests write, with a title; orders of convergence have logarithmic axes.
PICTURES = {"kharaz": "Oblique impact of alumina on glass", "haff": "Cooling of an inelastic gas", "settling": "Hindered settling",
            "cavity_1000": "Lid-driven cavity, Re 1000, 64 x 64", "taylor_green": "Decaying vortices, errors",
            "manufactured": "Varying gas fraction, errors"}
ORDERS = {"taylor_green", "manufactured"}
SOURCES = """## Where the figures come from

* **MFIX**: worst row of the results that MFIX 21.3.2 ships with its own tests (tests/dem and tests/fluid, AUTOTEST): its distance from its
  reference, by its own columns. DEM05 and the cavity: computed here from those files; the positions of its cavity were taken as cell
  centres, half a cell below what the files say. Its first-bounce reference of DEM02 is the hard sphere's, ours the equation of motion.
* **Kratos**: the largest forces that the DEM application of Kratos Multiphysics stores for Chung & Ooi's first two tests, in whole newtons.
* Measured or read from figures: Kharaz, Gorham & Salman, Powder Technol. 120 (2001) 281; Chung & Ooi, Granular Matter 13 (2011) 643; Ghia,
  Ghia & Shin, J. Comput. Phys. 48 (1982) 387; Richardson & Zaki, Trans. Inst. Chem. Eng. 32 (1954) 35.
* Closed forms: Haff, J. Fluid Mech. 134 (1983) 401; Taylor & Green, Proc. R. Soc. A 158 (1937) 499; the others stand in their tests.
* "-": no figure of another code for this test is known here. It does not say that there is none.
"""


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
    if len(set(errors)) == 1:
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

    figure, axes = plt.subplots(2, 3, figsize=(12, 7.2), constrained_layout=True)
    for axis, (name, title) in zip(axes.flat, PICTURES.items()):
        with open(folder / f"{name}.csv", encoding="utf-8") as file:
            table = list(csv.reader(file))
        x, ours, reference = ([float(row[n]) for row in table[1:]] for n in range(3))
        if name in ORDERS:
            axis.loglog(x, ours, "o-", label=table[0][1])
            if table[0][2] != "second order":
                axis.loglog(x, reference, "s-", label=table[0][2])
            axis.loglog(x, [ours[0] * (x[0] / n) ** 2 for n in x], "k:", label="second order")
            axis.set_xticks(x, [f"{n:.0f}" for n in x])
            axis.minorticks_off()
        elif name in ("haff", "settling"):
            axis.plot(x, reference, "k-", label=table[0][2])
            axis.plot(x, ours, "o", label=table[0][1])
        else:
            axis.plot(x, reference, "ko", markersize=4, label=table[0][2])
            axis.plot(x, ours, "-", label=table[0][1])
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(table[0][0])
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    pictures.mkdir(parents=True, exist_ok=True)
    figure.savefig(pictures / "verification.png", dpi=110)


def told_of_itself(build):
    """Program, compiler and processor."""
    version = subprocess.run([build / "bin" / "similitude", "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0].strip()
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    compiler = next(line.split("=", 1)[1] for line in cache.splitlines() if line.startswith("CMAKE_CXX_COMPILER:"))
    compiler = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        processor = next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    return f"{version}, {compiler}, {processor}"


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def main():
    build = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SOURCE / "build"
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else SOURCE / "docs" / "verification.md"
    lines = ["# Verification", "",
             "What the tests of tests/verification found, row by row. `/usr/bin/python3 docs/verification/make_page.py` runs them (four minutes) and writes "
             f"this page; this one is of {told_of_itself(build.resolve())}. Bounds are in the tests; what stands here was measured. "
             "Runs against measurements of whole beds: [validation](validation.md).", "", "![six of the tests](pictures/verification.png)"]
    others = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for heading, programs in PROGRAMS.items():
            tests = [test for program in programs for test in results_of(program, build.resolve(), folder)]
            rows = list(rows_of(tests))
            lines += ["", f"## {heading}", ""] + table(["feature", "reference", "our error", "other codes' error", "test", ""], rows)
            plain = collections.Counter(name_of(test) for test in tests if "feature" not in test)
            failed = {name_of(test) for test in tests if "failures" in test}
            others += [[f"{name}", str(number), "**failed**" if name in failed else "passed"] for name, number in sorted(plain.items())]
        draw(folder, page.parent / "pictures")
    lines += ["", SOURCES.rstrip(), "", "## Held without a figure", "", "Bounds, orders and equal bits: a test holds or does not.", ""]
    lines += table(["test", "cases", ""], others)
    page.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(page)


if __name__ == "__main__":
    main()
