# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON with long lists: the same content and the same text as of `json`, and never a whole list in memory."""

from __future__ import annotations

import json
import tracemalloc
from unittest.mock import patch

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from CNCStepper.control.program import long_json
from CNCStepper.control.program.long_json import LONG, LongList, pieces, read_long

CANONICAL = {"sort_keys": True, "separators": (",", ":")}
numbers = st.integers() | st.floats(allow_nan=False, allow_infinity=False)
long_lists = st.lists(st.text(max_size=12)) | st.lists(numbers)
values = st.recursive(
    st.none() | st.booleans() | numbers | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)
sends = st.fixed_dictionaries(
    dict.fromkeys(LONG, long_lists), optional={"restart_of": st.dictionaries(st.sampled_from(LONG), values)}
)
contents = st.fixed_dictionaries(
    {"send": sends, "other": st.dictionaries(st.sampled_from(LONG), values) | values},
    optional={"lines": long_lists, "é": values},
)


def plain(content):
    """Return content with its long lists as lists."""
    if isinstance(content, LongList):
        assert len(content) == len(list(content))
        return list(content)
    return {key: plain(value) for key, value in content.items()} if isinstance(content, dict) else content


@pytest.mark.slow
@given(content=contents, indent=st.sampled_from([None, 1]), is_ascii=st.booleans(), block=st.integers(1, 40))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_content_and_text_are_those_of_json(tmp_path, content, indent, is_ascii, block):
    file = tmp_path / "a job ç.json"
    file.write_text(json.dumps(content, indent=indent, ensure_ascii=is_ascii), "utf-8")
    with patch.multiple(long_json, BLOCK_BYTES=block, BLOCK_ITEMS=block), open(file, "rb") as opened:
        read = read_long(opened)
        assert plain(read) == content
        assert "".join(pieces(read, json.JSONEncoder(**CANONICAL))) == json.dumps(content, **CANONICAL)
        assert json.loads("".join(pieces(read, json.JSONEncoder()))) == content


def test_a_list_of_that_name_elsewhere_is_read_as_it_is(tmp_path):
    file = tmp_path / "restart.json"
    content = {"send": {"lines": ["G0"], "restart_of": {"lines": [[15, 400]]}}, "lines": [], "file_lines": [1, 2]}
    file.write_text(json.dumps(content), "utf-8")
    with open(file, "rb") as opened:
        read = read_long(opened)
        assert isinstance(read["send"]["lines"], LongList) and isinstance(read["file_lines"], LongList)
        assert read["send"]["restart_of"] == {"lines": [[15, 400]]} and plain(read) == content


def test_two_lists_are_read_beside_each_other_and_any_item_alone(tmp_path):
    file = tmp_path / "job.json"
    texts = [f'G1X{number} ("a, b\\")]' for number in range(5000)]
    file.write_text(json.dumps({"lines": texts, "file_lines": list(range(5000))}), "utf-8")
    with patch.multiple(long_json, BLOCK_BYTES=1000), open(file, "rb") as opened:
        read = read_long(opened)
        assert list(zip(read["lines"], read["file_lines"], strict=True)) == list(zip(texts, range(5000), strict=True))
        assert read["lines"][4321] == texts[4321] and read["file_lines"][10:13] == [10, 11, 12]
        assert read["lines"][-1] == texts[-1]
        with pytest.raises(IndexError):
            read["lines"][5000]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        '{"lines": ["a"',
        '{"lines": ["a",]}',
        '{"lines": [,]}',
        '{"lines": ["a" "b"]}',
        '{"lines": [01]}',
        '{"lines": ["a\nb"]}',
        '{"lines": [null]}',
        '{"a": 1,}',
        '{"a" 1}',
        "{1: 2}",
        '{"a": 1} 2',
        '{"a": tru}',
    ],
)
def test_what_is_no_json_is_refused(tmp_path, text):
    file = tmp_path / "bad.json"
    file.write_text(text, "utf-8")
    with open(file, "rb") as opened, pytest.raises(ValueError):
        read_long(opened)


def test_memory_does_not_grow_with_the_list(tmp_path):
    def most_bytes(count):
        file = tmp_path / f"{count}.json"
        file.write_text(json.dumps({"lines": ["G1X10.123Y20.456"] * count}), "utf-8")
        tracemalloc.start()
        with open(file, "rb") as opened:
            for _ in pieces(read_long(opened), json.JSONEncoder(**CANONICAL)):
                pass
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    with patch.multiple(long_json, BLOCK_BYTES=20_000, BLOCK_ITEMS=1000):
        few, many = most_bytes(5_000), most_bytes(25_000)
    assert many < few + 8 * 20_000  # a list of as many more
