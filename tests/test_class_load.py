"""A class of thirty on a real JupyterHub, installed and configured as *Run a class* prints it."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import requests
import websocket
from browser import free_port
from jupyter_client.session import Session
from notebook_language import blocks, pages
from servers import PATIENCE, until

ROOT = Path(__file__).parents[1]
NOTEBOOK = "03-ordinary-rotation.ipynb"
STUDENTS = [f"student{number:02}" for number in range(1, 31)]


@pytest.fixture
def hub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A hub where each student has the notebook."""
    checkout = tmp_path / "checkout"
    made = shutil.ignore_patterns(".*_cache", ".git", ".venv", "_build", "node_modules")
    shutil.copytree(ROOT, checkout, ignore=made)
    section = pages()["run-a-class.md"].text.partition("(jupyterhub)=")[2]
    listings = [block.body for block in blocks(section) if block.kind == "fence"]
    install, configuration = (each.replace("/opt/class", str(tmp_path)) for each in listings[:2])
    monkeypatch.delenv("PYVISTA_JUPYTER_BACKEND", raising=False)
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=os.pathsep)
    subprocess.run(["sh", "-ec", install], cwd=checkout, check=True)
    for name in STUDENTS:
        shutil.copytree(checkout / "class" / "student", tmp_path / name)
    url = f"http://127.0.0.1:{free_port()}"
    # Comes after what the page prints, because nobody has an account on this machine.
    here = f"""
PROCESSORS = {os.cpu_count()}
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{free_port()}"
c.JupyterHub.authenticator_class = "dummy"
c.JupyterHub.bind_url = "{url}"
c.JupyterHub.hub_port = {free_port()}
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = "{tmp_path}/{{username}}"
c.Spawner.args.extend(["--allow-root"])
"""
    (tmp_path / "jupyterhub_config.py").write_text(configuration + here, "utf-8")
    log = tmp_path / "hub.log"
    with log.open("w") as stream:
        hub = subprocess.Popen("jupyterhub", cwd=tmp_path, stdout=stream, stderr=stream)
    until(lambda: "JupyterHub is now running" in log.read_text("utf-8"), f"the hub of {log}")
    yield url
    hub.terminate()
    hub.wait()
    with pytest.raises(requests.ConnectionError):
        requests.get(url, timeout=PATIENCE)


def attend(hub: str, name: str) -> None:
    """Log in, run all of the notebook as JupyterLab does, and save it."""
    http = requests.Session()
    form, home = f"{hub}/hub/login", f"{hub}/user/{name}"
    http.get(form).raise_for_status()
    proof = {"_xsrf": http.cookies.get("_xsrf", path="/hub/")}
    http.post(form, proof | {"username": name, "password": "any"}).raise_for_status()

    def opens() -> bool:
        # While the server starts, the hub answers: with an error, or on a page of its own.
        answer = http.get(f"{home}/lab")
        return answer.ok and answer.url.startswith(home)

    until(opens, f"the server of {name}")
    http.headers["X-XSRFToken"] = http.cookies.get("_xsrf", path=f"/user/{name}/")
    notebook = http.get(f"{home}/api/contents/{NOTEBOOK}").json()
    kernel = http.post(f"{home}/api/kernels", json={"name": "python3"}).json()["id"]
    channels = requests.Request("GET", f"{home}/api/kernels/{kernel}/channels")
    address = channels.url.replace("http", "ws", 1)
    cookie = http.prepare_request(channels).headers["Cookie"]
    socket = websocket.create_connection(address, PATIENCE, cookie=cookie, origin=hub)
    for cell in notebook["content"]["cells"]:
        if cell["cell_type"] == "code":
            run(socket, cell["source"])
    http.put(f"{home}/api/contents/{NOTEBOOK}", json=notebook).raise_for_status()


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


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="tried on Linux alone")
def test_nobody_fails_in_a_class_that_logs_in_at_once(hub: str) -> None:
    with ThreadPoolExecutor(len(STUDENTS)) as pool:
        visits = [pool.submit(attend, hub, name) for name in STUDENTS]
    assert [error for visit in visits if (error := visit.exception())] == []
