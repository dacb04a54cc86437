"""A class of thirty accounts on a JupyterHub that is installed as *Run a class* prints it."""

import json
import os
import pwd
import secrets
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
import requests
import websocket
from jupyter_client.session import Session
from notebook_language import blocks, pages
from servers import PATIENCE, until

ROOT = Path(__file__).parents[1]
NOTEBOOK = "03-ordinary-rotation.ipynb"
STUDENTS = [f"class-test-{number:02}" for number in range(1, 31)]
HOST = "class.localhost"
PASSWORD = secrets.token_urlsafe()
COMMAND = "sudo .venv/bin/pytest -m slow tests/test_class_load.py"


def install(folder: Path) -> None:
    """Do what the page says, in a folder instead of three."""
    checkout = folder / "checkout"
    made = shutil.ignore_patterns(".*_cache", ".git", ".venv", "_build", "node_modules")
    shutil.copytree(ROOT, checkout, ignore=made)
    section = pages()["run-a-class.md"].text.partition("(jupyterhub)=")[2]
    packages, certificate = [block.body for block in blocks(section) if block.kind == "fence"][:2]
    configuration = checkout / ".binder" / "jupyterhub_config.py"
    places = {
        "/opt/class": str(folder),
        "/run/class": f"{folder}/sockets",
        "/srv/class": f"{folder}/hub",
        "class.example.org": HOST,
    }

    def here(text: str) -> str:
        for printed, ours in places.items():
            text = text.replace(printed, ours)
        return text

    configuration.write_text(here(configuration.read_text("utf-8")), "utf-8")
    # Root's own files are often nobody else's.
    script = here(packages + certificate)
    subprocess.run(["sh", "-ec", script], cwd=checkout, check=True, umask=0o077)


def without_debugger(folder: Path, command: list[str | Path]) -> None:
    """See that the hub refuses to start while the debugger is installed."""
    (packages,) = folder.glob("lib/python3*/site-packages")
    assert not (packages / "debugpy").exists()
    (packages / "debugpy").mkdir()
    tried = ["timeout", str(PATIENCE), *command]
    refusal = subprocess.run(tried, cwd=folder, stderr=subprocess.PIPE, text=True).stderr
    (packages / "debugpy").rmdir()
    assert "pip uninstall debugpy" in refusal


@contextmanager
def account(name: str, files: Path) -> Iterator[None]:
    """Add a student, whose home stands open, as it does on many machines."""
    home = ["--create-home", "--skel", str(files), "--key", "HOME_MODE=0755"]
    subprocess.run(["useradd", *home, name], check=True)
    try:
        subprocess.run("chpasswd", input=f"{name}:{PASSWORD}", text=True, check=True)
        yield
    finally:
        subprocess.run(["userdel", "--force", "--remove", name])


@pytest.fixture
def hub(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Run a hub in a new folder; of folder and accounts nothing stays."""
    if os.geteuid() != 0:
        pytest.fail(f"This adds accounts to the machine, and needs root: {COMMAND}", pytrace=False)
    find = socket.getaddrinfo
    monkeypatch.setattr(
        socket, "getaddrinfo", lambda _, *rest, **more: find("127.0.0.1", *rest, **more)
    )
    monkeypatch.delenv("PYVISTA_JUPYTER_BACKEND", raising=False)
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="class-", dir="/opt")))
        folder.chmod(0o755)
        # Students can run the Python of the system; that of the tests may be in somebody's home.
        monkeypatch.setenv("PATH", f"{folder}/bin:/usr/sbin:/usr/bin:/sbin:/bin")
        install(folder)
        for name in STUDENTS:
            stack.enter_context(account(name, folder / "checkout" / "class" / "student"))
        log = folder / "hub" / "hub.log"
        command = ["jupyterhub", "-f", folder / "hub" / "jupyterhub_config.py"]
        without_debugger(folder, command)
        with log.open("w") as stream:
            hub = subprocess.Popen(command, cwd=folder, stdout=stream, stderr=stream)
        stack.callback(hub.wait)
        stack.callback(hub.terminate)
        until(lambda: "JupyterHub is now running" in log.read_text("utf-8"), f"the hub of {log}")
        yield folder
        hub.terminate()
        hub.wait()
        assert subprocess.run(["pgrep", "--uid", ",".join(STUDENTS)]).returncode == 1
        with pytest.raises(requests.ConnectionError):
            requests.get(f"https://{HOST}", timeout=PATIENCE)


def address(name: str) -> str:
    """Return where a student's server is."""
    return f"https://{name}.{HOST}/user/{name}"


def attend(folder: Path, name: str) -> requests.Session:
    """Log in, run all of the notebook as JupyterLab does, and save it."""
    http = requests.Session()
    http.trust_env = False
    http.verify = str(folder / "hub" / "cert.pem")
    form, home = f"https://{HOST}/hub/login", address(name)
    http.get(form).raise_for_status()
    proof = {"_xsrf": http.cookies.get("_xsrf", path="/hub/")}
    http.post(form, proof | {"username": name, "password": PASSWORD}).raise_for_status()

    def opens() -> bool:
        # While the server starts, the hub answers: with an error, or on a page of its own.
        answer = http.get(f"{home}/lab")
        return answer.ok and answer.url.startswith(home)

    until(opens, f"the server of {name}")
    http.headers["X-XSRFToken"] = http.cookies.get("_xsrf", path=f"/user/{name}/")
    notebook = http.get(f"{home}/api/contents/{NOTEBOOK}").json()
    kernel = http.post(f"{home}/api/kernels", json={"name": "python3"}).json()["id"]
    channels = requests.Request("GET", f"{home}/api/kernels/{kernel}/channels")
    url = channels.url.replace("http", "ws", 1)
    cookie = http.prepare_request(channels).headers["Cookie"]
    origin, trust = home.partition("/user")[0], {"ca_certs": http.verify}
    socket = websocket.create_connection(url, PATIENCE, cookie=cookie, origin=origin, sslopt=trust)
    for cell in notebook["content"]["cells"]:
        if cell["cell_type"] == "code":
            run(socket, cell["source"])
    http.put(f"{home}/api/contents/{NOTEBOOK}", json=notebook).raise_for_status()
    return http


def run(socket: websocket.WebSocket, code: str) -> None:
    """Run a cell for a person who sees figures and could answer a question."""
    content = {"code": code, "silent": False, "allow_stdin": True}
    request = Session().msg("execute_request", content) | {"channel": "shell"}
    socket.send(json.dumps(request, default=str))
    for data in iter(socket.recv, None):
        # What comes in bytes is a figure.
        reply = {} if isinstance(data, bytes) else json.loads(data)
        own = reply.get("parent_header", {}).get("msg_id") == request["msg_id"]
        if own and reply["msg_type"] == "execute_reply":
            assert reply["content"]["status"] == "ok", reply["content"]
            return


def listeners() -> set[int]:
    """Return the numbers of all users who listen on a port of the machine."""
    lines = [
        line.split()
        for table in ("/proc/net/tcp", "/proc/net/tcp6")
        for line in Path(table).read_text("utf-8").splitlines()[1:]
    ]
    return {int(user) for _, _, _, state, _, _, _, user, *_ in lines if state == "0A"}


def open_to(name: str, folders: list[Path]) -> str:
    """Return what a student can read in folders."""
    find = ["find", *folders, "-readable"]
    group = pwd.getpwnam(name).pw_gid
    found = subprocess.run(find, user=name, group=group, extra_groups=[], stdout=subprocess.PIPE)
    return found.stdout.decode()


@pytest.mark.slow
def test_thirty_log_in_at_once_and_nobody_reaches_another(hub: Path) -> None:
    with ThreadPoolExecutor(len(STUDENTS)) as pool:
        visits = [pool.submit(attend, hub, name) for name in STUDENTS]
    assert [error for visit in visits if (error := visit.exception())] == []

    assert not listeners() & {pwd.getpwnam(name).pw_uid for name in STUDENTS}
    first, *others = STUDENTS
    homes = [Path("/home", name) for name in others]
    sockets = [hub / "sockets" / name for name in STUDENTS]
    assert open_to(first, sockets[:1]) != ""
    assert open_to(first, [hub / "hub", *homes, *sockets[1:]]) == ""
    answer = visits[0].result().get(f"{address(others[0])}/api/contents/{NOTEBOOK}")
    assert answer.status_code == 403
