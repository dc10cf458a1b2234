# SPDX-License-Identifier: MIT
"""Drives a headless Chromium over its pipe of messages [DevTools protocol], with Python's own library alone."""
import base64, json, os, shutil, subprocess, tempfile, time


class Browser:
    def __init__(self, options=()):
        self.folder = tempfile.mkdtemp()
        to_read, self.to_browser = os.pipe()
        self.from_browser, to_write = os.pipe()
        words = ["chromium", "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-background-networking", "--no-first-run",
                 "--disable-component-update", "--hide-scrollbars", "--remote-debugging-pipe", "--user-data-dir=" + self.folder, *options]

        def hand_over():  # the browser reads from 3 and writes to 4
            a, b = os.dup(to_read), os.dup(to_write)
            os.dup2(a, 3), os.dup2(b, 4)

        self.log = open(os.path.join(self.folder, "log"), "w+")
        self.process = subprocess.Popen(words, preexec_fn=hand_over, pass_fds=(3, 4), stdout=self.log, stderr=self.log,
                                        env={**os.environ, "HOME": self.folder})
        os.close(to_read), os.close(to_write)
        self.rest, self.number, self.events = b"", 0, []

    def close(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def message(self):
        while b"\0" not in self.rest:
            more = os.read(self.from_browser, 1 << 20)
            if not more:
                self.log.seek(0)
                raise RuntimeError("the browser has ended: " + self.log.read()[-500:])
            self.rest += more
        one, self.rest = self.rest.split(b"\0", 1)
        return json.loads(one)

    def ask(self, method, session=None, **parameters):
        self.number += 1
        asked = {"id": self.number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        data = json.dumps(asked).encode() + b"\0"
        while data:
            data = data[os.write(self.to_browser, data):]
        while True:
            answer = self.message()
            if answer.get("id") != self.number:
                self.events.append(answer)
            elif "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']['message']}")
            else:
                return answer["result"]


class Page:
    """A page of a size in pixels; `told` are the console's lines and errors, `asked` the addresses that were asked for."""

    def __init__(self, browser, width, height, scale=1, dark=False, touch=False, script=True, calm=False):
        self.browser = browser
        target = browser.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.ask(domain + ".enable")
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=touch)
        self.ask("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                                                         {"name": "prefers-reduced-motion", "value": "reduce" if calm else "no-preference"}])
        self.ask("Emulation.setScriptExecutionDisabled", value=not script)

    def ask(self, method, **parameters):
        return self.browser.ask(method, self.session, **parameters)

    def open(self, address):
        self.ask("Page.navigate", url=address)
        self.wait("document.readyState === 'complete'")

    def run(self, code):
        """The value of a JavaScript expression, which may be a promise."""
        result = self.ask("Runtime.evaluate", expression=code, awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in result:
            raise RuntimeError(code + ": " + json.dumps(result["exceptionDetails"].get("exception", {}).get("description")))
        return result["result"].get("value")

    def wait(self, condition, seconds=60):
        """Waits until the expression is true; returns the seconds that it took."""
        begun = time.monotonic()
        while not self.run(f"!!({condition})"):
            if time.monotonic() - begun > seconds:
                raise AssertionError("waited in vain for " + condition)
            time.sleep(0.05)
        return time.monotonic() - begun

    def press(self, key):
        code = {" ": "Space"}.get(key, key)
        self.ask("Input.dispatchKeyEvent", type="keyDown", key=key, code=code, **({"text": key} if len(key) == 1 else {}))
        self.ask("Input.dispatchKeyEvent", type="keyUp", key=key, code=code)

    def mouse(self, kind, x, y, **more):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def touch(self, kind, *points):
        self.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in points])

    def picture(self, file, top, height):
        """A part of the page, seen or not."""
        width = self.ask("Page.getLayoutMetrics")["cssContentSize"]["width"]
        shot = self.ask("Page.captureScreenshot", captureBeyondViewport=True,
                        clip={"x": 0, "y": top, "width": width, "height": height, "scale": 1})
        with open(file, "wb") as out:
            out.write(base64.b64decode(shot["data"]))

    def mine(self):
        return [e for e in self.browser.events if e.get("sessionId") == self.session]

    def told(self):
        lines = []
        for event in self.mine():
            p = event["params"]
            if event["method"] == "Runtime.consoleAPICalled":
                lines.append(" ".join(str(a.get("value", a.get("description"))) for a in p["args"]))
            if event["method"] == "Runtime.exceptionThrown":
                lines.append(p["exceptionDetails"].get("exception", {}).get("description", p["exceptionDetails"]["text"]))
            if event["method"] == "Log.entryAdded":
                lines.append(p["entry"]["text"])
        return lines

    def asked(self):
        return [e["params"]["request"]["url"] for e in self.mine() if e["method"] == "Network.requestWillBeSent"]
