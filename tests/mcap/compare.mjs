// Compares what `gtlog export LOG EXPORTED.json` wrote with what other readers read in the log.
//
//   scripts/run-node build/node/mcap tests/mcap compare.mjs LOG EXPORTED.json
import { readFile } from "node:fs/promises";
import { McapIndexedReader } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { File, check, decompressHandlers } from "./File.mjs";

/// Compares a value with what was exported; enumerations are exported by the names of constants.
class Comparison {
  constructor(definitions) {
    this.definitions = definitions;
    this.scalars = 0;
  }
  record(type, value, exported, path) {
    const definition = this.definitions.find((d) => d.name === type);
    const fields = definition.definitions.filter((f) => !f.isConstant);
    check(Object.keys(exported).join() === fields.map((f) => f.name).join(), `${path}: other fields`);
    for (const field of fields)
      this.field(definition, field, value[field.name], exported[field.name], `${path}.${field.name}`);
  }
  field(definition, field, value, exported, path) {
    if (field.isArray && typeof exported === "string") {
      check(Buffer.from(value).toString("base64") === exported, `${path}: other bytes`);
      this.scalars += value.length;
    } else if (field.isArray) {
      check(value.length === exported.length, `${path}: ${value.length} elements, not ${exported.length}`);
      for (let i = 0; i < value.length; ++i)
        this.element(definition, field, value[i], exported[i], `${path}.${i}`);
    } else this.element(definition, field, value, exported, path);
  }
  element(definition, field, value, exported, path) {
    if (field.isComplex) return this.record(field.type, value, exported, path);
    ++this.scalars;
    if (typeof exported === "string" && typeof value === "number") {
      const constant = `${field.name.toUpperCase()}_${exported}`;
      exported = definition.definitions.find((f) => f.isConstant && f.name === constant)?.value;
    }
    if (typeof value === "bigint") value = Number(value);
    if (field.type === "float32" && exported !== null) exported = Math.fround(exported);
    if (exported === null) check(!Number.isFinite(value), `${path}: ${value} is missing`);
    else check(Object.is(value + 0, exported + 0) || value === exported, `${path}: ${value}, not ${exported}`);
  }
}

async function compare(logPath, exportedPath) {
  const exported = new Map();
  for (const line of (await readFile(exportedPath, "utf8")).trim().split("\n")) {
    const { topic, time, message } = JSON.parse(line);
    if (!exported.has(topic)) exported.set(topic, []);
    exported.get(topic).push({ time, message });
  }
  const file = await File.open(logPath);
  const reader = await McapIndexedReader.Initialize({ readable: file, decompressHandlers });
  let messages = 0, scalars = 0;
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
    const decoder = new MessageReader(definitions);
    const comparison = new Comparison(definitions);
    const lines = exported.get(channel.topic) ?? [];
    let i = 0;
    for await (const m of reader.readMessages({ topics: [channel.topic] })) {
      check(i < lines.length, `${channel.topic}: messages are missing`);
      const { time, message } = lines[i++];
      check(Number(m.logTime) === time, `${channel.topic}: message ${i} is of ${time}, not ${m.logTime}`);
      comparison.record(definitions[0].name, decoder.readMessage(m.data), message, channel.topic);
    }
    check(i === lines.length, `${channel.topic}: ${lines.length} messages instead of ${i}`);
    messages += i;
    scalars += comparison.scalars;
  }
  await file.close();
  check(messages > 0, "nothing was compared");
  console.log(`${logPath}: ${scalars} values of ${messages} messages are the same`);
}

try {
  await compare(process.argv[2], process.argv[3]);
} catch (error) {
  console.error(`${process.argv[2]}: ${error.message}`);
  process.exit(1);
}
