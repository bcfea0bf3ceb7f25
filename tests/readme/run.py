#!/usr/bin/env python3
"""Runs the commands of a page of Markdown in an empty folder, and compares what they print and draw
with what the page shows.

usage: run.py REPOSITORY BUILD_TREE PAGE        (PAGE: from the repository, e.g. samples/guide/frame.md)
       run.py REPOSITORY --links                (checks the links of all pages and runs nothing)

How a page is written:

* The blocks marked sh run in their order, as one bash script, with `limn` on the PATH. A block marked
  "sh fails" must fail. The pages of IN_LIMNS_FOLDER run in a folder that has samples/, features/ and
  the program at its place, as limn's own folder; all others begin in an empty one.
* A block behind a line that is `FILE`: (in those quotes) is written to that file. Behind `FILE`, added
  at its end: it is appended.
* A block marked text without such a line is what the sh block before it prints, on both streams. There,
  … stands for anything within a line, and a line that is … for any lines.
* A block marked yaml behind a line that links a .yaml file quotes that file.
* Each picture that a page shows is compared with the one that its commands drew under the same name,
  in the folder itself or in out/; of an SVG only the words, because fonts differ.
* Links to files and headings must lead somewhere, and a guide has at most 140 lines.

LIMN_UPDATE_GOLDEN=1 writes what was printed and drawn into the page and its pictures: look at both.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from png import difference

IN_LIMNS_FOLDER = ("README.md", "samples/selection/README.md", "samples/guide/commands.md",
                   "samples/guide/testing.md")
# Written by CI and by whoever clones limn, not here.
NOT_RUN = ("samples/run.sh", "tests/run.sh")
MOST_BYTES_OF_README = 10_000
MOST_LINES_OF_GUIDE = 140
MARK = "\x01"


class Block:
    """A fenced block: its language, the line before it, its text and where that stands."""

    def __init__(self, language, before, first_line, lines):
        self.language, self.before, self.first_line, self.lines = language, before, first_line, lines
        name = re.fullmatch(r"`([^`]+)`(, added at its end)?:", before)
        self.file = name and name[1]
        self.is_added = bool(name and name[2])
        self.text = "".join(line + "\n" for line in lines)


def blocks_of(text):
    blocks, before, inside = [], "", None
    for number, line in enumerate(text.split("\n")):
        if line.startswith("```"):
            if inside is None:
                inside = Block(line[3:], before, number + 1, [])
            else:
                blocks.append(Block(inside.language, inside.before, inside.first_line, inside.lines))
                before, inside = "", None
        elif inside is not None:
            inside.lines.append(line)
        elif line.strip():
            before = line
    return blocks


def script_of(blocks, folder):
    """One bash script of all blocks; what block N prints stands behind a mark with its number."""
    script = ["set -euo pipefail", "shopt -s expand_aliases", "exec 2>&1"]
    for number, block in enumerate(blocks):
        if block.file:
            source = folder / ".blocks" / str(number)
            source.parent.mkdir(exist_ok=True)
            source.write_text(block.text)
            script.append(f"cat '{source}' {'>>' if block.is_added else '>'} '{block.file}'")
        elif block.language == "sh" and not block.text.startswith(NOT_RUN):
            script += [f"printf '{MARK}{number}\\n'", block.text]
        elif block.language == "sh fails":
            script += [f"printf '{MARK}{number}\\n'", f"if (\n{block.text}); then",
                       "echo 'this should have failed'; exit 1", "fi"]
    return "\n".join(script) + "\n"


def matches(expected, printed):
    """Whether lines are those of the page, where … stands for anything."""
    pattern = ""
    for line in expected:
        pattern += r"(.*\n)*" if line.strip() == "…" else ".*".join(map(re.escape, line.split("…"))) + r"\n"
    return re.fullmatch(pattern, "".join(line + "\n" for line in printed)) is not None


def look_alike(drawn, shown):
    if shown.suffix == ".svg":
        words = [re.findall(r"<text[^>]*>([^<]*)</text>", file.read_text()) for file in (drawn, shown)]
        return len(words[0]) > 0 and words[0] == words[1]
    return difference(drawn, shown) <= 1


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


class Page:
    def __init__(self, repository, build, name):
        self.repository, self.build, self.name = repository.resolve(), build.resolve(), name
        self.path = self.repository / name
        self.text = self.path.read_text()
        self.blocks = blocks_of(self.text)
        self.updates = os.environ.get("LIMN_UPDATE_GOLDEN") is not None
        self.problems = []

    def fail(self, line, what):
        self.problems.append(f"{self.name}:{line}: {what}")

    def check_size(self):
        if self.name == "README.md" and len(self.text.encode()) > MOST_BYTES_OF_README:
            self.fail(1, f"the page has {len(self.text.encode())} bytes, more than {MOST_BYTES_OF_README}")
        lines = self.text.count("\n")
        if self.name.startswith("samples/guide/") and "reference" not in self.name and lines > MOST_LINES_OF_GUIDE:
            self.fail(1, f"the page has {lines} lines, more than {MOST_LINES_OF_GUIDE}")

    def check_links(self):
        for number, line in enumerate(self.text.split("\n"), 1):
            for link in re.findall(r"\]\(([^)\s]+)\)", line):
                if "://" in link:
                    continue
                file, _, heading = link.partition("#")
                target = (self.path.parent / file) if file else self.path
                if not target.exists():
                    self.fail(number, f"the link to {link} leads nowhere")
                elif heading:
                    page = target / "README.md" if target.is_dir() else target
                    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
                    if heading not in map(slug, headings):
                        self.fail(number, f"{link} has no such heading")

    def check_quotes(self):
        """Of blocks of YAML that quote a file."""
        for block in self.blocks:
            link = re.search(r"\]\(([^)]+\.yaml)\)", block.before)
            if block.language != "yaml" or not link:
                continue
            quoted = (self.path.parent / link[1]).read_text()
            known = {line.strip() for line in quoted.split("\n")}
            for line in block.lines:
                if line.strip() not in known:
                    self.fail(block.first_line, f"'{line}' is not in the file that is linked before it")

    def check_first_commands(self):
        shown = tuple(line.split()[0] for line in self.blocks[0].lines)
        if shown != NOT_RUN:
            self.fail(self.blocks[0].first_line, f"the first commands are not {NOT_RUN}")

    def run(self, folder):
        work, home = folder / "work", folder / "home"
        for made in (work, home, folder / "bin"):
            made.mkdir()
        program = self.build / "editor_stub/limn"
        environment = dict(os.environ, XDG_CACHE_HOME=str(home), LC_ALL="C.UTF-8", NO_COLOR="1", COLUMNS="80")
        if any("find_package" in block.text or "cmake " in block.text for block in self.blocks):
            subprocess.run(["cmake", "--install", self.build, "--prefix", folder / "prefix"],
                           check=True, stdout=subprocess.DEVNULL)
            environment["CMAKE_PREFIX_PATH"] = str(folder / "prefix")
            program = folder / "prefix/bin/limn"
        (folder / "bin/limn").symlink_to(program)
        environment["PATH"] = f"{folder / 'bin'}:{environment['PATH']}"
        if self.name in IN_LIMNS_FOLDER:
            for linked in ("samples", "features"):
                (work / linked).symlink_to(self.repository / linked)
            (work / "build/release/editor_stub").mkdir(parents=True)
            (work / "build/release/editor_stub/limn").symlink_to(program)
            (work / "out").mkdir()
        ran = subprocess.run(["bash", "-c", script_of(self.blocks, folder)], cwd=work, text=True,
                             env=environment, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL)
        printed, number = {}, None
        for part in ran.stdout.split(MARK)[1:]:
            number, _, output = part.partition("\n")
            printed[int(number)] = output.splitlines()
        if ran.returncode != 0:
            where = 1 if number is None else self.blocks[int(number)].first_line + 1
            self.fail(where, "a command fails, having printed\n" + ran.stdout[-3000:])
            return
        self.compare_texts(printed)
        self.compare_pictures(work)

    def compare_texts(self, printed):
        lines = self.text.split("\n")
        last = None
        replaced = []
        for number, block in enumerate(self.blocks):
            if number in printed:
                last = number
            elif block.language == "text" and not block.file:
                if last is None:
                    self.fail(block.first_line, "no command before this text prints it")
                elif not matches(block.lines, printed[last]):
                    said = "\n".join(printed[last])
                    self.fail(block.first_line + 1, "the commands before it print\n" + said)
                    replaced.append((block, printed[last]))
        if self.updates and replaced:
            for block, output in reversed(replaced):
                lines[block.first_line : block.first_line + len(block.lines)] = output
            self.path.write_text("\n".join(lines))

    def compare_pictures(self, work):
        for folder, name in re.findall(r"!\[[^\]]*\]\(([^)]*/)([^)/]+\.(?:png|svg))\)", self.text):
            shown = self.path.parent / folder / name
            drawn = [file for file in (work / name, work / "out" / name) if file.exists()]
            if not drawn:
                self.fail(1, f"no command draws {name}")
            elif not shown.exists() or not look_alike(drawn[0], shown):
                self.fail(1, f"{name} is drawn otherwise than the page shows it")
                if self.updates:
                    shown.parent.mkdir(exist_ok=True)
                    shutil.copy(drawn[0], shown)


def check_all_links(repository):
    problems = []
    for folder in [repository, *(entry for entry in repository.iterdir() if entry.is_dir())]:
        if folder.name in ("build", "out", ".git"):
            continue
        for path in folder.glob("*.md") if folder == repository else folder.rglob("*.md"):
            page = Page(repository, repository, str(path.relative_to(repository)))
            page.check_links()
            problems += page.problems
    if problems:
        sys.exit("\n".join(problems))


def main():
    if sys.argv[2] == "--links":
        return check_all_links(pathlib.Path(sys.argv[1]))
    repository, build, name = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    page = Page(repository, build, name)
    page.check_size()
    page.check_quotes()
    if name == "README.md":
        page.check_first_commands()
    with tempfile.TemporaryDirectory() as folder:
        page.run(pathlib.Path(folder))
    if page.problems:
        sys.exit("\n".join(page.problems))
    print(f"{name}: {len(page.blocks)} blocks hold")


if __name__ == "__main__":
    main()
