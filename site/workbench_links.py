"""Addresses that open a problem in the workbench, as web/src/shell/share.ts makes and reads them."""

import base64
import json
import re
import zlib

COMMENT = re.compile(r'("(?:\\.|[^"\\])*")|//[^\n]*')


def without_comments(text):
    """JSON text without // comments outside of its strings."""
    return COMMENT.sub(lambda match: match.group(1) or "", text)


def problem_of(text):
    """The problem in a text; None where it holds something else."""
    try:
        content = json.loads(without_comments(text))
    except ValueError:
        return None
    return content if isinstance(content, dict) and "task" in content else None


def fragment_of(problem):
    """#1.<CRC-32 of the data>.<data>, data = base64url of the deflated text."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    packed = deflate.compress(json.dumps(problem, ensure_ascii=False, separators=(",", ":")).encode()) + deflate.flush()
    data = base64.urlsafe_b64encode(packed).decode().rstrip("=")
    return f"#1.{zlib.crc32(data.encode()):08x}.{data}"


def open_link(problem, to_root, words="Open in the workbench"):
    """The link as HTML, on a page from which the site's root is at `to_root` ("", "../")."""
    return f'<a class="open-in-workbench" href="{to_root}workbench/index.html{fragment_of(problem)}">{words}</a>'
