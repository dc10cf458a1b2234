#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A browser opens the report: bodies turn, charts follow, keys, mouse and fingers work, links bring back what they were made of, what is read
is what is seen, nothing is asked for, and where there is no WebGL or no script the pictures stand. browser_test.py <page_of_balls>, or
browser_test.py --pictures <report.html> <folder> to take pictures of a page. Skipped (77) where chromium is not installed."""
import json, os, shutil, subprocess, sys, tempfile, time
from browser import Browser, Page

DRAWN_BY_SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
BODY = "figure-1-turning"
# A copy of a canvas to read from, and a number that changes with the picture: of the pixels that are wholly drawn (those of shadows are rounded in more than one way), with
# how many they are.
COPY = """(c => { const copy = new OffscreenCanvas(c.width, c.height).getContext('2d', { willReadFrequently: true });
copy.drawImage(c, 0, 0); return copy; })"""
SUM = """(b => { const d = %s(b.canvas).getImageData(0, 0, b.canvas.width, b.canvas.height).data; let sum = 0, solid = 0;
for (let i = 0; i < d.length; i += 4) { if (d[i + 3] < 255) continue; ++solid; sum = (sum * 31 + i + d[i] + 7 * d[i + 1] + 13 * d[i + 2]) >>> 0; }
return [sum, solid]; })(bodies[%%d])""" % COPY
MIDDLE = """(c => { c.scrollIntoView({ block: 'center' }); const r = c.getBoundingClientRect();
return [r.left + r.width / 2, r.top + r.height / 2]; })(bodies[0].canvas)"""
INFERNO = "000004 210c4a 57106e 8a226a bc3754 e45a31 f98c0a f9cb35 fcffa4".split()


def check(holds, *what):
    if not holds:
        raise AssertionError(" ".join(str(w) for w in what))


def settled(page):
    """Waits until what was asked is drawn and stands in the address."""
    page.run("new Promise(done => setTimeout(() => requestAnimationFrame(() => bodies[0].drawn.then(done)), 350))")


def opened(browser, address, state, width=1280, height=900, scale=1, **options):
    """A page on which the first body stands in a state."""
    page = Page(browser, width, height, scale, **options)
    page.open(address + f"#{BODY}&{state}")
    page.wait("document.querySelector('.alive')")
    settled(page)
    return page


def colour_of(share):
    at = min(share * (len(INFERNO) - 1), len(INFERNO) - 1.000001)
    low, high = INFERNO[int(at)], INFERNO[int(at) + 1]
    return [int(low[k:k + 2], 16) * (1 - at % 1) + int(high[k:k + 2], 16) * (at % 1) for k in (0, 2, 4)]


def turns_and_is_linked(browser, address):
    page = opened(browser, address, "t=1&by=temperature&cut=x0.6")
    state = page.run("bodies[0].state")
    check((state["time"], state["field"], state["cut"], state["place"]) == (1, "temperature", True, 0.6), "recalled", state)
    check(page.run("!document.querySelector('.still')"), "a body stands still")
    check(page.run("document.querySelector('.legend').hidden") is False, "no legend")
    before, solid = page.run(SUM % 0)
    check(solid > 20000, "hardly anything is drawn:", solid)
    page.run("document.querySelector('figure canvas').focus({ preventScroll: true })")
    hash_before = page.run("location.hash")
    for key in ["ArrowLeft", "ArrowUp", "+", ".", "3", "4", "c", "]", "r", "1"]:
        page.press(key)
        settled(page)
        now, address_now = page.run(SUM % 0)[0], page.run("location.hash")
        check(now != before, key, "does not change the picture")
        check(address_now != hash_before, key, "does not change the address")
        before, hash_before = now, address_now
    page.press(" ")
    for _ in range(100):  # a busy machine may take its time to draw the first
        time.sleep(0.2)
        if page.run("bodies[0].state.time") > 0:
            break
    page.press(" ")
    played = page.run("bodies[0].state.time")
    time.sleep(0.3)
    check(page.run("bodies[0].state.time") == played and 0 < played < 2, "played to", played)
    # a link made of the address brings the same picture back
    page.run("bodies[0].set({ field: 'porosity', time: 0, cut: true, axis: 'y', place: .4 }), bodies[0].look({ turn: -.5, lift: .7, far: 1.2 })")
    settled(page)
    kept, link = page.run(SUM % 0), page.run("location.hash")
    page.open("about:blank")
    page.open(address + link)
    page.wait("document.querySelector('.alive')")
    settled(page)
    check(page.run(SUM % 0) == kept, "another picture from the link", link)
    # particles, and the followers of the first body
    surface = page.run(SUM % 0)[0]
    page.run("bodies[0].set({ shape: 'particles', time: .5 })")
    settled(page)
    check(page.run(SUM % 0)[0] != surface and page.run(SUM % 0)[1] > 5000, "no particles")
    page.run("bodies[1].figure.scrollIntoView()")
    page.wait("bodies[1].figure.classList.contains('alive')")
    settled(page)
    check(page.run(SUM % 1)[1] > 2000, "the follower is empty")
    check(page.run("!bodies.some(b => !b.canvas.getAttribute('aria-label'))"), "a canvas without words")
    # the chart's cursor follows, and a click on the chart sets the time
    page.run("bodies[0].set({ time: 2 })")
    settled(page)
    right = page.run("document.querySelector('.cursor').getAttribute('x1')")
    place = page.run("(r => [r.left + r.width * .35, r.top + r.height / 2])(document.querySelector('.plot').getBoundingClientRect())")
    page.run("document.querySelector('.plot').scrollIntoView({ block: 'center' })")
    place = page.run("(r => [r.left + r.width * .35, r.top + r.height / 2])(document.querySelector('.plot').getBoundingClientRect())")
    for kind in ("mousePressed", "mouseReleased"):
        page.mouse(kind, *place, button="left", clickCount=1)
    settled(page)
    check(0.2 < page.run("bodies[0].state.time") < 1.5, "the chart sets", page.run("bodies[0].state.time"))
    check(float(page.run("document.querySelector('.cursor').getAttribute('x1')")) < float(right) - 20, "the cursor stays")
    check(page.told() == [], "the browser complains:", page.told())
    check([a for a in page.asked() if not a.startswith(("file://", "data:", "about:"))] == [], "asked for", page.asked())


def reads_what_is_seen(browser, address):
    page = opened(browser, address, "t=2&by=temperature&cut=x0.5&from=0,0.3,1")
    for dx, dy in [(0, 0), (60, 0), (-80, 30), (20, -70)]:
        x, y = page.run(f"[Math.round(bodies[0].canvas.width / 2) + {dx}, Math.round(bodies[0].canvas.height / 2) + {dy}]")
        seen = page.run(f"[...{COPY}(bodies[0].canvas).getImageData({x}, {y}, 1, 1).data]")
        codes = page.run(f"bodies[0].draw([{x}, bodies[0].canvas.height - 1 - {y}]).then(p => [...p])")
        wanted = colour_of((codes[0] - 1) / 254)
        check(codes[0] > 0 and max(abs(a - b) for a, b in zip(wanted, seen)) <= 3, "read", codes, "is", wanted, "seen", seen)
    # in the middle of the ball, cut through the middle, it is 60 C, 50 % wet and 30 % gas
    box = page.run("(r => [r.left + r.width / 2, r.top + r.height / 2])(bodies[0].canvas.getBoundingClientRect())")
    page.mouse("mouseMoved", *box)
    page.wait("document.querySelector('.reading').textContent !== ''")
    words = page.run("document.querySelector('.reading').textContent")
    numbers = [int(w) for w in words.split() if w.isdigit()]
    check(len(numbers) == 3 and abs(numbers[0] - 60) <= 2 and abs(numbers[1] - 50) <= 3 and abs(numbers[2] - 29) <= 4, "read", words)


def leaves_the_page_its_wheel_and_fingers(browser, address):
    page = opened(browser, address, "t=2")
    x, y = page.run(MIDDLE)
    from_above, far = page.run("scrollY"), page.run("bodies[0].camera.far")
    page.mouse("mouseWheel", x, y, deltaX=0, deltaY=120)
    page.wait(f"scrollY > {from_above}")
    time.sleep(0.5)  # it scrolls on
    check(page.run("bodies[0].camera.far") == far, "an unasked wheel zooms")
    x, y = page.run(MIDDLE)
    turn = page.run("bodies[0].camera.turn")
    page.mouse("mousePressed", x, y, button="left", clickCount=1)
    page.mouse("mouseMoved", x + 100, y, button="left", buttons=1)
    page.mouse("mouseReleased", x + 100, y, button="left", clickCount=1)
    check(abs(page.run("bodies[0].camera.turn") - turn + 0.8) < 0.01, "dragged to", page.run("bodies[0].camera.turn"))
    page.mouse("mouseWheel", x, y, deltaX=0, deltaY=120)  # the drag has focused it
    page.wait(f"bodies[0].camera.far > {far}")

    page = opened(browser, address, "t=2", 390, 844, 2, touch=True)
    x, y = page.run(MIDDLE)
    turn, far = page.run("bodies[0].camera.turn"), page.run("bodies[0].camera.far")
    page.touch("touchStart", (x, y))
    for step in range(1, 6):
        page.touch("touchMove", (x + 10 * step, y))
    page.touch("touchEnd")
    check(page.run("bodies[0].camera.turn") < turn - 0.1, "a finger does not turn it")
    page.touch("touchStart", (x - 40, y), (x + 40, y))
    for step in range(1, 6):
        page.touch("touchMove", (x - 40 - 8 * step, y), (x + 40 + 8 * step, y))
    page.touch("touchEnd")
    check(page.run("bodies[0].camera.far") < far - 0.1, "two fingers do not zoom")
    check(page.run("document.documentElement.scrollWidth <= innerWidth"), "the page is wider than a phone")


def keeps_its_policy(browser, address):
    page = opened(browser, address, "t=2")
    check(page.run("fetch('https://example.org/').then(() => 'went out', () => 'refused')") == "refused", "a request went out")
    check(any("Content Security Policy" in line for line in page.told()), "it was not the policy that refused:", page.told())


def comes_back_after_a_lost_context(browser, address):
    page = opened(browser, address, "t=2")
    kept = page.run(SUM % 0)
    page.run("bodies[0].paper.clearRect(0, 0, 9999, 9999), loseContext()")
    page.wait(f"{SUM % 0}[1] >= {kept[1]}", 20)


def plays_no_motion_where_none_is_wanted(browser, address):
    page = opened(browser, address, "t=0", calm=True)
    page.run("document.querySelector('.play').click()")
    settled(page)
    check(page.run("bodies[0].state.time") == 1 and not page.run("bodies[0].timer"), "it moves by itself")


def stands_without_script_or_webgl(address, folder):
    browser = Browser(["--disable-gpu", "--disable-3d-apis"])
    try:
        page = Page(browser, 1280, 900)
        page.open(address)
        page.wait("document.querySelector('figure.still')")
        seen = "(e => getComputedStyle(e).visibility + getComputedStyle(e).display)(document.querySelector('%s'))"
        check(page.run(seen % ".poster") == "visibleblock", "no picture without WebGL")
        check(page.run(seen % ".controls").endswith("none"), "controls of nothing")
        page.ask("Emulation.setEmulatedMedia", media="print")
        check(page.run(seen % ".poster") == "visibleblock", "no picture in print")
        page.ask("Page.printToPDF")
        page = Page(browser, 1280, 900, script=False)
        page.open(address)
        check(page.run(seen % ".poster") == "visibleblock" and page.run(seen % ".controls").endswith("none"), "no picture without script")
    finally:
        browser.close()


def take_pictures(file, folder):
    os.makedirs(folder, exist_ok=True)
    address = "file://" + os.path.abspath(file)
    browser = Browser(DRAWN_BY_SOFTWARE)
    try:
        for name, width, height, options in [("desktop", 1280, 900, {}), ("dark", 1280, 900, {"dark": True}),
                                             ("phone", 390, 844, {"scale": 2, "touch": True}),
                                             ("phone_dark", 390, 844, {"scale": 2, "touch": True, "dark": True})]:
            page = Page(browser, width, height, **options)
            begun = time.monotonic()
            page.open(address)
            loaded = time.monotonic() - begun
            seen = page.run("performance.getEntriesByName('first-contentful-paint')[0].startTime") / 1000
            for i in range(page.run("bodies.length")):  # they are drawn when they come near
                page.run(f"bodies[{i}].figure.scrollIntoView()")
                page.wait(f"bodies[{i}].figure.matches('.alive, .still')")
            page.run("scrollTo(0, 0)")
            time.sleep(1)
            height_px = page.run("document.documentElement.scrollHeight")
            for i, top in enumerate(range(0, height_px, 4 * height)):
                page.picture(os.path.join(folder, f"{name}_{i}.png"), top, min(4 * height, height_px - top))
            print(f"{name}: first view after {seen:.2f} s, loaded after {loaded:.2f} s, {height_px} px high, wide {page.run('document.documentElement.scrollWidth')},",
                  "console", page.told(), "asked", [a[:60] for a in page.asked() if not a.startswith(("file:", "data:"))])
    finally:
        browser.close()


def main():
    if shutil.which("chromium") is None:
        sys.exit(77)
    if sys.argv[1] == "--pictures":
        return take_pictures(*sys.argv[2:])
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        address = "file://" + os.path.join(folder, "report.html")
        browser = Browser(DRAWN_BY_SOFTWARE)
        try:
            for test in (turns_and_is_linked, reads_what_is_seen, leaves_the_page_its_wheel_and_fingers, keeps_its_policy,
                         comes_back_after_a_lost_context, plays_no_motion_where_none_is_wanted):
                print(test.__name__, flush=True)
                test(browser, address)
        finally:
            browser.close()
        print("stands_without_script_or_webgl", flush=True)
        stands_without_script_or_webgl(address, folder)


main()
