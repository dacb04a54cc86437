"""A class on a JupyterHub: log in, run Chapter 3, drag a figure, save, all students at once.

``python tools/class_load.py`` installs a hub below ``_build/class-load``, as *Run a class* says.
It lets 30 students in within one second, then 30 within a minute, and prints a table. Three of them
are browsers. The others are clients without a window, which speak to the kernel as JupyterLab does.
With ``--store`` it writes the results to ``benchmarks/class_load.json`` and into the page.
"""

import argparse
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Any

import nbformat
import psutil
import requests
import websocket
from browser import CHROMIUM_FLAGS as CHROME_FLAGS
from browser import installed_chromium as find_chromium
from jupyter_server.services.kernels.connection.base import deserialize_binary_message
from playwright.sync_api import Locator, Page, Response, sync_playwright

ROOT = Path(__file__).parents[1]
RESULTS = ROOT / "benchmarks" / "class_load.json"
PAGE = ROOT / "book" / "run-a-class.md"
TABLE = re.compile(r"^\| all log in within.*(?:\n\|.*)+", re.MULTILINE)
NOTEBOOK = "03-ordinary-rotation.ipynb"
VIEW = "application/vnd.jupyter.widget-view+json"
# In seconds. A student who waits longer has failed.
PATIENCE = 300

# The configuration of the page, then what this machine needs.
FROM_THE_PAGE = re.compile(r"^```python\n(.+?)^```", re.DOTALL | re.MULTILINE)
CONFIGURATION = """\
{from_the_page}
PROCESSORS = {processors}
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{proxy_port}"
c.ConfigurableHTTPProxy.command = [{node!r}, {proxy!r}]
c.JupyterHub.authenticator_class = "dummy"
c.JupyterHub.bind_url = "http://127.0.0.1:{port}"
c.JupyterHub.hub_port = {hub_port}
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = {homes!r}
c.Spawner.args = {options!r}
"""
# The second one is for the browsers: it gives them the commands of JupyterLab's menus.
OPTIONS = ["--allow-root", "--LabApp.expose_app_in_browser=True"]


@dataclass
class Visit:
    """When a student had what, in seconds after logging in."""

    began: float
    """When the student began to log in, in the machine's own time."""
    figure: float
    """The first figure can be dragged."""
    saved: float
    """A figure has been dragged, Python knows, and the notebook is on disk."""


@dataclass
class Run:
    """What a run of the whole class has measured."""

    students: int
    browsers: int
    within: float
    """Seconds from the first login to the last."""
    processors: int
    load_before: float
    """Processes that were waiting for a processor before the run, on average over a minute."""
    failures: list[str]
    first_figure: list[float]
    """For each student, in seconds, sorted."""
    saved: list[float]
    server_mib: float
    """Memory of a student's server, median."""
    kernel_mib: float
    hub_mib: float
    """Memory of hub and proxy."""
    machine_mib: float
    """Memory that the machine gave away, browsers included."""
    free_share: float
    """Share of the machine's memory that was left."""
    cpu_seconds: float
    """Processor time of a student's server and kernel until the end, median."""
    busy_share: float
    """How busy the processors were from the first login to the last first figure."""


def free_port() -> int:
    """Find a port that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def prepare(folder: Path) -> None:
    """Install a hub and what the notebooks need, from a copy of the checkout."""
    shutil.rmtree(folder, ignore_errors=True)
    checkout, environment = folder / "checkout", folder / "environment"
    listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    for name in subprocess.check_output(listed, cwd=ROOT, text=True).splitlines():
        (checkout / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, checkout / name)
    subprocess.run([sys.executable, "-m", "venv", environment], check=True)
    first = {"PATH": f"{environment / 'bin'}{os.pathsep}{os.environ['PATH']}"}

    def call(*command: str | Path) -> None:
        subprocess.run(command, cwd=folder, env=os.environ | first, check=True)

    hub = ["jupyterhub>=6,<7", "jupyterlab", "jsonschema<4.25"]
    call("python", "-m", "pip", "install", "--quiet", *hub)
    call(checkout / ".binder" / "postBuild")
    call("npm", "install", "--silent", "--prefix", folder, "configurable-http-proxy@5")


@contextmanager
def hub(folder: Path, students: list[str]) -> Iterator[tuple[str, psutil.Process]]:
    """Start a hub where each student has the notebook, and stop it with all that it started."""
    homes, binaries = folder / "homes", folder / "environment" / "bin"
    shutil.rmtree(homes, ignore_errors=True)
    for name in students:
        (homes / name).mkdir(parents=True)
        shutil.copy(folder / "checkout" / "class" / "student" / NOTEBOOK, homes / name)
    port = free_port()
    proxy = folder / "node_modules" / "configurable-http-proxy" / "bin" / "configurable-http-proxy"
    settings = CONFIGURATION.format(
        from_the_page=FROM_THE_PAGE.search(PAGE.read_text("utf-8"))[1],
        processors=psutil.cpu_count() or 1,
        port=port,
        hub_port=free_port(),
        proxy_port=free_port(),
        node=str(binaries / "node"),
        proxy=str(proxy),
        homes=f"{homes}/{{username}}",
        options=OPTIONS,
    )
    (folder / "jupyterhub_config.py").write_text(settings, "utf-8")
    (folder / "jupyterhub.sqlite").unlink(missing_ok=True)
    environment = {name: value for name, value in os.environ.items() if "PYVISTA" not in name}
    environment["PATH"] = f"{binaries}{os.pathsep}{environment['PATH']}"
    with (folder / "hub.log").open("w") as log:
        process = psutil.Popen(
            [binaries / "jupyterhub"], cwd=folder, env=environment, stdout=log, stderr=log
        )
    url = f"http://127.0.0.1:{port}"
    try:
        wait_until(lambda: answers(f"{url}/hub/health"), "the hub")
        yield url, process
    finally:
        started = process.children(recursive=True)
        process.send_signal(signal.SIGTERM)
        _, left = psutil.wait_procs([process, *started], timeout=30)
        for one in left:
            one.kill()


def answers(url: str) -> bool:
    """Tell whether a server answers."""
    try:
        return requests.get(url, timeout=10).ok
    except requests.ConnectionError:
        return False


def wait_until(done: Callable[[], bool], what: str) -> None:
    """Ask again and again until something is done."""
    end = time.monotonic() + PATIENCE
    while not done():
        if time.monotonic() > end:
            raise TimeoutError(f"{what}: not there after {PATIENCE} seconds")
        time.sleep(0.2)


@dataclass
class Figure:
    """A figure that a client has got from the kernel."""

    model: str
    """The number of its widget."""
    cell: int
    values: dict[str, Any]
    """What the hand can change."""
    seen: float


class Client:
    """A student without a window.

    Parameters
    ----------
    url : str
        The hub.
    name : str
        The student.
    """

    def __init__(self, url: str, name: str) -> None:
        self.url, self.name = url, name
        self.base = f"{url}/user/{name}"
        self.http = requests.Session()
        self.socket: websocket.WebSocket
        self.session = uuid.uuid4().hex

    def cookie(self, name: str, path: str) -> str:
        """Return a cookie that a browser would send to a path."""
        return str(self.http.cookies.get(name, path=path))

    def log_in(self) -> None:
        """Fill in the form, and wait for the server as the page of the hub does."""
        form = f"{self.url}/hub/login"
        self.http.get(form).raise_for_status()
        proof = {"_xsrf": self.cookie("_xsrf", "/hub/")}
        answer = self.http.post(form, proof | {"username": self.name, "password": "any"})
        answer.raise_for_status()
        progress = f"{self.url}/hub/api/users/{self.name}/server/progress"
        proof = {"_xsrf": self.cookie("_xsrf", "/hub/")}
        with self.http.get(progress, params=proof, stream=True) as events:
            events.raise_for_status()
            for line in events.iter_lines():
                event = json.loads(line.removeprefix(b"data:")) if line else {}
                if event.get("failed"):
                    raise RuntimeError(event["message"])
                if event.get("ready"):
                    break

    def open_notebook(self) -> Any:
        """Open the notebook with a kernel of its own; return its content."""
        self.http.get(f"{self.base}/lab/tree/{NOTEBOOK}").raise_for_status()
        self.http.headers["X-XSRFToken"] = self.cookie("_xsrf", f"/user/{self.name}/")
        notebook = self.http.get(f"{self.base}/api/contents/{NOTEBOOK}").json()["content"]
        kernel = {"kernel": {"name": "python3"}, "name": NOTEBOOK, "path": NOTEBOOK}
        answer = self.http.post(f"{self.base}/api/sessions", json=kernel | {"type": "notebook"})
        answer.raise_for_status()
        address = f"{self.base}/api/kernels/{answer.json()['kernel']['id']}/channels"
        request = requests.Request("GET", address, params={"session_id": self.session})
        ready = self.http.prepare_request(request)
        self.socket = websocket.create_connection(
            str(ready.url).replace("http", "ws", 1),
            cookie=ready.headers["Cookie"],
            origin=self.url,
            timeout=PATIENCE,
        )
        return nbformat.from_dict(notebook)

    def send(self, kind: str, content: dict[str, Any]) -> str:
        """Send a message to the kernel; return its number."""
        number = uuid.uuid4().hex
        header = {"msg_id": number, "msg_type": kind, "session": self.session, "version": "5.3"}
        message = {
            "header": header | {"username": self.name, "date": ""},
            "parent_header": {},
            "metadata": {},
            "channel": "shell",
            "content": content,
        }
        self.socket.send(json.dumps(message))
        return number

    def execute(self, code: str, **expressions: str) -> str:
        """Ask the kernel to run code, as JupyterLab does for a person who could answer."""
        quiet = {"silent": bool(expressions), "store_history": not expressions}
        content = {"code": code, "user_expressions": expressions, "allow_stdin": True}
        return self.send("execute_request", quiet | content)

    def messages(self) -> Iterator[Any]:
        """Yield what comes from the kernel."""
        while True:
            kind, data = self.socket.recv_data()
            binary = kind == websocket.ABNF.OPCODE_BINARY
            yield deserialize_binary_message(data) if binary else json.loads(data)

    def run(self, notebook: Any) -> Figure:
        """Run all cells, keep their outputs, and return the first figure with handles."""
        cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
        for cell in cells:
            cell.outputs = []
        asked = {self.execute(cell.source): cell for cell in cells}
        widgets: dict[str, Any] = {}
        found: Figure | None = None
        waiting = set(asked)
        for message in self.messages():
            kind, content = message["msg_type"], message["content"]
            number = message["parent_header"].get("msg_id")
            if kind == "comm_open":
                widgets[content["comm_id"]] = content["data"].get("state", {})
            elif kind == "error":
                raise RuntimeError(f"{content['ename']}: {content['evalue']}")
            elif number in asked and kind == "execute_input":
                asked[number].execution_count = content["execution_count"]
            elif number in asked and kind in ("display_data", "execute_result", "stream"):
                message["header"]["msg_type"] = kind
                asked[number].outputs.append(nbformat.v4.output_from_msg(message))
                model = content.get("data", {}).get(VIEW, {}).get("model_id")
                values = widgets.get(model, {}).get("values")
                if found is None and values:
                    cell = asked[number].execution_count
                    found = Figure(model, cell, values, time.monotonic())
            elif kind == "status" and content["execution_state"] == "idle":
                waiting.discard(number)
                if not waiting:
                    break
        assert found is not None
        return found

    def drag(self, figure: Figure) -> None:
        """Move the angle as a hand does, in small steps, and ask Python where it is."""
        theta = figure.values["theta"]
        for _ in range(20):
            theta += 1
            state = {"values": figure.values | {"theta": theta}}
            data = {"method": "update", "state": state, "buffer_paths": []}
            self.send("comm_msg", {"comm_id": figure.model, "data": data})
        number = self.execute("", theta=f"Out[{figure.cell}].theta")
        for message in self.messages():
            reply = message["msg_type"] == "execute_reply"
            if reply and message["parent_header"]["msg_id"] == number:
                told = message["content"]["user_expressions"]["theta"]
                break
        if told.get("data", {}).get("text/plain") != repr(theta):
            raise RuntimeError(f"expected an angle of {theta} after the drag, got {told}")

    def save(self, notebook: Any) -> None:
        """Save the notebook, and see that the server has it."""
        address = f"{self.base}/api/contents/{NOTEBOOK}"
        content = {"type": "notebook", "format": "json", "content": notebook}
        self.http.put(address, json=content).raise_for_status()
        kept = self.http.get(address).json()["content"]
        if sum(len(cell.get("outputs", [])) for cell in kept["cells"]) < 10:
            raise RuntimeError("the saved notebook has lost its outputs")

    def visit(self) -> Visit:
        """Do what the class does."""
        began = time.monotonic()
        self.log_in()
        notebook = self.open_notebook()
        figure = self.run(notebook)
        self.drag(figure)
        self.save(notebook)
        return Visit(began, figure.seen - began, time.monotonic() - began)


READY = """() => window.jupyterapp?.shell.currentWidget?.sessionContext
    ?.session?.kernel?.status === "idle" """
RUN_ALL = "void jupyterapp.commands.execute('notebook:run-all-cells')"
# Output comes after the number of its cell, so the kernel must be idle as well.
RAN = """() => {
    const { content, sessionContext } = jupyterapp.shell.currentWidget;
    const cells = [...content.model.cells].filter((cell) => cell.type === "code");
    return sessionContext.session.kernel.status === "idle"
        && cells.every((cell) => cell.executionCount);
}"""
ERRORS = """() => [...jupyterapp.shell.currentWidget.content.model.cells]
    .filter((cell) => cell.type === "code")
    .flatMap((cell) => cell.outputs.toJSON())
    .filter((output) => output.output_type === "error")
    .map((output) => output.ename + ": " + output.evalue)"""


def is_save(response: Response) -> bool:
    """Tell whether a response answers the saving of the notebook."""
    return response.request.method == "PUT" and NOTEBOOK in response.url


def drag_until_it_moves(page: Page, figure: Locator) -> None:
    """Drag a handle; again if the page, still growing, moved it away under the mouse."""
    before = figure.get_attribute("data-values")
    handle = figure.locator("[data-handle]").first
    end = time.monotonic() + PATIENCE
    while figure.get_attribute("data-values") == before:
        if time.monotonic() > end:
            raise TimeoutError(f"a dragged handle: has not moved after {PATIENCE} seconds")
        handle.scroll_into_view_if_needed()
        box = handle.bounding_box()
        assert box is not None
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + 20, y + 20, steps=10)
        page.mouse.up()
        page.wait_for_timeout(1000)


def visit_by_browser(page: Page, url: str, name: str) -> Visit:
    """Do in JupyterLab what the class does."""
    began = time.monotonic()
    page.set_default_timeout(PATIENCE * 1000)
    page.goto(f"{url}/hub/login")
    page.get_by_label("Username").fill(name)
    page.get_by_label("Password").fill("any")
    page.get_by_role("button", name="Sign in").click()
    page.locator(".jp-DirListing-item", has_text=NOTEBOOK).dblclick()
    page.wait_for_function(READY)
    page.evaluate(RUN_ALL)
    figure = page.locator(".explorable[data-values]").first
    figure.wait_for()
    first_figure = time.monotonic() - began
    page.wait_for_function(RAN)
    if errors := page.evaluate(ERRORS):
        raise RuntimeError("; ".join(errors))

    drag_until_it_moves(page, figure)
    # While a figure has the focus, JupyterLab hears no keys.
    page.locator(".jp-MarkdownCell").first.click()
    with page.expect_response(is_save) as saved:
        page.keyboard.press("Control+s")
    if not saved.value.ok:
        raise RuntimeError(f"the notebook was not saved: {saved.value.status_text}")
    return Visit(began, first_figure, time.monotonic() - began)


def give_way() -> None:
    """Let the hub go before the browsers, which have machines of their own in a class."""
    for process in psutil.Process().children(recursive=True):
        if "chrom" in process.name():
            process.nice(10)


def attend(
    name: str, url: str, browser: bool, delay: float, together: threading.Barrier
) -> Visit | str:
    """Let a student visit the hub; return when what was done, or what failed."""
    with ExitStack() as closing:
        page = None
        if browser:
            playwright = closing.enter_context(sync_playwright())
            chromium = find_chromium() or playwright.chromium.executable_path
            launched = playwright.chromium.launch(executable_path=chromium, args=CHROME_FLAGS)
            page = closing.enter_context(launched).new_page()
            give_way()
        together.wait()
        time.sleep(delay)
        try:
            return visit_by_browser(page, url, name) if page else Client(url, name).visit()
        # Whatever goes wrong is what this test is for.
        except Exception as error:
            return f"{name}: {type(error).__name__}: {error}"


@dataclass
class Sample:
    """The state of the machine at one moment."""

    time: float
    busy: float
    """Seconds that all processors together have worked."""
    free: int
    """Bytes of memory that are available."""


@contextmanager
def watched() -> Iterator[list[Sample]]:
    """Look at the machine twice a second."""
    samples: list[Sample] = []
    stop = threading.Event()

    def watch() -> None:
        while not stop.wait(0.5):
            cpu = psutil.cpu_times()
            busy = sum(cpu) - cpu.idle - cpu.iowait - cpu.guest - cpu.guest_nice
            samples.append(Sample(time.monotonic(), busy, psutil.virtual_memory().available))

    thread = threading.Thread(target=watch)
    thread.start()
    try:
        yield samples
    finally:
        stop.set()
        thread.join()


def busy_share(samples: list[Sample], end: float, processors: int) -> float:
    """Return how busy the processors were until a moment."""
    first, *_, last = [sample for sample in samples if sample.time <= end]
    return (last.busy - first.busy) / (last.time - first.time) / processors


def usage(hub_process: psutil.Process, students: int) -> dict[str, float]:
    """Measure the memory and the processor time of the hub and of the students' processes."""
    mib: dict[str, list[float]] = {"server": [], "kernel": [], "hub": []}
    seconds = 0.0
    for process in [hub_process, *hub_process.children(recursive=True)]:
        command = " ".join(process.cmdline())
        kind = (
            "server" if "singleuser" in command else "kernel" if "ipykernel" in command else "hub"
        )
        mib[kind].append(process.memory_info().rss / 2**20)
        if kind != "hub":
            cpu = process.cpu_times()
            seconds += cpu.user + cpu.system
    return {
        "server_mib": median(mib["server"]),
        "kernel_mib": median(mib["kernel"]),
        "hub_mib": sum(mib["hub"]),
        "cpu_seconds": seconds / students,
    }


def hold_class(folder: Path, students: int, browsers: int, within: float) -> Run:
    """Let a class visit a new hub, and measure it."""
    names = [f"student{number:02}" for number in range(1, students + 1)]
    load_before = psutil.getloadavg()[0]
    processors = psutil.cpu_count() or 1
    together = threading.Barrier(students)
    with hub(folder, names) as (url, process), ThreadPoolExecutor(students) as pool:
        with watched() as samples:
            visits = [
                pool.submit(attend, name, url, i < browsers, i / students * within, together)
                for i, name in enumerate(names)
            ]
            results = [visit.result() for visit in visits]
        used = usage(process, students)
    done = [result for result in results if isinstance(result, Visit)]
    if not done:
        raise RuntimeError("\n".join(map(str, results)))
    last_figure = max(visit.began + visit.figure for visit in done)
    least = min(sample.free for sample in samples)
    return Run(
        students=students,
        browsers=browsers,
        within=within,
        processors=processors,
        load_before=load_before,
        failures=[result for result in results if isinstance(result, str)],
        first_figure=sorted(visit.figure for visit in done),
        saved=sorted(visit.saved for visit in done),
        machine_mib=(samples[0].free - least) / 2**20,
        free_share=least / psutil.virtual_memory().total,
        busy_share=busy_share(samples, last_figure, processors),
        **used,
    )


def limit(run: Run) -> str:
    """Say what a faster class would need more of."""
    if run.free_share < 0.1:
        return "memory"
    return "processors" if run.busy_share > 0.9 else "the pace of the starts"


def table(runs: list[Run]) -> str:
    """Write what was measured as a table in Markdown, with a column for each run."""

    def seconds(number: float) -> str:
        return f"{number:.0f} s"

    rows: list[tuple[str, Callable[[Run], str]]] = [
        ("students, of them browsers", lambda run: f"{run.students}, {run.browsers}"),
        ("failed", lambda run: str(len(run.failures))),
        ("first figure, median", lambda run: seconds(median(run.first_figure))),
        ("first figure, worst", lambda run: seconds(run.first_figure[-1])),
        ("all run and saved, median", lambda run: seconds(median(run.saved))),
        ("all run and saved, worst", lambda run: seconds(run.saved[-1])),
        ("memory, a student's server", lambda run: f"{run.server_mib:.0f} MiB"),
        ("memory, a student's kernel", lambda run: f"{run.kernel_mib:.0f} MiB"),
        ("memory, hub and proxy", lambda run: f"{run.hub_mib:.0f} MiB"),
        ("memory, in all", lambda run: f"{run.machine_mib / 1024:.1f} GiB"),
        ("processor time, a student", lambda run: f"{run.cpu_seconds:.1f} s"),
        ("processors", lambda run: str(run.processors)),
        ("busy until the last first figure", lambda run: f"{run.busy_share:.0%}"),
        ("load before", lambda run: f"{run.load_before:.1f}"),
        ("limited by", limit),
    ]
    lines = [
        ["all log in within", *(seconds(run.within) for run in runs)],
        ["---"] * (1 + len(runs)),
    ]
    lines += [[title, *map(cell, runs)] for title, cell in rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def store(runs: list[Run]) -> None:
    """Keep the results, and put their table into the page."""
    RESULTS.write_text(json.dumps([asdict(run) for run in runs], indent=1) + "\n", "utf-8")
    PAGE.write_text(TABLE.sub(lambda _: table(runs), PAGE.read_text("utf-8")), "utf-8")


def main() -> None:
    """Run the class twice, and fail if a student fails."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--students", type=int, default=30)
    parser.add_argument("--browsers", type=int, default=3)
    parser.add_argument("--store", action="store_true", help="keep the results for the book")
    options = parser.parse_args()
    folder = ROOT / "_build" / "class-load"
    prepare(folder)
    runs = [hold_class(folder, options.students, options.browsers, within) for within in (1, 60)]
    print(table(runs))
    if failures := [failure for run in runs for failure in run.failures]:
        sys.exit("\n".join(failures))
    if options.store:
        store(runs)


if __name__ == "__main__":
    main()
