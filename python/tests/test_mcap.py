"""Logs of PyPI's `mcap` hold the same for gtlog and the package, whatever options its writer had, and it reads what gtlog wrote."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import asdict
from itertools import product
from pathlib import Path
from typing import Any, TypeVar

import pytest
from mcap.reader import NonSeekingReader, SeekingReader
from mcap.records import Attachment, Channel, Header, Message, Metadata, Schema
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, IndexType, Writer

import gt2003

T = TypeVar("T")

GTLOG = Path(os.environ["GT_BUILD"]) / "bin/gtlog"
FLAGS = ("repeat_channels", "repeat_schemas", "use_statistics", "use_summary_offsets")
INDEXES = (IndexType.ATTACHMENT, IndexType.CHUNK, IndexType.MESSAGE, IndexType.METADATA)
FORMS: tuple[dict[str, Any], ...] = (
    {"use_chunking": False},
    *({"compression": kind, "chunk_size": size} for kind in CompressionType for size in (1, 1 << 20)),
)


def gtlog(*words: str | Path) -> str:
    return subprocess.run([GTLOG, *words], check=True, capture_output=True, text=True).stdout


def options() -> Iterator[dict[str, Any]]:
    """Yield each form of messages with each set of flags, and with them all sets of indexes in turn."""
    for number, (form, *flags) in enumerate(product(FORMS, *[(False, True)] * len(FLAGS))):
        indexes = IndexType.NONE
        for i, index in enumerate(INDEXES):
            if number * 7 >> i & 1:
                indexes |= index
        crcs = {"enable_crcs": number % 3 > 0, "enable_data_crcs": number % 3 > 1}
        yield {**form, **dict(zip(FLAGS, flags)), "index_types": indexes, **crcs}


def write(path: Path, **given: Any) -> None:
    with path.open("wb") as file:
        log = Writer(file, **given)
        log.start(profile="a profile", library="a library")
        schema = log.register_schema("own_msgs/msg/Number", "ros2msg", b"int32 data\n")
        channels = [
            log.register_channel("/a", "cdr", schema, {"qos": "- depth: 0\n"}),
            log.register_channel("/plain", "text", 0),
        ]
        for note in ("first", "second"):
            log.add_metadata("note", {"note": note})
        for i in range(6):
            data = b"\0\1\0\0" + i.to_bytes(4, "little")
            log.add_message(channels[i % 2], log_time=1000 * i + 1, publish_time=i, sequence=7 + i, data=data)
        for content in (b"a note", b""):
            log.add_attachment(create_time=6, log_time=5, name="note.txt", media_type="text/plain", data=content)
        log.finish()


def content(path: Path) -> list[str]:
    """Return what PyPI's reader finds in a log: channels and schemas by what they are, not by their ids."""
    schemas, channels, found = {0: "none"}, {}, []
    with path.open("rb") as file:
        for record in StreamReader(file, validate_crcs=True).records:
            told = asdict(record)
            if isinstance(record, Schema):
                schemas[told.pop("id")] = repr(told)
            elif isinstance(record, Channel):
                channels[told.pop("id")] = schemas[told.pop("schema_id")] + repr(told)
            elif isinstance(record, Message):
                found.append(channels[told.pop("channel_id")] + repr(told))
            elif isinstance(record, (Header, Metadata, Attachment)):
                found.append(type(record).__name__ + repr(told))
    return sorted(found)


def expect(path: Path) -> None:
    """Expect that the package finds in a log what was written."""
    log = gt2003.Log(path)
    assert log.damage is None and log.topics == {"/a": "own_msgs/msg/Number", "/plain": ""}
    assert list(log["/a"]["data"]) == [0, 2, 4] and list(log.unreadable) == ["/plain"]
    assert log.metadata.all() == [("note", {"note": "first"}), ("note", {"note": "second"})]
    assert log.attachments.all() == [("note.txt", b"a note"), ("note.txt", b"")]


def test_what_it_writes_holds_the_same(tmp_path: Path) -> None:
    files = []
    for number, given in enumerate(options()):
        log, copy = tmp_path / f"{number}.mcap", tmp_path / f"{number}-copy.mcap"
        write(log, **given)
        command, order = (("cut", (log, copy)), ("join", (copy, log)), ("repair", (log, copy)))[number % 3]
        gtlog(command, *order)
        assert len(content(log)) == 11
        assert content(copy) == content(log), f"gtlog {command} of a log with {given}"
        for file in (log, copy):
            expect(file)
        files += [log, copy]
    assert len(files) == 2 * 16 * len(FORMS)
    gtlog("check", *files)
    assert gtlog("list", *files).count("note.txt") == 2 * len(files)
    shown = [json.loads(line) for line in gtlog("show", files[0], "--topic", "/a").splitlines()]
    for file in files[1::13]:
        assert [json.loads(line) for line in gtlog("show", file, "--topic", "/a").splitlines()] == shown


def test_a_topic_of_two_schemas_has_both(tmp_path: Path) -> None:
    with (tmp_path / "log.mcap").open("wb") as file:
        log = Writer(file)
        log.start()
        for name, text in (("own_msgs/msg/Number", b"int32 data\n"), ("own_msgs/msg/Text", b"string data\n")):
            log.register_channel("/b", "cdr", log.register_schema(name, "ros2msg", text))
        log.finish()
    assert gt2003.Log(tmp_path / "log.mcap").topics == {"/b": "own_msgs/msg/Number, own_msgs/msg/Text"}


@pytest.fixture(scope="module")
def ours(tmp_path_factory: pytest.TempPathFactory) -> gt2003.Log:
    """The log of a robot in a match of three seconds."""
    folder = tmp_path_factory.mktemp("match")
    match = gt2003.Match(logs=str(folder))
    match.run(3)
    match.close()
    return gt2003.Log(folder / "red1.mcap")


@pytest.mark.parametrize("reader", [SeekingReader, NonSeekingReader])
def test_it_reads_what_matches_write(reader: type, ours: gt2003.Log) -> None:
    def ask(query: Callable[[Any], T]) -> T:
        with open(ours.path, "rb") as file:  # one of them answers once
            return query(reader(file, validate_crcs=True))

    summary = ask(lambda log: log.get_summary())
    assert {c.topic: summary.schemas[c.schema_id].name for c in summary.channels.values()} == ours.topics
    assert ask(lambda log: log.get_header()).library == "gt2003"
    times: dict[str, list[float]] = {topic: [] for topic in ours.topics}
    for topic, time in ask(lambda log: [(c.topic, m.log_time) for _, c, m in log.iter_messages()]):
        times[topic].append(time / 1e6)
    for topic in ("/RobotPose", "/input/SensorData"):
        assert times[topic] == list(ours[topic]["log_time"])
    assert summary.statistics.message_count == sum(map(len, times.values())) > 1000
    assert ask(lambda log: {a.name: a.data for a in log.iter_attachments()}) == dict(ours.attachments)
    assert ask(lambda log: [(m.name, m.metadata) for m in log.iter_metadata()]) == ours.metadata.all()
