// Reads logs with readers that know nothing of this project: the MCAP library and a ROS 2 message
// decoder of the npm registry. Every message of every channel is decoded by the schema in the log
// and encoded again, which must give the same bytes.
//
// Images are decoded and must be as large as the log says that the camera's images are.
//
//   scripts/run-node build/node/mcap tests/mcap check.mjs LOG...
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import jpeg from "jpeg-js";
import { File, check, decompressHandlers } from "./File.mjs";

/// What decodes and encodes the messages of a channel.
function codecOf(channel, schema) {
  check(schema, `${channel.topic} has no schema`);
  check(channel.messageEncoding === "cdr", `${channel.topic} is not in CDR`);
  check(schema.encoding === "ros2msg", `${channel.topic} has no ROS 2 schema`);
  const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
  return { reader: new MessageReader(definitions), writer: new MessageWriter(definitions) };
}

function checkMessage(channel, codec, data) {
  const message = codec.reader.readMessage(data);
  const again = codec.writer.writeMessage(message);
  check(Buffer.compare(Buffer.from(again), Buffer.from(data)) === 0,
    `${channel.topic}: encoded again, a message of ${data.length} bytes differs`);
  return message;
}

/// Unpacks the images of a log, whose size stands in the camera's matrices.
class Pictures {
  check(topic, schema, message) {
    if (schema.name.endsWith("/CameraMatrix")) this.info = message.info;
    if (schema.name !== "sensor_msgs/msg/CompressedImage") return;
    check(message.format === "jpeg", `${topic}: a picture is ${message.format}, no JPEG`);
    const { width, height, data } = jpeg.decode(message.data, { useTArray: true });
    check(data.length === 4 * width * height, `${topic}: a picture is cut off`);
    if (this.info)
      check(width === this.info.width && height === this.info.height,
        `${topic}: a picture is ${width} x ${height}, the camera's ${this.info.width} x ${this.info.height}`);
  }
}

/// Decodes all messages, found by the log's index.
async function checkIndexed(file) {
  const reader = await McapIndexedReader.Initialize({ readable: file, decompressHandlers });
  check(reader.header.profile === "ros2", `the profile is ${reader.header.profile}`);
  const codecs = new Map();
  const counts = new Map();
  const pictures = new Pictures();
  for (const [id, channel] of reader.channelsById)
    codecs.set(id, codecOf(channel, reader.schemasById.get(channel.schemaId)));
  for await (const m of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(m.channelId);
    const schema = reader.schemasById.get(channel.schemaId);
    pictures.check(channel.topic, schema, checkMessage(channel, codecs.get(m.channelId), m.data));
    counts.set(m.channelId, (counts.get(m.channelId) ?? 0) + 1);
  }
  for (const [id, count] of reader.statistics.channelMessageCounts)
    check(BigInt(counts.get(id) ?? 0) === count,
      `${reader.channelsById.get(id).topic}: ${counts.get(id)} messages instead of ${count}`);
  let attachments = 0, metadata = 0;
  for await (const _ of reader.readAttachments()) ++attachments;
  for await (const _ of reader.readMetadata()) ++metadata;
  check(attachments === reader.statistics.attachmentCount, "attachments are missing");
  check(metadata === reader.statistics.metadataCount, "metadata are missing");
  return { reader, counts };
}

/// Counts all messages from the begin to the end, with all checksums.
async function countStreamed(file) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  let count = 0;
  const step = 1n << 20n;
  for (let at = 0n; at < file.length; at += step) {
    const left = file.length - at;
    reader.append(await file.read(at, left < step ? left : step));
    for (let record; (record = reader.nextRecord()); ) if (record.type === "Message") ++count;
  }
  check(reader.done(), "the log has no end");
  return count;
}

let failed = process.argv.length < 3;
if (failed) console.error("usage: node check.mjs LOG...");
for (const path of process.argv.slice(2)) {
  let file;
  try {
    file = await File.open(path);
    const { reader, counts } = await checkIndexed(file);
    const total = [...counts.values()].reduce((a, b) => a + b, 0);
    const streamed = await countStreamed(file);
    check(streamed === total, `${streamed} messages in the file's order, ${total} by its index`);
    console.log(`${path}: ${total} messages, ${reader.statistics.chunkCount} chunks`);
    for (const [id, channel] of reader.channelsById)
      console.log(`  ${channel.topic} (${reader.schemasById.get(channel.schemaId).name}): ` +
        `${counts.get(id) ?? 0}`);
  } catch (error) {
    console.error(`${path}: ${error.message}`);
    failed = true;
  } finally {
    await file?.close();
  }
}
process.exit(failed ? 1 : 0);
