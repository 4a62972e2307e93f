// Writes logs by the MCAP library of the npm registry, one with each set of its writer's options,
// has gtlog write each again, and compares what the library reads of both.
//
//   scripts/run-node build/node/mcap tests/mcap variants.mjs GTLOG
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { McapStreamReader, McapWriter, TempBuffer } from "@mcap/core";
import { check, decompressHandlers } from "./File.mjs";

const ofAll = ["useStatistics", "useSummaryOffsets", "repeatSchemas", "repeatChannels",
  "useAttachmentIndex", "useMetadataIndex"];
const ofChunks = ["useMessageIndex", "useChunkIndex", "smallChunks"];

/// All sets of some options, each as an object of booleans.
function* setsOf(names) {
  for (let set = 0; set < 1 << names.length; ++set)
    yield Object.fromEntries(names.map((name, i) => [name, (set >> i & 1) === 1]));
}

function* allOptions() {
  for (const options of setsOf(ofAll)) yield { ...options, useChunks: false };
  for (const { smallChunks, ...options } of setsOf([...ofAll, ...ofChunks]))
    yield { ...options, useChunks: true, chunkSize: smallChunks ? 1 : 1 << 20 };
}

async function logWith(options) {
  const buffer = new TempBuffer();
  const writer = new McapWriter({ writable: buffer, ...options });
  const text = (text) => new TextEncoder().encode(text);
  await writer.start({ profile: "a profile", library: "a library" });
  const schemaId = await writer.registerSchema(
    { name: "own_msgs/msg/Number", encoding: "ros2msg", data: text("int32 data\n") });
  const channels = [
    { topic: "/a", messageEncoding: "cdr", schemaId, metadata: new Map([["qos", "- depth: 0\n"]]) },
    { topic: "/plain", messageEncoding: "text", schemaId: 0, metadata: new Map() }];
  const ids = [];
  for (const channel of channels) ids.push(await writer.registerChannel(channel));
  for (const note of ["first", "second"])
    await writer.addMetadata({ name: "note", metadata: new Map([["note", note]]) });
  for (let i = 0; i < 6; ++i)
    await writer.addMessage({ channelId: ids[i % 2], sequence: 7 + i, logTime: BigInt(1000 * i + 1),
      publishTime: BigInt(i), data: new Uint8Array([0, 1, 0, 0, i, 0, 0, 0]) });
  for (const data of ["a note", ""])
    await writer.addAttachment({ name: "note.txt", logTime: 5n, createTime: 6n,
      mediaType: "text/plain", data: text(data) });
  await writer.end();
  return buffer.get();
}

/// What is in a log, as text: channels and schemas by what they are, not by their ids.
function contentOf(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(bytes);
  const schemas = new Map([[0, "none"]]), channels = new Map(), content = [];
  const plain = (value) => JSON.stringify(value, (_, v) =>
    typeof v === "bigint" ? String(v) : v instanceof Map ? [...v] : v instanceof Uint8Array ? [...v] : v);
  for (let record; (record = reader.nextRecord());) {
    const { type, id, channelId, schemaId, ...rest } = record;
    if (type === "Schema") schemas.set(id, plain(rest));
    if (type === "Channel") channels.set(id, plain(rest) + schemas.get(schemaId));
    if (type === "Message") content.push("Message" + channels.get(channelId) + plain(rest));
    if (type === "Header" || type === "Metadata" || type === "Attachment")
      content.push(type + plain(rest));
  }
  check(reader.done(), "the log does not end");
  return content.sort().join("\n");
}

const [gtlog] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), "gt2003-mcap-"));
const commands = [(log, out) => ["cut", log, out], (log, out) => ["join", out, log],
  (log, out) => ["repair", log, out]];
const files = [];
try {
  for (const options of allOptions()) {
    const log = join(folder, `${files.length / 2}.mcap`), copy = join(folder, `${files.length / 2}-copy.mcap`);
    const bytes = await logWith(options);
    writeFileSync(log, bytes);
    const command = commands[files.length / 2 % commands.length](log, copy);
    execFileSync(gtlog, command);
    const expected = contentOf(bytes);
    check(expected.split("\n").length === 11, `the library reads ${expected}`);
    check(contentOf(readFileSync(copy)) === expected,
      `gtlog ${command[0]} of a log with ${JSON.stringify(options)} holds something else`);
    files.push(log, copy);
  }
  execFileSync(gtlog, ["check", ...files]);
  console.log(`${files.length / 2} logs are written again with the same contents`);
} finally {
  rmSync(folder, { recursive: true });
}
