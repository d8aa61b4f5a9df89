"""The manual as a browsable site: the repository's own pages, as they are (target `manual`)."""
import pathlib

project = "twinwake"
copyright = "2026, the twinwake authors"
extensions = ["myst_parser"]
myst_heading_anchors = 4
source_suffix = {".md": "markdown"}
root_doc = "docs/README"
include_patterns = ["*.md", "*/*.md", "docs/**/*.md", "tests/data/README.md"]
exclude_patterns = ["build*", "runs", ".openfoam", "package"]
html_theme = "sphinx_rtd_theme"
html_css_files = ["twinwake.css"]  # written below
html_theme_options = {"navigation_depth": 2}
# Lines of 120 columns, and of tables longer ones, stand as they are in the pages: the theme's column is too narrow for them.
page_style = """
.wy-nav-content { max-width: 1300px; }
.rst-content pre { white-space: pre-wrap; overflow-wrap: anywhere; }
.rst-content table.docutils td, .rst-content table.docutils th { white-space: normal; }
"""
start_page = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>twinwake: the manual</title>
<meta http-equiv="refresh" content="0; url=docs/README.html"></head>
<body><p><a href="docs/README.html">The manual of twinwake</a></p></body></html>
"""

# What stands in the side bar, in this order; all other pages are found through these.
chapters = {
    "Using twinwake": ["README", "docs/tutorial", "docs/questions", "scene/README", "docs/scene_reference", "studies/README", "docs/gallery", "meshes/README",
                       "import/README", "docs/PARAVIEW", "docs/python", "docs/record_columns", "docs/watching",
                       "docs/cluster"],
    "What is known": ["docs/theory", "docs/glossary", "docs/validation", "docs/stability", "docs/audit",
                      "docs/reliability", "docs/performance", "docs/limits", "docs/STATUS", "docs/decisions/README"],
    "Changing twinwake": ["docs/ARCHITECTURE", "CONTRIBUTING", "CHANGELOG"],
}


def add_side_bar(app, page, source):
    """Sphinx wants every page in a tree of contents, which the pages themselves do not have."""
    if page == root_doc:
        for caption, pages in chapters.items():
            source[0] += "\n```{toctree}\n:hidden:\n:caption: " + caption + "\n\n"
            source[0] += "".join(f"/{entry}\n" for entry in pages) + "```\n"
    elif page not in sum(chapters.values(), []):
        source[0] = "---\norphan: true\n---\n" + source[0]


def write_start_page(app, failure):
    """The contents are a page in docs/, as in the repository; whoever opens the folder gets there."""
    if failure is None and app.builder.format == "html":
        (pathlib.Path(app.outdir) / "index.html").write_text(start_page, encoding="utf-8")
        (pathlib.Path(app.outdir) / "_static/twinwake.css").write_text(page_style, encoding="utf-8")


def setup(app):
    app.connect("source-read", add_side_bar)
    app.connect("build-finished", write_start_page)
