# SPDX-License-Identifier: MIT
"""What the editor's console does with what is typed. Runs on the interpreter's own thread."""
import builtins
import codeop
import os
import rlcompleter
import runpy
import signal
import sys
import traceback

import crowdbrush


_MOST = 100_000  # characters that are shown of what is printed at once


class _Stream:
    """sys.stdout or sys.stderr in the panel."""

    encoding = "utf-8"
    errors = "replace"
    closed = False

    def __init__(self, write):
        self._write = write

    def write(self, text):
        if not isinstance(text, str):
            raise TypeError(f"write() argument must be str, not {type(text).__name__}")
        shown = text
        if len(text) > _MOST:
            shown = f"… {len(text) - _MOST} characters are left out …\n" + text[-_MOST:]
        self._write(shown.encode("utf-8", "replace"))
        return len(text)

    def writelines(self, lines):
        for line in lines:
            self.write(line)

    def flush(self):
        pass

    def isatty(self):
        return False

    def writable(self):
        return True

    def readable(self):
        return False


class _NoInput:
    """sys.stdin: nobody types into a running script."""

    encoding = "utf-8"

    def readline(self, *_):
        raise EOFError("The console cannot ask for input: give the script what it needs as values.")

    read = readline

    def fileno(self):
        raise OSError("The console has no input.")


def _stop(*_):
    raise KeyboardInterrupt


class Console:
    def __init__(self, write, write_error, scene, tell_of_brush):
        self._scene = scene
        self._problem = ""
        crowdbrush._tell_editor = tell_of_brush
        self._names = {"__name__": "__main__", "__builtins__": builtins, "crowdbrush": crowdbrush}
        sys.stdout, sys.stderr, sys.stdin = _Stream(write), _Stream(write_error), _NoInput()
        sys.argv = [""]
        signal.signal(signal.SIGUSR1, _stop)

    def run(self, source):
        """Runs typed lines: "done", "more" when they are not complete yet, or "failed"."""
        self._names["scene"] = self._scene
        mode = "single"
        try:
            code = codeop.compile_command(source, "<console>", mode)
        except (SyntaxError, ValueError, OverflowError):
            try:  # several statements, pasted
                code = compile(source, "<console>", "exec")
            except (SyntaxError, ValueError, OverflowError):
                traceback.print_exc(limit=0)
                return "failed"
        if code is None:
            return "more"
        return self._guarded(lambda: exec(code, self._names))

    def run_file(self, path):
        """Runs a file as __main__, with `scene` and `crowdbrush` there already."""
        names = {"scene": self._scene, "crowdbrush": crowdbrush}
        folder = os.path.dirname(path)
        sys.path.insert(0, folder)
        sys.argv = [path]
        try:
            return self._guarded(lambda: runpy.run_path(path, names, "__main__"))
        finally:
            if folder in sys.path:
                sys.path.remove(folder)

    def paint(self, name, values, paint_with):
        """A stroke of a script brush, dab by dab: "done", or "failed:" and why."""
        result = self._guarded(
            lambda: paint_with(crowdbrush._brush_with(crowdbrush.brushes[name], values)))
        return result if result == "done" else "failed:" + self._problem

    def complete(self, text):
        """What `text` may go on to: names and attributes."""
        self._names["scene"] = self._scene
        completer = rlcompleter.Completer(self._names)
        found = []
        try:
            while len(found) < 200:
                match = completer.complete(text, len(found))
                if match is None:
                    break
                found.append(match)
        except Exception:  # a property that raises has no completions
            pass
        return sorted({match.rstrip("(") for match in found if not match.startswith("_")})

    def _guarded(self, action):
        self._problem = ""
        try:
            action()
            return "done"
        except KeyboardInterrupt:
            sys.stderr.write("Cancelled.\n")
        except SystemExit as end:
            if end.code in (None, 0):
                return "done"
            sys.stderr.write(f"The script ended with: {end.code}\n")
        except BaseException as problem:
            self._problem = "".join(traceback.format_exception_only(problem)).strip()
            self._explain(problem)
        return "failed"

    def _explain(self, problem):
        """The traceback without our own part and Python's machinery for running files."""
        ours = (__file__, runpy.__file__, "<frozen runpy>", "<string>")
        tb = problem.__traceback__
        while tb is not None and tb.tb_frame.f_code.co_filename in ours:
            tb = tb.tb_next
        traceback.print_exception(type(problem), problem, tb)
