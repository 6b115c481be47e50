#!/usr/bin/env python3
"""The tutorial of a bed is followed to the letter: every command typed, every file written, every output compared."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["SIMILITUDE"])
SOURCE = pathlib.Path(os.environ["SIMILITUDE_SOURCE"])


class Tutorial(unittest.TestCase):
    def test_my_spouted_bed(self):
        environment = os.environ | {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        with tempfile.TemporaryDirectory() as empty:
            followed = subprocess.run([sys.executable, SOURCE / "tests/plugin_authors/follow.py", SOURCE / "docs/tutorials/my_spouted_bed.md"],
                                      cwd=empty, env=environment, capture_output=True, text=True)
        self.assertEqual(followed.returncode, 0, followed.stdout + followed.stderr)


if __name__ == "__main__":
    unittest.main()
