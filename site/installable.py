"""Makes a copy of the built workbench one that can be installed and works offline: manifest, icons, service worker."""

import hashlib
import json
import subprocess

MANIFEST = {
    "name": "Linkwright", "short_name": "Linkwright", "description": "Every linkage that does your task, on one map",
    "start_url": "./index.html", "scope": "./", "display": "standalone",
    "background_color": "#ffffff", "theme_color": "#1f5fbf",
    "icons": [
        {"src": "icon.svg", "sizes": "any", "type": "image/svg+xml"},
        {"src": "icon-192.png", "sizes": "192x192", "type": "image/png"},
        {"src": "icon-512.png", "sizes": "512x512", "type": "image/png"},
    ],
}
HEAD = ('    <link rel="manifest" href="./manifest.webmanifest" />\n    <meta name="theme-color" content="#1f5fbf" />\n'
        '    <link rel="apple-touch-icon" href="./icon-192.png" />\n    <script type="module" src="./register.js"></script>\n  </head>')


def draw_icons(folder):
    for size in (192, 512):
        subprocess.run(["rsvg-convert", "-w", str(size), "-h", str(size), "-b", "white", "-o", folder / f"icon-{size}.png",
                        folder / "icon.svg"], check=True)


def digest(folder, names):
    """Of all files with their names: another one with each change of any."""
    total = hashlib.sha256()
    for name in names:
        total.update(f"{name}\0".encode() + hashlib.sha256((folder / name).read_bytes()).digest())
    return total.hexdigest()[:16]


def make_installable(folder, sources):
    """`folder`: the copy. `sources`: that of register.js and service_worker.js."""
    page = folder / "index.html"
    page.write_text(page.read_text(encoding="utf-8").replace("  </head>", HEAD, 1), encoding="utf-8")
    draw_icons(folder)
    (folder / "manifest.webmanifest").write_text(json.dumps(MANIFEST, indent=2), encoding="utf-8")
    (folder / "register.js").write_text((sources / "register.js").read_text(encoding="utf-8"), encoding="utf-8")
    names = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    worker = (sources / "service_worker.js").read_text(encoding="utf-8")
    stored = {"VERSION": digest(folder, names), "FILES": names}
    for name, value in stored.items():
        worker = worker.replace(f"self.{name}", json.dumps(value), 1)
    (folder / "service_worker.js").write_text(worker, encoding="utf-8")
