"""Two laws built by GCC and by Clang, at -O0 and at -O3, with and without _GLIBCXX_DEBUG, all loaded into one program: their
forces agree to 1e-12."""

import itertools
import os
import subprocess
import tempfile
import unittest

SOURCE, LIBRARY = os.environ["SOURCE"], os.environ["LIBRARY"]
COMPILERS = {"gcc": os.environ["GCC"], "clang": os.environ["CLANG"]}
INCLUDE = ["-std=c++20", f"-I{SOURCE}/framework/sdk/include", f"-I{SOURCE}/framework"]
PLUGIN = ["-shared", "-fPIC", "-fvisibility=hidden", "-march=native", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast"]
TOLERANCE = 1e-12   # relative; the compilers contract sums and products differently

# A drag law of two powers, and a contact law with memory, spin and roots.
LAWS = ["drag/beetstra", "contact/hertz_mindlin"]


class Compilers(unittest.TestCase):
    def test_agree_on_forces(self):
        with tempfile.TemporaryDirectory() as folder:
            program = f"{folder}/ask"
            subprocess.run([COMPILERS["gcc"], "-O1", *INCLUDE, f"{SOURCE}/tests/compilers/ask.cpp", f"-L{LIBRARY}", "-lsimilitude",
                            f"-Wl,-rpath,{LIBRARY}", "-o", program], check=True)
            for law in LAWS:
                files = []
                for name, level, debug in itertools.product(COMPILERS, ("-O0", "-O3"), ((), ("-D_GLIBCXX_DEBUG",))):
                    file = f"{folder}/{law.replace('/', '_')}_{name}{level}{'_debug' if debug else ''}.so"
                    gnu = ["-fno-gnu-unique"] if name == "gcc" else []
                    subprocess.run([COMPILERS[name], level, *debug, *gnu, *PLUGIN, *INCLUDE, f"{SOURCE}/plugins/{law}/{law.split('/')[1]}.cpp",
                                    "-o", file], check=True)
                    files.append(file)
                answer = subprocess.run([program, *files], capture_output=True, text=True)
                self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
                lines = answer.stdout.splitlines()
                self.assertEqual(len(lines), len(files))
                self.assertIn(" clang ", answer.stdout)
                self.assertIn(" gcc ", answer.stdout)
                for line in lines:
                    self.assertLessEqual(float(line.split()[0]), TOLERANCE, answer.stdout)
                print(answer.stdout, end="")


if __name__ == "__main__":
    unittest.main()
