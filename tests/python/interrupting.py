# SPDX-License-Identifier: MIT
"""Ctrl+C in the middle of a call."""
import signal
import time


class Interrupting:
    """For test cases: calls that are to end when a signal comes."""

    def interrupted(self, call, after=0.3):
        """Seconds from the signal to the end."""
        def stop(*_):
            self.stopped = time.monotonic()
            raise KeyboardInterrupt

        old = signal.signal(signal.SIGALRM, stop)
        signal.setitimer(signal.ITIMER_REAL, after)
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
            return time.monotonic() - self.stopped
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, old)
