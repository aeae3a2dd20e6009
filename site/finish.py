#!/usr/bin/python3
"""What build/site gets after its pages: a search that knows Chinese, the workbench, a content security policy in every page.
usage: site/finish.py"""

import shutil
from pathlib import Path

from content_policy import with_policy
from installable import make_installable

ROOT = Path(__file__).resolve().parents[1]
SITE = ROOT / "build/site"
# For the root of one server only, or for those who work on the theme.
NEEDLESS = ("404.html", "sitemap.xml", "sitemap.xml.gz", "assets/**/*.map")


def teach_chinese():
    """Puts our search where the theme looks for its own."""
    workers = SITE / "assets/javascripts/workers"
    theme, = workers.glob("search.*.min.js")
    theme.rename(workers / "theme_search.js")
    shutil.copy(ROOT / "site/search.js", theme)


def main():
    for pattern in NEEDLESS:
        for path in SITE.glob(pattern):
            path.unlink()
    teach_chinese()
    for page in SITE.rglob("*.html"):
        page.write_text(with_policy(page.read_text(encoding="utf-8")), encoding="utf-8")
    shutil.copytree(ROOT / "build/web", SITE / "workbench", dirs_exist_ok=True)
    make_installable(SITE / "workbench", ROOT / "site")


if __name__ == "__main__":
    main()
