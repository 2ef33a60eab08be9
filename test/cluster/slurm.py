# SPDX-License-Identifier: BSD-3-Clause
"""A Slurm of two nodes on this machine, for a test: started, asked, hurt and stopped."""

import os
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("slurmctld", "slurmd", "munged", "sbatch", "squeue", "scancel", "sinfo", "munge")
NODES = ("n1", "n2")


class Missing(Exception):
    """Why there can be no Slurm here."""


def find(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")


def check():
    missing = [name for name in PROGRAMS if not find(name)]
    if missing:
        raise Missing(f"{', '.join(missing)} missing: install slurm-wlm and munge")
    if os.geteuid() != 0:
        raise Missing("Slurm's daemons need root")
    try:
        socket.gethostbyname(socket.gethostname())
    except OSError:
        raise Missing(f"the name of this machine, {socket.gethostname()}, has no address") from None


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    try:
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]
    finally:
        for each in sockets:
            each.close()


def wait_until(condition, seconds, what):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.1)
    raise AssertionError(f"After {seconds} s there is still not: {what}")


class Slurm:
    """Use as a context after start(): the daemons stop at its end."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.conf = self.folder / "slurm.conf"
        self.daemons = {}
        self.munged = None

    def start(self):
        try:
            self.start_munge()
            self.write_conf()
            self.run("slurmctld", "-D")
            for node in NODES:
                self.start_node(node)
            wait_until(lambda: self.ask("sinfo", "-h", "-o", "%T %D").split() == ["idle", "2"], 60,
                       "two idle nodes")
        except AssertionError as error:
            self.__exit__()
            raise Missing(f"Slurm does not start on this machine ({error})") from error
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
        if self.munged:
            self.munged.terminate()
            self.munged.wait(20)

    def start_munge(self):
        """One of its own, with its own key and socket."""
        own = self.folder / "munge"
        own.mkdir()
        key = own / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.socket = own / "socket"
        # --force: munged refuses folders below one that others may write, such as a temporary one
        self.munged = subprocess.Popen(
            [find("munged"), "--foreground", "--force", f"--key-file={key}", f"--socket={self.socket}",
             f"--pid-file={own / 'pid'}", f"--log-file={own / 'log'}", f"--seed-file={own / 'seed'}"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until(lambda: self.socket.exists() or self.munged.poll() is not None, 20, "munged")
        if self.munged.poll() is not None:
            raise AssertionError("munged ended: " + (own / "log").read_text())

    def write_conf(self):
        host = socket.gethostname()
        control, *ports = free_ports(1 + len(NODES))
        lines = ["ClusterName=perilymph", f"SlurmctldHost={host}(127.0.0.1)", "AuthType=auth/munge",
                 f"AuthInfo=socket={self.socket}", "SlurmUser=root", "SlurmdUser=root",
                 f"StateSaveLocation={self.folder}/state", f"SlurmdSpoolDir={self.folder}/spool.%n",
                 f"SlurmctldPidFile={self.folder}/ctld.pid", f"SlurmdPidFile={self.folder}/slurmd.%n.pid",
                 f"SlurmctldLogFile={self.folder}/ctld.log", f"SlurmdLogFile={self.folder}/slurmd.%n.log",
                 f"SlurmctldPort={control}", "ProctrackType=proctrack/linuxproc", "TaskPlugin=task/none",
                 "SelectType=select/cons_tres", "SelectTypeParameters=CR_Core", "ReturnToService=2",
                 "MpiDefault=none", "JobAcctGatherType=jobacct_gather/none", "SlurmdTimeout=10",
                 "MinJobAge=300", "KillWait=2", "InactiveLimit=0", "SchedulerParameters=sched_interval=1"]
        lines += [f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN"
                  for node, port in zip(NODES, ports)]
        lines.append("PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP")
        self.conf.write_text("\n".join(lines) + "\n")
        (self.folder / "state").mkdir()
        for node in NODES:
            (self.folder / f"spool.{node}").mkdir()

    @property
    def environment(self):
        return {**os.environ, "SLURM_CONF": str(self.conf)}

    def run(self, program, *options, name=None):
        self.daemons[name or program] = subprocess.Popen(
            [find(program), "-f", str(self.conf), *options], env=self.environment,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def start_node(self, node):
        self.run("slurmd", "-D", "-N", node, name=node)

    def kill_node(self, node):
        """The node is gone: its daemon and what it runs."""
        self.daemons[node].kill()
        self.daemons[node].wait(20)

    def ask(self, *words):
        done = subprocess.run([find(words[0]), *words[1:]], env=self.environment, capture_output=True,
                              text=True, timeout=60, check=False)
        return done.stdout

    def waiting(self):
        """Number of jobs and tasks that are not over."""
        return len(self.ask("squeue", "-h", "-r", "-t", "PD,R,CG,CF,RQ,S").splitlines())

    def processes(self, text):
        """Processes whose command line has the text."""
        found = []
        for entry in Path("/proc").glob("[0-9]*"):
            try:
                words = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if any(text.encode() == word for word in words):
                found.append(int(entry.name))
        return found


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
