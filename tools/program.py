"""Runs of the program whose reports scripts read."""
import json
import os
import subprocess
import sys


class Program:
    def __init__(self, surpass, folder):
        self.surpass, self.folder = surpass, folder

    def run(self, *words, allowed=(0,)):
        """The report, with "processor" in it: user and system seconds. Other exit codes than the allowed end it all."""
        report = self.folder / "report.json"
        said = self.folder / "said.txt"
        with said.open("w") as stream:
            child = subprocess.Popen([self.surpass, *map(str, words), "--report", report, "--quiet"],
                                     stdout=subprocess.DEVNULL, stderr=stream)
            _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode not in allowed:
            sys.exit(f"surpass {words[0]}: {said.read_text()}")
        # Processor seconds: the clock's tell as much of what else the machine does.
        return {**json.loads(report.read_text()), "processor": usage.ru_utime + usage.ru_stime}

    def timed(self, *words, runs=3):
        """The last report, and the least processor seconds of some runs on one thread."""
        reports = [self.run(*words, "--threads", "1") for _ in range(runs)]
        return reports[-1], min(r["processor"] for r in reports)
