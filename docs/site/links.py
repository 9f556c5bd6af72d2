"""The site's menu, which is that of docs/README.md, and links to files beside `docs/`, which have no page."""

import posixpath
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.pages import Page

LINK = re.compile(r"(?<!!)\[([^\]\n]+)\]\(([^)\s]+)\)")


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """One section for each heading, with every page that its table links to and no section before has."""
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


def on_page_markdown(markdown: str, *, page: Page, **_: object) -> str:
    """A link to a file that has no page names the file."""

    def named(found: re.Match[str]) -> str:
        text, to = found.groups()
        file = posixpath.normpath(posixpath.join(posixpath.dirname(page.file.src_uri), to))
        return f"{text} (`{file.removeprefix('../')}`)" if file.startswith("../") else found.group()

    return LINK.sub(named, markdown)
