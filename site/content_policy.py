"""A content security policy in every page of the site: nothing is loaded from elsewhere, and no script runs that the page
did not have when it was built."""

import base64
import hashlib
import re

INLINE = re.compile(r"<script(?![^>]*\b(?:src|type=\"application/json\"))[^>]*>(.*?)</script>", re.DOTALL)
HEAD = re.compile(r"<head>")


def digest_of(script):
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def policy_of(html):
    scripts = " ".join(["'self'", *sorted({digest_of(script) for script in INLINE.findall(html)})])
    return (f"default-src 'none'; script-src {scripts}; style-src 'self' 'unsafe-inline'; img-src 'self' data:; font-src 'self'; "
            "connect-src 'self'; worker-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'")


def with_policy(html):
    meta = f'<head>\n    <meta http-equiv="Content-Security-Policy" content="{policy_of(html)}">\n    <meta name="referrer" content="no-referrer">'
    return HEAD.sub(lambda _: meta, html, count=1)
