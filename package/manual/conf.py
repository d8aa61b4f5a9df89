"""The manual as a browsable site: the repository's own pages, as they are (target `manual`)."""

project = "twinwake"
copyright = "2026, the twinwake authors"
extensions = ["myst_parser"]
myst_heading_anchors = 4
source_suffix = {".md": "markdown"}
root_doc = "docs/README"
include_patterns = ["*.md", "*/*.md", "docs/**/*.md", "tests/data/README.md"]
exclude_patterns = ["build*", "runs", ".openfoam", "package"]
html_theme = "sphinx_rtd_theme"

# What stands in the side bar, in this order; all other pages are found through these.
chapters = {
    "Using twinwake": ["README", "docs/tutorial", "docs/questions", "scene/README", "docs/scene_reference", "studies/README", "meshes/README",
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


def setup(app):
    app.connect("source-read", add_side_bar)
