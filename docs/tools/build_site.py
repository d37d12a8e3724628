"""Builds the pages of docs/ into a folder of plain HTML that a browser opens without a network.

    python3 build_site.py FOLDER [VERSION]

Pandoc makes the pages. The order of the pages is that of the links on index.md.
"""

import html
import json
import pathlib
import re
import shutil
import subprocess
import sys

import blocks

DOCS = blocks.ROOT / "docs"
SITE = DOCS / "site"
PICTURES = "../assets/pictures/"
PAGE_LINK = re.compile(r"\]\((\w+)\.md\)")


def page_names():
    index = (DOCS / "index.md").read_text(encoding="utf-8")
    named = ["index", *dict.fromkeys(PAGE_LINK.findall(index))]
    left_out = {page.stem for page in DOCS.glob("*.md")} - set(named)
    if left_out:
        sys.exit(f"docs: index.md has no link to {', '.join(sorted(left_out))}")
    return named


def title(name):
    lines = blocks.read(DOCS / f"{name}.md")
    return lines[0].removeprefix("# ").replace("`", "")


def navigation(names, here):
    items = (f'<li><a href="{name}.html"{" aria-current=page" if name == here else ""}>'
             f"{html.escape(title(name))}</a></li>" for name in names)
    return "<ul>" + "".join(items) + "</ul>"


def linked(text):
    """Links between pages lead to pages of the site, pictures are beside them, sources are only named."""
    text = re.sub(r'href="(\w+)\.md(#[^"]*)?"', r'href="\1.html\2"', text)
    text = re.sub(r'<a href="\.\./[^"]*">(.*?)</a>', r"\1", text, flags=re.DOTALL)
    return text.replace(f'src="{PICTURES}', 'src="pictures/')


def page(name, names, version):
    done = subprocess.run(
        ["pandoc", "--from", "gfm", "--to", "html5", "--template", str(SITE / "template.html"), "--no-highlight",
         "--toc", "--toc-depth", "2", "--wrap", "preserve", "--fail-if-warnings",
         "--metadata", f"title={title(name)}", "--variable", f"navigation={navigation(names, name)}",
         "--variable", f"version={version}", str(DOCS / f"{name}.md")],
        capture_output=True, text=True, check=False)
    if done.returncode != 0 or done.stderr:
        sys.exit(f"docs: {name}.md: {done.stderr}")
    return linked(done.stdout)


def sections(name, text):
    """What the search finds: the words below each heading of a page."""
    body = text[text.index("<main"):text.index("</main>")]
    parts = re.split(r'<h[1-6] id="([^"]*)">(.*?)</h[1-6]>', body, flags=re.DOTALL)
    for anchor, heading, rest in zip(parts[1::3], parts[2::3], parts[3::3]):
        words = [html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", each))).strip() for each in (heading, rest)]
        yield {"page": f"{name}.html", "anchor": anchor, "heading": words[0], "text": words[1]}


def main(folder, version=""):
    target = pathlib.Path(folder)
    shutil.rmtree(target, ignore_errors=True)
    (target / "pictures").mkdir(parents=True)
    names, found = page_names(), []
    for name in names:
        text = page(name, names, version)
        (target / f"{name}.html").write_text(text, encoding="utf-8")
        found += sections(name, text)
        for picture in re.findall(r'src="pictures/([^"]+)"', text):
            shutil.copyfile(DOCS / PICTURES / picture, target / "pictures" / picture)
    # A script, since a page that is opened from a file may not read others.
    (target / "search_index.js").write_text(
        f"const sections = {json.dumps(found, ensure_ascii=False)};\n", encoding="utf-8")
    for name in ("style.css", "search.js"):
        shutil.copyfile(SITE / name, target / name)


if __name__ == "__main__":
    main(*sys.argv[1:])
