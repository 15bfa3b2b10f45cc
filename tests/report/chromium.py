# SPDX-License-Identifier: MIT
"""Headless Chromium, driven over the pipe of its DevTools protocol with the standard library only."""
import atexit
import base64
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

FLAGS = ["--headless", "--no-sandbox", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--remote-debugging-pipe"]
NO_WEBGL = ["--disable-gpu", "--disable-3d-apis"]
SOFTWARE_WEBGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def find():
    """The path of Chromium, or None."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


SKIPPED = 77  # as Meson's tests say it


def is_missing():
    """Whether there is no Chromium; then says so."""
    if find() is not None:
        return False
    print("skipped: Chromium is not installed (Debian package chromium)")
    return True


class Browser:
    """A process of Chromium with one kind of graphics, which all pages of a test share: to start one for each page
    took most of their time."""
    running = {}

    def __init__(self, graphics):
        # Its helper processes may still write there when the browser has ended.
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_browser, self.commands = os.pipe()
        self.answers, from_browser = os.pipe()
        # The browser reads commands from descriptor 3 and writes answers to 4.
        self.process = subprocess.Popen(
            ["/bin/sh", "-c", f'exec "$@" 3<&{to_browser} 4>&{from_browser}', "chromium", find(), *FLAGS,
             *graphics, f"--user-data-dir={self.folder.name}", "about:blank"],
            pass_fds=(to_browser, from_browser), stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.number, self.rest, self.pages = 0, b"", {}
        atexit.register(self.close)

    @classmethod
    def of(cls, graphics):
        key = tuple(graphics)
        if key not in cls.running:
            cls.running[key] = cls(graphics)
        return cls.running[key]

    def close(self):
        os.close(self.commands)
        self.process.terminate()
        self.process.wait()
        os.close(self.answers)
        self.folder.cleanup()

    def call(self, method, session=None, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]

    def read(self):
        """The next message; what happens in a page goes to that page."""
        while b"\0" not in self.rest:
            piece = os.read(self.answers, 1 << 20)
            if not piece:
                raise RuntimeError("Chromium ended")
            self.rest += piece
        line, self.rest = self.rest.split(b"\0", 1)
        message = json.loads(line)
        page = self.pages.get(message.get("sessionId"))
        if page and "method" in message:
            page.events.append(message)
            page.note(message["method"], message["params"])
        return message


class Page:
    """A page in a window of its own that knows nothing of others; `complaints` are errors of its scripts and of
    loading."""

    def __init__(self, url, width=1280, height=900, media=(), graphics=NO_WEBGL):
        self.browser = Browser.of(graphics)
        self.events, self.complaints = [], []
        self.context = self.browser.call("Target.createBrowserContext")["browserContextId"]
        self.target = self.browser.call("Target.createTarget", url="about:blank", browserContextId=self.context)["targetId"]
        self.session = self.browser.call("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        self.browser.pages[self.session] = self
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=False)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": name, "value": value} for name, value in media])
        self.call("Page.navigate", url=url)
        while not any(event["method"] == "Page.loadEventFired" for event in self.events):
            self.browser.read()

    def close(self):
        del self.browser.pages[self.session]
        self.browser.call("Target.disposeBrowserContext", browserContextId=self.context)

    def processor_seconds(self):
        """What the browser and its helper processes have used of the processors (Linux)."""
        ticks, todo = 0, [self.browser.process.pid]
        while todo:
            process = pathlib.Path("/proc", str(todo.pop()))
            try:
                ticks += sum(map(int, (process / "stat").read_text().rpartition(")")[2].split()[11:13]))
                for children in process.glob("task/*/children"):
                    todo += children.read_text().split()
            except OSError:  # has ended
                pass
        return ticks / os.sysconf("SC_CLK_TCK")

    def call(self, method, **parameters):
        return self.browser.call(method, session=self.session, **parameters)

    def note(self, method, parameters):
        if method == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.complaints.append(" ".join(str(a.get("value")) for a in parameters["args"]))
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.complaints.append(parameters["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            url = parameters["request"]["url"]
            if not url.startswith(("file:", "data:", "about:", "blob:")):
                self.complaints.append(f"asks the network for {url}")

    def evaluate(self, script):
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"]["exception"]["description"])
        return result["result"].get("value")

    def screenshot(self, path, whole=True):
        picture = self.call("Page.captureScreenshot", captureBeyondViewport=whole)["data"]
        with open(path, "wb") as stream:
            stream.write(base64.b64decode(picture))

    def pdf(self, path):
        with open(path, "wb") as stream:
            stream.write(base64.b64decode(self.call("Page.printToPDF", printBackground=True)["data"]))
