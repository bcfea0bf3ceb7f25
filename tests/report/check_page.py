#!/usr/bin/env python3
"""Opens a report in a real browser, as wide as a phone and as a desk's screen, and looks at it: it
begins with the pictures of the techniques side by side, no image is broken, no text is cut, texts of
plots do not meet, a table shows that it scrolls, and every figure is the one in results.json.

Usage: check_page.py SAMPLE_REPORT         the program that writes a report of made-up figures
       check_page.py --measure LIMN SCENE  a small report of a scene, with a cache of its own
       check_page.py --folder FOLDER       a report that is there
"""
import base64
import http.server
import json
import math
import os
import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

SKIPPED = 77
BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")

# Runs in the page once two frames are drawn, because a scroll timeline says nothing before the first. It
# sends what the page is like to the server that the page came from.
PROBE = """
<script>
addEventListener('load', () => requestAnimationFrame(() => requestAnimationFrame(() => {
  const box = element => {
    const {left, top, right, bottom} = element.getBoundingClientRect();
    return [left, top, right, bottom];
  };
  // Texts beyond the page's sides, but for those of tables, which scroll.
  const cutTexts = () => {
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const cut = [];
    while (texts.nextNode()) {
      const text = texts.currentNode;
      const range = document.createRange();
      range.selectNodeContents(text);
      if (!text.parentElement.closest('.scroll, script') && [...range.getClientRects()].some(
          one => one.width > 0 && (one.left < 0 || one.right > innerWidth)))
        cut.push(text.textContent);
    }
    return cut;
  };
  const rows = part => [...part.rows].map(row => [...row.cells].map(cell => cell.textContent));
  const probe = {
    width: innerWidth,
    pageWidth: document.documentElement.scrollWidth,
    images: [...document.images].map(image => [image.alt, image.naturalWidth]),
    plots: [...document.querySelectorAll('.plot svg')].filter(svg => svg.clientWidth > 0)
        .map(svg => ({id: svg.parentNode.id, width: svg.getBoundingClientRect().width,
                      texts: [...svg.querySelectorAll('text')].map(text => [text.textContent.trim(), box(text)])
                          .filter(([text]) => text !== ''),
                      box: box(svg)})),
    order: ['.tiles', '.recommendation', 'nav', '.plot, table'].map(
        one => document.querySelector(one)?.getBoundingClientRect().top ?? -1),
    tiles: [...document.querySelectorAll('.tiles li')].map(tile => ({
      name: tile.querySelector('strong').textContent, picture: box(tile.querySelector('img')),
      lines: [...tile.querySelectorAll('span')].map(line => line.textContent),
      badges: [...tile.querySelectorAll('em')].map(badge => badge.textContent)})),
    scrolls: [...document.querySelectorAll('.scroll')].map(one => [
      one.querySelector('table').id, one.scrollWidth > one.clientWidth + 1,
      getComputedStyle(one, '::after').opacity]),
    cut: cutTexts(),
    tables: [...document.querySelectorAll('table')].map(table => ({
      id: table.id, head: rows(table.tHead)[0], rows: rows(table.tBodies[0]),
      marked: [...table.tBodies[0].rows].map(row => row.className === 'marked')})),
  };
  fetch('/probe', {method: 'POST', body: JSON.stringify(probe)});
})));
</script>
"""


def serve(page, answers):
    """Serves that page at a free port of this machine, and puts into the queue what its probe sends."""
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            self.answer("text/html; charset=utf-8", page.encode())

        def do_POST(self):
            probe = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            self.answer("text/plain", b"")
            answers.put(probe)  # The browser is stopped upon this.

        def answer(self, kind, body):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_):
            pass

    return http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)


def look(browser, page, width, folder):
    """What the page is like in a window of that width."""
    answers = queue.Queue()
    environment = {k: v for k, v in os.environ.items() if k != "LD_PRELOAD"}
    with serve(page.replace("</body>", PROBE + "</body>"), answers) as server, \
            open(os.path.join(folder, "browser.log"), "w+", encoding="utf-8") as log:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        run = subprocess.Popen(
            [browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--no-first-run", "--no-proxy-server", "--user-data-dir=" + os.path.join(folder, "profile"),
             f"--window-size={width},900", "--remote-debugging-port=0",  # which keeps it open
             f"http://127.0.0.1:{server.server_port}/"],
            stdout=log, stderr=log, env=environment, start_new_session=True)
        try:
            return answers.get(timeout=240)
        except queue.Empty:
            log.seek(0)
            sys.exit(f"{browser} shows no page:\n{log.read()[-2000:]}")
        finally:
            os.killpg(run.pid, signal.SIGTERM)  # The program may be a script around the browser.
            run.wait()
            server.shutdown()


def figure(text):
    """A figure as a table has it; None where there is none."""
    special = {"–": None, "NaN": math.nan, "infinite": math.inf, "-infinite": -math.inf}
    return special[text] if text in special else float(text)


def exact(value):
    return float(value) if isinstance(value, str) else value  # "nan", "inf"


def is_same(shown, wanted):
    """Whether that is the figure, rounded to what a reader is shown."""
    if shown is None or wanted is None:
        return shown is None and wanted is None
    if math.isnan(shown) or math.isnan(wanted):
        return math.isnan(shown) and math.isnan(wanted)
    if math.isinf(shown) or math.isinf(wanted) or wanted == 0:
        return shown == wanted
    return abs(shown - wanted) <= abs(wanted) * (0.051 if abs(wanted) < 1e-4 else 0.0051)


def check_cells(table, results, problems):
    """A table whose rows are cells. Returns how many figures it has."""
    metrics = {metric["title"] + (" " + unit if unit else ""): (metric["key"], factor)
               for metric in results["metrics"]
               for unit, factor in [("MiB", 2.0 ** -20) if metric["unit"] == "bytes"
                                    else (metric["unit"], 1.0)]}
    unused = list(results["cells"])
    count = 0
    for row in table["rows"]:
        shown = dict(zip(table["head"], row))

        def is_row(cell):
            what = cell["id"]
            return (what["technique"] == shown["technique"] and what["subject"] == shown["of"]
                    and is_same(figure(shown["width px"]), exact(what["width"]))
                    and f"{what['size'][0]}x{what['size'][1]}" == shown["picture"]
                    and what["variant"] == shown.get("with", what["variant"])
                    and {metrics[title][0] for title in shown
                         if title in metrics and shown[title] != "–"} == set(cell["values"]))
        cells = [cell for cell in unused if is_row(cell)]
        if not cells:
            problems.append(f"{table['id']}: no cell is like {row}")
            continue
        unused.remove(cells[0])
        for title, text in shown.items():
            if title in metrics:
                key, factor = metrics[title]
                value = cells[0]["values"].get(key)
                wanted = None if value is None else exact(value) * factor
                count += 1
                if not is_same(figure(text), wanted):
                    problems.append(f"{table['id']}: {title} of {row[0]} is {text}, "
                                    f"measured was {wanted}")
    return count


def measured(results, technique):
    """Its time, its error where techniques are compared, and whether the time is known."""
    at = results["comparison"]
    def values(kind, key, size, subject):
        return [exact(cell["values"][key]) for cell in results["cells"]
                for what in [cell["id"]]
                if what["kind"] == kind and what["technique"] == technique
                and what["variant"] == "" and what["width"] == at["width"]
                and key in cell["values"] and size in (None, what["size"])
                and subject in (None, what["subject"])]
    def median(numbers):
        numbers = sorted(numbers)
        if not numbers:
            return None
        half = len(numbers) // 2
        return numbers[half] if len(numbers) % 2 else (numbers[half - 1] + numbers[half]) / 2
    time = median(values("cost", "gpuAddedMilliseconds", at["size"], None))
    bound = median(values("cost", "gpuAddedUncertainty", at["size"], None))
    return (time, median(values("geometry", "meanAbsoluteError", None,
                                "scene" if at["errorOf"] == "scene" else None)),
            None not in (time, bound) and time - bound > 0)


def check_front(table, results, problems):
    """All techniques, and which of them are marked: of those whose time is known."""
    points = {row[0]: measured(results, row[0]) for row in table["rows"]}
    def is_beaten(name):
        if any(value is None or not math.isfinite(value) for value in points[name]):
            return True
        time, error, is_known = points[name]
        return not is_known or any(
            None not in point and point[2] and math.isfinite(point[1]) and point[0] <= time
            and point[1] <= error and point[:2] != (time, error) for point in points.values())
    for row, marked in zip(table["rows"], table["marked"]):
        time, error, _ = points[row[0]]
        shown = dict(zip(table["head"], row))
        if not is_same(figure(shown["GPU time added ms"]), time):
            problems.append(f"techniques: the time of {row[0]} is not {time}")
        if not is_same(figure(shown["mean error"]), error):
            problems.append(f"techniques: the error of {row[0]} is not {error}")
        if marked == is_beaten(row[0]):
            problems.append(f"techniques: {row[0]} is {'' if marked else 'not '}on the front")
    return 2 * len(points)


def overlap(a, b):
    """The part of the smaller box that the other one covers."""
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    area = min((one[2] - one[0]) * (one[3] - one[1]) for one in (a, b))
    return width * height / area if width > 0 and height > 0 and area > 0 else 0


def check_plot(plot, width, problems):
    """Its texts lie within it and do not meet, and it says how its axes are to be read."""
    name, texts = plot["id"], plot["texts"]
    if plot["width"] > width or len(texts) < 5:
        problems.append(f"the plot {name} is {plot['width']} px wide and has {len(texts)} texts")
    for i, (text, box) in enumerate(texts):
        if overlap(box, plot["box"]) < 0.99:
            problems.append(f"the plot {name} cuts '{text}'")
        problems += [f"the plot {name} has '{text}' on '{other}'"
                     for other, place in texts[:i] if overlap(box, place) > 0.1]
    words = [text for text, _ in texts]
    if sum(text.endswith("(logarithmic)") for text in words) != 2:
        problems.append(f"the plot {name} does not say that its axes are logarithmic")
    if ("better" in words) != (name in ("error_time", "flicker_time")):
        problems.append(f"the plot {name} does not mark what is better where it can be")


def check_tiles(probe, results, problems):
    """The pictures that the page begins with. Returns how many figures they have."""
    if probe["order"] != sorted(probe["order"]) or probe["order"][0] < 0:
        problems.append(f"pictures, answer, links and figures stand at {probe['order']}")
    boxes = [tile["picture"] for tile in probe["tiles"]]
    if len(boxes) < 2 or boxes[0][1] != boxes[1][1]:
        problems.append("no two techniques stand side by side")
    articles = {one["name"] for one in results["techniques"] if one["isArticle"]}
    count = 0
    for tile in probe["tiles"]:
        name, (error, time) = tile["name"], tile["lines"]
        milliseconds, wanted, is_known = measured(results, name)
        shown = re.fullmatch(r"(\S+) ± \S+ ms", time)
        if bool(shown) != is_known or shown and not is_same(figure(shown[1]), milliseconds):
            problems.append(f"the picture of {name} has '{time}', measured was {milliseconds}")
        if wanted is not None and not is_same(figure(error.split()[-1]), wanted):
            problems.append(f"the picture of {name} has '{error}', measured was {wanted}")
        if ("article" in tile["badges"]) != (name in articles):
            problems.append(f"the picture of {name} has the marks {tile['badges']}")
        count += 2
    return count


def check(probe, width, results):
    """What is wrong with a page, and how many figures were compared."""
    problems = []
    if probe["width"] != width:
        problems.append(f"the window is {probe['width']} px wide, not {width}")
    if probe["pageWidth"] > width:
        problems.append(f"the page is {probe['pageWidth']} px wide in a window of {width}")
    problems += [f"the image '{alt}' is broken" for alt, size in probe["images"] if size == 0]
    problems += [f"the text '{text}' is cut" for text in probe["cut"]]
    problems += [f"the table {table} {'scrolls and does not show it' if scrolls else 'seems to scroll'}"
                 for table, scrolls, opacity in probe["scrolls"] if scrolls != (float(opacity) == 1)]
    for plot in probe["plots"]:
        check_plot(plot, width, problems)
    figures = check_tiles(probe, results, problems)
    for table in probe["tables"]:
        if table["head"][:2] == ["technique", "of"]:
            figures += check_cells(table, results, problems)
        elif table["id"] == "techniques":
            figures += check_front(table, results, problems)
    if figures == 0:
        problems.append("no figure was found")
    return problems, figures


def sabotaged(page):
    """The page with all the faults that are looked for."""
    page = page.replace("@keyframes more-columns", "@keyframes others").replace("better", "wider")
    image = re.search(r'src="data:image/png;base64,([^"]+)"', page).group(1)
    broken = base64.b64encode(base64.b64decode(image)[:20] + b"no picture").decode()
    page = page.replace(image, broken, 1)
    page = page.replace("<main>", '<main><div style="width: 500px; text-align: right">wide</div>', 1)
    table = page.index('<table id="costs">')
    cell = re.compile(r'<td class="number">(\d+\.\d+)</td>').search(page, table)
    return page[:cell.start(1)] + "1234" + page[cell.end(1):]


def measure(limn, scene, folder):
    """A report that is real and small. False if the machine has no device."""
    environment = dict(os.environ, XDG_CACHE_HOME=str(folder.parent / "cache"))
    run = subprocess.run([limn, "report", scene, "-o", folder, "--quick", "--size", "96x54",
                          "--technique", "Strokes", "--technique", "Screen space"],
                         stdout=subprocess.DEVNULL, env=environment)
    if run.returncode not in (0, 3):
        sys.exit(f"limn report ends with {run.returncode}")
    return run.returncode == 0


def main():
    browser = next((found for found in map(shutil.which, BROWSERS) if found), None)
    if browser is None:
        print("there is no Chromium: apt install chromium-headless-shell")
        return 1 if os.environ.get("LIMN_REQUIRE_DEVICE") else SKIPPED
    with tempfile.TemporaryDirectory(prefix="limn-page-") as temporary:
        folder = pathlib.Path(temporary) / "report"
        if sys.argv[1] == "--folder":
            folder = pathlib.Path(sys.argv[2])
        elif sys.argv[1] == "--measure":
            if not measure(sys.argv[2], sys.argv[3], folder):
                return 1 if os.environ.get("LIMN_REQUIRE_DEVICE") else SKIPPED
        else:
            subprocess.run([sys.argv[1], folder], check=True, stdout=subprocess.DEVNULL)
        page = (folder / "report.html").read_text(encoding="utf-8")
        results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
        failed = False
        for width in (360, 390, 1200):
            probe = look(browser, page, width, temporary)
            problems, figures = check(probe, width, results)
            print(f"{width} px: {figures} figures, {len(probe['images'])} images, "
                  f"{len(probe['plots'])} plots, {len(problems)} problems")
            for problem in problems:
                print("  " + problem)
            failed |= bool(problems)
        if len(sys.argv) == 2:  # what is looked for is found where it is
            problems, _ = check(look(browser, sabotaged(page), 360, temporary), 360, results)
            for wanted in ("is broken", "px wide in a window of 360", "is 1234, measured was",
                           "'wide' is cut", "does not show it", "does not mark what is better"):
                if not any(wanted in problem for problem in problems):
                    print(f"a page with faults passes: nothing '{wanted}' in {problems}")
                    failed = True
        return int(failed)


if __name__ == "__main__":
    sys.exit(main())
