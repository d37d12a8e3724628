"""What notebooks show of parts and regions."""

import html
import os

from ._core import Classification, Error, Part


def _part_table(self):
    health = self.health
    lows, highs = health.bounds
    unit = f" {self.unit}" if self.unit else ""
    size = " × ".join(f"{high - low:.4g}" for low, high in zip(lows, highs))
    rows = [("File", os.path.basename(self.file) or "arrays"), ("Format", self.format), ("Facets", f"{health.facets:,}"),
            ("Closed", "yes" if health.closed else "no"), ("Size", size + unit),
            ("Area", f"{health.area:.5g}{unit and unit + '²'}"), ("Volume", f"{health.volume:.5g}{unit and unit + '³'}")]
    rows += [("Warning", warning) for warning in self.warnings]
    cells = (f"<tr><th>{name}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)
    return f"<table>{''.join(cells)}</table>"


def _page(self):
    # Scripts alone: the page needs nothing else, and nothing of the notebook.
    try:
        page = self.to_html()
    except Error:
        return None  # without OpenGL; the notebook shows the text
    return (f'<iframe srcdoc="{html.escape(page)}" sandbox="allow-scripts" width="100%" height="700" '
            'style="border: 0"></iframe>')


def _picture(self):
    try:
        return self._png()
    except Error:
        return None


Part._repr_html_ = _part_table
Classification._repr_html_ = _page
Classification._repr_png_ = _picture
