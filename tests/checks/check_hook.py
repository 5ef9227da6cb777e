# SPDX-License-Identifier: MIT
"""The pre-commit hook in a repository of its own: what it lets pass, what it holds back."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOOD = "// SPDX-License-Identifier: MIT\nint one()\n{\n    return 1;\n}\n"
LICENSED = "# SPDX-License-Identifier: MIT\n"


class Hook(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        # Nothing of the one who commits: neither settings nor the repository that this may run in.
        self.environment = {key: value for key, value in os.environ.items()
                            if not key.startswith("GIT_")}
        self.environment |= {"HOME": str(self.folder), "GIT_CONFIG_NOSYSTEM": "1"}
        self.git("init", "-q")
        self.git("config", "user.name", "Somebody")
        self.git("config", "user.email", "somebody@example.org")
        for name in (".githooks/pre-commit", ".clang-format", "dev"):
            target = self.folder / name
            target.parent.mkdir(exist_ok=True)
            shutil.copy2(ROOT / name, target)
        self.dev("hook")

    def run_there(self, *command):
        return subprocess.run(command, cwd=self.folder, env=self.environment, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL, check=False)

    def git(self, *arguments):
        return self.run_there("git", *arguments)

    def dev(self, *arguments):
        return self.run_there("./dev", *arguments)

    def commit(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content, encoding="utf-8")
        self.git("add", name)
        return self.git("commit", "-q", "-m", "Try")

    def assert_held_back(self, name, content, why):
        done = self.commit(name, content)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(why, done.stdout + done.stderr)

    def test_what_is_as_it_should_be_passes(self):
        done = self.commit("model/one.cpp", GOOD)
        self.assertEqual(done.returncode, 0, done.stderr)

    @unittest.skipUnless(shutil.which("clang-format-14"), "no clang-format-14")
    def test_another_format_is_held_back(self):
        self.assert_held_back("one.cpp", GOOD.replace("    return", "  return"), "clang-format-14")

    def test_a_file_without_licence_is_held_back(self):
        self.assert_held_back("one.py", '"""One."""\n', "SPDX")

    def test_spaces_at_the_end_are_held_back(self):
        self.assert_held_back("one.cmake", "set(ONE 1)  \n", "trailing whitespace")

    def test_a_conflict_is_held_back(self):
        self.assert_held_back("one.txt", "<<<<<<< ours\n1\n=======\n2\n>>>>>>> theirs\n",
                              "conflict marker")

    def test_recordings_are_left_alone(self):
        self.assertEqual(self.commit("tests/golden/one.txt", "1  \n").returncode, 0)

    def test_a_long_file_passes(self):
        self.assertEqual(self.commit("one.py", LICENSED + "two = 2\n" * 50_000).returncode, 0)

    def test_what_is_staged_counts(self):
        path = self.folder / "one.cpp"
        path.write_text(GOOD, encoding="utf-8")
        self.git("add", "one.cpp")
        path.write_text("int  two ;", encoding="utf-8")
        self.assertEqual(self.git("commit", "-q", "-m", "Try").returncode, 0)

    def test_it_can_be_passed_by(self):
        self.folder.joinpath("one.py").write_text("1\n", encoding="utf-8")
        self.git("add", "one.py")
        self.assertEqual(self.git("commit", "-q", "--no-verify", "-m", "Try").returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
