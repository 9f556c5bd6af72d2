"""The site's menu, which is that of docs/README.md, and links: to the page in the book's chapters, and to files beside `docs/`."""

import os
import posixpath
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)")


def anchor(heading: str, _separator: str) -> str:
    """The anchor of a heading on a git host."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """One section for each heading, with every page that its table links to and no section before has."""
    config.mdx_configs["toc"] = {"slugify": anchor}
    listed = {"README.md"}
    config.nav = [{"All pages": "README.md"}]
    for section in (Path(config.docs_dir) / "README.md").read_text().split("\n## ")[1:]:
        heading, text = section.split("\n", 1)
        pages = []
        for _, to in LINK.findall(text):
            if to.endswith(".md") and not to.startswith("..") and to not in listed:
                listed.add(to)
                pages.append(to)
        if pages:
            config.nav.append({heading: pages})
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The page that web/build.sh made stands beside the chapters that embed it."""
    files.append(File.generated(config, "book/chapters/touch.html", abs_src_path=os.environ["LYAPUNOV_PAGE"]))
    return files


def on_page_markdown(markdown: str, *, page: Page, **_: object) -> str:
    """A link to a file that has no page names the file."""

    def named(found: re.Match[str]) -> str:
        text, to = found.groups()
        file = posixpath.normpath(posixpath.join(posixpath.dirname(page.file.src_uri), to))
        if not file.startswith("../"):
            return found.group()
        file = file.removeprefix("../")
        return f"`{file}`" if text == file else f"{text} (`{file}`)"

    return LINK.sub(named, markdown)
