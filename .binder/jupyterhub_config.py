"""JupyterHub on one machine, where no student reaches what is another's."""

import asyncio
import os
import pwd
import shutil
import time
from importlib.util import find_spec
from urllib.parse import quote

from jupyterhub.spawner import LocalProcessSpawner

# The name of the machine. Each student's server has a name below it, as in
# anna.class.example.org; else a page of one server could act in the name of
# whoever looks at it.
HOST = "class.example.org"
SOCKETS = "/run/class"
PROCESSORS = len(os.sched_getaffinity(0))

c = get_config()

if find_spec("debugpy"):
    raise SystemExit("First: /opt/class/bin/python -m pip uninstall debugpy")


class SocketSpawner(LocalProcessSpawner):
    """Start servers in turn, each on a socket that is its student's alone.

    Whoever is first may listen on a port, in the place of a server that
    starts or has ended.
    """

    next_start = 0.0

    async def start(self):
        """Start the server and return its address."""
        start = max(SocketSpawner.next_start, time.monotonic())
        SocketSpawner.next_start = start + 7 / PROCESSORS
        await asyncio.sleep(start - time.monotonic())
        student = pwd.getpwnam(self.user.name)
        os.chmod(student.pw_dir, 0o700)
        folder = f"{SOCKETS}/{self.user.name}"
        os.makedirs(SOCKETS, exist_ok=True)
        os.chmod(SOCKETS, 0o711)
        shutil.rmtree(folder, ignore_errors=True)
        os.mkdir(folder, 0o700)
        # The hub opens the name that is returned below. For the proxy it adds
        # a port, as to every address, and the proxy reads that as a part of
        # the name. Other versions may not.
        os.symlink("server", f"{folder}/server:80")
        os.chown(folder, student.pw_uid, student.pw_gid)
        self.args = [
            f"--ServerApp.sock={folder}/server",
            # With any port but its default the server refuses a socket.
            "--ServerApp.port=8888",
            "--KernelManager.transport=ipc",
        ]
        self.environment = {
            "JUPYTER_RUNTIME_DIR": folder,
            "OPENBLAS_NUM_THREADS": "1",
        }
        await super().start()
        return "http+unix://" + quote(f"{folder}/server", safe="")


c.JupyterHub.spawner_class = SocketSpawner
c.Spawner.start_timeout = 300
c.Spawner.http_timeout = 300

# The hub writes its secrets here, and what anybody writes is for nobody else.
os.chdir("/srv/class")
os.umask(0o077)
c.JupyterHub.bind_url = "https://:443"
c.JupyterHub.ssl_cert = "cert.pem"
c.JupyterHub.ssl_key = "key.pem"
c.JupyterHub.subdomain_host = f"https://{HOST}"
c.JupyterHub.cookie_host_prefix_enabled = True
# Only root can listen on ports below 1024.
c.JupyterHub.hub_port = 881
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:882"
c.ConfigurableHTTPProxy.command = [
    "/opt/class/bin/node",
    "/opt/class/node_modules/.bin/configurable-http-proxy",
]
# Whoever has an account and a password.
c.Authenticator.allow_all = True
