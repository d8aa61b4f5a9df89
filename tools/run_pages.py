"""What the tools share that make parts of pages from run records (cost_of_accuracy.py, predictions.py, gallery.py)."""
import sys

methods = {"sph": "SPH", "fvm": "interFoam"}  # as pages call them


def is_member_of_another_kind(path):
    """Whether a folder above the record is that of a member of a study with another box or another number."""
    return any(part.startswith("box_") or part.endswith(("_low", "_high")) for part in path.parts)


def put_between(page, begin, end, text):
    """Replaces what is in the page between the line `begin` and the next `end`. Exits in words where they are missing."""
    before, found, rest = page.read_text(encoding="utf-8").partition(begin + "\n")
    _, closed, after = rest.partition(end)
    if not found or not closed:
        sys.exit(f"{page}: expected the lines {begin} and {end}")
    page.write_text(before + found + text + closed + after, encoding="utf-8")
