"""The plain static server that the pages are opened from, and what their files weigh."""

import gzip
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from urllib.parse import unquote, urlsplit


class Quiet(SimpleHTTPRequestHandler):
    """Says nothing of each request, and has no icon."""

    def do_GET(self) -> None:
        if self.path == "/favicon.ico":  # which browsers ask every server for, without being told to
            self.send_response(204)
            self.end_headers()
        else:
            super().do_GET()

    def log_message(self, format: str, *args: object) -> None:
        pass


@contextmanager
def serve(folder: Path) -> Iterator[str]:
    """Serve a folder on this machine alone, at a free port; the address, ending in a slash."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()


def is_local(address: str, base: str) -> bool:
    """Whether an address is the site's own, or is no request at all.

    >>> is_local("http://127.0.0.1:80/a.css", "http://127.0.0.1:80/"), is_local("data:,x", "file:///")
    (True, True)
    >>> is_local("http://127.0.0.1.example.org/", "http://127.0.0.1:80/")
    False
    """
    return address.startswith((base, "data:", "blob:", "about:"))


def file_of(address: str, base: str, folder: Path) -> Path:
    """The file behind an address of the site."""
    path = folder / unquote(urlsplit(address).path.removeprefix(urlsplit(base).path))
    return path / "index.html" if path.is_dir() else path


@cache
def weight(path: Path) -> int:
    """How many bytes a file has when it is compressed as servers do; what is no file weighs nothing."""
    return len(gzip.compress(path.read_bytes(), 6)) if path.is_file() else 0
