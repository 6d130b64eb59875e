"""A Slurm cluster of this machine alone, with daemons, keys and files of its own, for as long as a test takes."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

CONFIG = '''
ClusterName=incision
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
KillWait=2
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
'''

PROGRAMS = ('munged', 'mungekey', 'slurmctld', 'slurmd', 'sbatch', 'squeue', 'scancel', 'sinfo')
DEADLINE = 60  # [s]


def find(program):
    return shutil.which(program, path=os.environ['PATH'] + ':/usr/sbin:/sbin')


def is_there():
    return all(find(program) for program in PROGRAMS) and os.getuid() == 0


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class SlurmCluster:
    """As a context. `folder` is for its files and must be empty, and only for its user to write in."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.environment = {**os.environ, 'SLURM_CONF': str(self.folder / 'slurm.conf')}
        self.daemons = []

    def __enter__(self):
        try:
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def daemon(self, program, *options):
        log = open(self.folder / f'{program}.out', 'wb')
        self.daemons.append(subprocess.Popen([find(program), *map(str, options)], stdin=subprocess.DEVNULL, stdout=log,
                                             stderr=log, env=self.environment, start_new_session=True))
        log.close()

    def run(self, program, *options, check=True):
        return subprocess.run([find(program), *map(str, options)], env=self.environment, check=check, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL).stdout

    def start(self):
        host = socket.gethostname().split('.')[0]
        for name in ('state', 'spool'):
            (self.folder / name).mkdir()
        (self.folder / 'slurm.conf').write_text(CONFIG.format(
            host=host, folder=self.folder, controller_port=free_port(), node_port=free_port(), cpus=os.cpu_count(),
            user='root'))
        key, munge_socket = self.folder / 'munge.key', self.folder / 'munge.socket'
        subprocess.run([find('mungekey'), '--create', f'--keyfile={key}'], check=True)
        key.chmod(0o600)
        self.daemon('munged', '--foreground', '--force', f'--key-file={key}', f'--socket={munge_socket}',
                    f'--pid-file={self.folder}/munged.pid', f'--log-file={self.folder}/munged.log',
                    f'--seed-file={self.folder}/munged.seed')
        self.wait_until(munge_socket.exists)
        self.daemon('slurmctld', '-D', '-i')
        self.daemon('slurmd', '-D')
        self.wait_until(lambda: self.run('sinfo', '-h', '-o', '%T', check=False).strip() == 'idle')

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)
                daemon.wait()

    def wait_until(self, condition):
        deadline = time.monotonic() + DEADLINE
        while not condition():
            dead = [daemon.args[0] for daemon in self.daemons if daemon.poll() is not None]
            if dead or time.monotonic() > deadline:
                logs = '\n'.join(path.read_text(errors='replace')[-2000:] for path in self.folder.glob('*.log'))
                outs = '\n'.join(path.read_text(errors='replace')[-2000:] for path in self.folder.glob('*.out'))
                raise RuntimeError(f'no cluster; ended: {dead}\n{logs}\n{outs}')
            time.sleep(0.1)

    def jobs(self):
        return self.run('squeue', '-h', '-r', '-o', '%A %T').splitlines()
