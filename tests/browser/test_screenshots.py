"""A picture of every page in every mode, and a page that shows them all."""

import asyncio
from pathlib import Path

import pytest
import screenshots
from browse_chromium import ABSENT, find_chromium
from pdf_pages import Chapter
from PIL import Image

PAGE = """<!doctype html><html><head><meta name="viewport" content="width=device-width"><style>
html[data-theme="dark"] { background: #000 }</style></head><body style="height: 2000px">Words</body></html>"""


@pytest.mark.skipif(find_chromium() is None, reason=ABSENT)
def test_each_mode_has_a_picture_of_the_whole_page(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "one.html").write_text(PAGE)
    number = asyncio.run(screenshots.take_all(tmp_path, [Chapter("a/one")], tmp_path, workers=2))
    assert number == len(screenshots.MODES) == 4
    for mode in screenshots.MODES:
        with Image.open(tmp_path / f"a-one.{mode}.png") as picture:
            assert picture.width == (1366 if "wide" in mode else 375)
            assert picture.height >= 2000
            red, green, blue = picture.convert("RGB").getpixel((300, 1500))
            assert (red + green + blue == 0) == ("dark" in mode)


def test_all_pictures_are_shown() -> None:
    text = screenshots.contact_sheet([Chapter("index"), Chapter("a/one")])
    assert text.count("<img ") == 2 * len(screenshots.MODES)
    assert 'href="a-one.phone-dark.png"' in text
