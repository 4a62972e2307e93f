// Starts a program that serves the Foxglove WebSocket protocol, and looks at a running match with readers that know nothing
// of this project: the protocol's client and a ROS 2 message decoder of the npm registry. All of one robot and some of the others
// is subscribed; each message that comes is decoded by its schema and encoded again, which must give the same bytes.
//
//   scripts/run-node build/node/foxglove tests/foxglove match.mjs SIMGT
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:net";
import protocol from "@foxglove/ws-protocol";
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import jpeg from "jpeg-js";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;

function check(holds, what) {
  if (!holds) throw new Error(what);
}

/// A port that is free.
async function freePort() {
  const server = createServer();
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

/// A viewer that is connected as soon as the program listens. It listens before the connection is open: the server's first
/// messages come once, and may come with its answer to the handshake.
async function connect(url, wanted) {
  for (let i = 0; i < 600; ++i) {
    const ws = new WebSocket(url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
    const client = new FoxgloveClient({ ws });
    const viewer = new Viewer(client, wanted);
    const open = await new Promise((done) => {
      client.on("open", () => done(true));
      client.on("error", () => done(false));
    });
    if (open) return viewer;
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error(`nobody listens at ${url}`);
}

/// The status with which the program answers a page from elsewhere.
function answerTo(url, origin) {
  return new Promise((done) => {
    const ws = new WebSocket(url, [FoxgloveClient.SUPPORTED_SUBPROTOCOL], { origin });
    ws.on("open", () => (ws.terminate(), done(101)));
    ws.on("unexpected-response", (request, response) => (request.destroy(), done(response.statusCode)));
    ws.on("error", () => done(0));
  });
}

/// Subscribes to the channels that are wanted, decodes what comes.
class Viewer {
  constructor(client, wanted) {
    this.client = client;
    this.topics = new Map();
    this.newest = new Map();
    this.counts = new Map();
    this.subscriptions = new Map();
    this.codecs = new Map();
    this.parameters = [];
    client.on("error", (error) => (this.error = error));
    client.on("serverInfo", (info) => (this.info = info));
    client.on("time", ({ timestamp }) => (this.time = timestamp));
    client.on("parameterValues", ({ parameters, id }) => this.parameters.push({ parameters, id }));
    client.on("advertise", (channels) => {
      for (const channel of channels) {
        this.topics.set(channel.topic, channel);
        if (wanted(channel.topic))
          this.subscriptions.set(client.subscribe(channel.id), { topic: channel.topic, codec: this.codec(channel) });
      }
    });
    client.on("message", ({ subscriptionId, timestamp, data }) => {
      try {
        this.take(this.subscriptions.get(subscriptionId), timestamp, new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
      } catch (error) {
        this.error = error;
      }
    });
  }

  /// What decodes and encodes the messages of a channel.
  codec({ encoding, schemaName, schema }) {
    check(encoding === "cdr", `a channel is in ${encoding}`);
    if (!this.codecs.has(schemaName)) {
      const definitions = parse(schema, { ros2: true });
      this.codecs.set(schemaName, { reader: new MessageReader(definitions), writer: new MessageWriter(definitions) });
    }
    return this.codecs.get(schemaName);
  }

  take({ topic, codec: { reader, writer } }, timestamp, data) {
    const message = reader.readMessage(data);
    const again = writer.writeMessage(message);
    check(Buffer.compare(Buffer.from(again), Buffer.from(data)) === 0, `${topic}: encoded again, a message differs`);
    this.counts.set(topic, (this.counts.get(topic) ?? 0) + 1);
    this.newest.set(topic, { timestamp, message });
  }

  async until(holds, what) {
    for (const end = Date.now() + 60000; Date.now() < end; await new Promise((done) => setTimeout(done, 50))) {
      if (this.error) throw this.error;
      if (holds()) return;
    }
    throw new Error(`waited in vain for ${what}`);
  }
  message(topic) {
    return this.newest.get(topic)?.message;
  }
}

/// The topics that a layout's panels show.
function topicsOfLayout(file) {
  const texts = [];
  const collect = (value) => {
    if (typeof value === "string") texts.push(value);
    else if (value && typeof value === "object")
      for (const [key, part] of Object.entries(value)) texts.push(key), collect(part);
  };
  collect(JSON.parse(readFileSync(file, "utf8")).configById);
  const topics = texts.filter((text) => text.startsWith("/")).map((text) => text.split(".")[0]);
  check(topics.length >= 10, `${file} shows ${topics.length} topics`);
  return topics;
}

const some = new Set(["/blue4/BallModel", "/red2/drawings/SelfLocator/pose", "/blue1/plots/BehaviorControl/engine", "/tf",
  "/field", "/truth", "/log"]);

async function checkMatch(simgt) {
  const port = await freePort();
  const program = spawn(simgt, ["console", "scenes/match.scene", "--seed", "7", "--foxglove", `${port}`, "--foxglove-origin",
    "https://app.foxglove.dev", "-c", "st on 1", "-c", "run 60 s"], { stdio: "ignore" });
  try {
    const viewer = await connect(`ws://127.0.0.1:${port}`,
      (topic) => topic.startsWith("/red1/") ? !topic.includes("/distances/") : some.has(topic));
    await viewer.until(() => viewer.info && viewer.time, "the time");
    for (const [origin, status] of [["https://app.foxglove.dev", 101], ["http://localhost:8080", 101],
      ["https://elsewhere.example", 403], ["file://", 403]]) {
      const answer = await answerTo(`ws://127.0.0.1:${port}`, origin);
      check(answer === status, `a page of ${origin} gets ${answer} instead of ${status}`);
    }
    for (const robot of ["red1", "blue4"])
      for (const topic of ["camera", "RobotPose", "drawings/SelfLocator/pose", "camera/drawings/ImageProcessor/percepts"])
        check(viewer.topics.has(`/${robot}/${topic}`), `there is no /${robot}/${topic}`);
    for (const topic of topicsOfLayout("config/foxglove/match.json"))
      check(viewer.topics.has(topic), `the layout shows ${topic}, which is not there`);
    for (const topic of [...some, "/red1/camera", "/red1/RobotPose", "/red1/camera/drawings/ImageProcessor/horizon"])
      await viewer.until(() => viewer.newest.has(topic), topic);

    const { width, height } = jpeg.decode(viewer.message("/red1/camera").data, { useTArray: true });
    const info = viewer.message("/red1/CameraMatrix").info;
    check(width === info.width && height === info.height, `an image is ${width} x ${height}`);
    const truth = viewer.message("/truth").entities;
    check(truth.length === 9, `${truth.length} robots and balls instead of 9`);
    await viewer.until(() => viewer.message("/tf").transforms.some((frame) => frame.child_frame_id === "blue4"), "a frame");
    check(Number(viewer.newest.get("/red1/RobotPose").timestamp) <= Number(viewer.time) + 1e9, "times disagree");

    await checkParameters(viewer);
    const total = [...viewer.counts.values()].reduce((a, b) => a + b, 0);
    console.log(`${viewer.topics.size} channels, of which ${viewer.counts.size} sent ${total} messages`);
    viewer.client.close();
  } finally {
    program.kill();
  }
}

async function checkParameters(viewer) {
  const { client } = viewer;
  client.getParameters([], "all");
  await viewer.until(() => viewer.parameters.some(({ id }) => id === "all"), "parameters");
  const { parameters } = viewer.parameters.find(({ id }) => id === "all");
  const changed = parameters.find(({ name, value }) => name.startsWith("red1.") && typeof value === "number" && value > 0.1);
  check(changed, "red1 has no parameter that is a number");
  client.subscribeParameterUpdates([changed.name]);
  const value = changed.value * 0.9;
  client.setParameters([{ name: changed.name, value }], "set");
  await viewer.until(() => viewer.parameters.some(({ id }) => id === "set"), "an answer");
  const answer = viewer.parameters.find(({ id }) => id === "set").parameters[0];
  check(answer.name === changed.name && Math.abs(answer.value - value) < 1e-6 * Math.abs(value),
    `${changed.name} is ${answer.value} instead of ${value}`);
}

try {
  await checkMatch(process.argv[2]);
  process.exit(0);
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
