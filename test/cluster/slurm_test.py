#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A study gives the same bytes whatever happens to the processes that run it."""

import random
import resource
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import slurm

CLI = str(Path(sys.argv.pop(1)).resolve() / "perilymph-cli")
SHARDS = 4
STUDY = """title = "Faults"
scenario = "mean-flex28"
depth = "scenario"
samples = {samples}
[cochleae]
virtual = 2
[vary]
nodes = [20]
dt_ms = [10.0]
stop_travel_mm = [2.0]
[ranges]
speed_mm_s = [0.5, 1.0]
[results]
contacts = true
"""


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.home.name)
        cls.study = cls.folder / "study.toml"
        cls.study.write_text(STUDY.format(samples=160))
        cls.cli("study", "run", cls.study, "--jobs", "1", "--out", cls.folder / "whole")

    @classmethod
    def tearDownClass(cls):
        cls.home.cleanup()

    @classmethod
    def cli(cls, *words, check=True, **options):
        done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, timeout=300,
                              check=False, **options)
        if check and done.returncode != 0:
            raise AssertionError(f"{words}: {done.stderr}")
        return done

    def expect_the_same(self, folder):
        for name in ("study.sqlite", "insertions.csv"):
            self.assertEqual((folder / name).read_bytes(), (self.folder / "whole" / name).read_bytes(), name)

    def test_processes_that_are_killed_at_random_moments(self):
        out = self.folder / "killed"
        moments = random.Random(7)
        words = [CLI, "study", "shard", str(self.study), "--index", "1", "--of", "1", "--jobs", "1",
                 "--out", str(out)]
        for _ in range(20):
            with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
                try:
                    process.wait(moments.uniform(0.02, 1.0))
                except subprocess.TimeoutExpired:
                    process.kill()
        self.cli(*words[1:])
        self.cli("study", "merge", out)
        self.expect_the_same(out)
        self.assertEqual(sorted(file.name for file in out.iterdir()),
                         ["insertions.csv", "shard-1-of-1.sqlite", "study.sqlite"], "nothing is left behind")

    def test_a_disk_that_is_full(self):
        out = self.folder / "full"
        limit = 60_000  # bytes of a file: some blocks of results

        def with_limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        words = ("study", "shard", self.study, "--index", 1, "--of", 1, "--jobs", 1, "--out", out)
        refused = self.cli(*words, check=False, preexec_fn=with_limit)
        self.assertEqual(refused.returncode, 1, refused.stderr)
        self.assertIn("takes no more results", refused.stderr)
        self.cli(*words)
        self.cli("study", "merge", out)
        self.expect_the_same(out)

    def test_parts_started_by_xargs(self):
        out = self.folder / "xargs"
        subprocess.run(f"seq {SHARDS} | xargs -P 2 -I {{}} '{CLI}' study shard '{self.study}' --index {{}} "
                       f"--of {SHARDS} --jobs 1 --out '{out}'", shell=True, check=True, timeout=300,
                       stdout=subprocess.DEVNULL)
        self.cli("study", "merge", out)
        self.expect_the_same(out)

    def test_tasks_that_slurm_loses(self):
        try:
            slurm.check()
        except slurm.Missing as reason:
            self.skipTest(str(reason))
        out = self.folder / 'slurm 5%j "wide"'
        (self.folder / "cluster").mkdir()
        try:
            started = slurm.Slurm(self.folder / "cluster").start()
        except slurm.Missing as reason:
            self.skipTest(str(reason))
        with started as cluster:
            submit = ("study", "submit", self.study, "--shards", SHARDS, "--out", out)
            said = self.cli(*submit, env=cluster.environment).stdout
            job = said.split()[1].rstrip(":")
            self.assertIn("MaxJobCount", self.cli(*submit[:4], 10_000, *submit[5:], check=False,
                                                  env=cluster.environment).stderr)
            running = lambda: cluster.processes("shard")
            slurm.wait_until(running, 60, "a task")
            time.sleep(0.5)
            for pid in running()[:1]:  # one task is killed
                slurm.kill(pid)
            cluster.ask("scancel", f"{job}_4")  # one is cancelled
            slurm.wait_until(running, 60, "another task")
            cluster.kill_node("n2")  # one loses its node
            time.sleep(1.0)
            cluster.start_node("n2")
            slurm.wait_until(lambda: not cluster.ask("squeue", "-h", "-r", "-j", job, "-t", "PD,R,CG").strip(),
                             90, "the end of the job array")
            # what the merge waited for cannot come any more
            cluster.ask("scancel", "--user=root")
            slurm.wait_until(lambda: cluster.waiting() == 0 and not running(), 60, "an empty queue")
            self.cli(*submit, env=cluster.environment)
            slurm.wait_until((out / "study.sqlite").exists, 90, "the merged study")
            slurm.wait_until(lambda: cluster.waiting() == 0, 30, "an empty queue")
            self.assertTrue((out / "shard-1.log").exists(), "a log of the folder's name")
        self.expect_the_same(out)


if __name__ == "__main__":
    unittest.main()
