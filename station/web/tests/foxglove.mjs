// Looks on as Foxglove does, with its own client library: subscribes to every channel, decodes what comes with the
// schema that was advertised, and prints what it met as JSON.
//
// usage: node --experimental-websocket foxglove.mjs ws://HOST:PORT/foxglove?token=TOKEN SUBPROTOCOL SECONDS TOPIC...
// Ends after SECONDS at the latest, and at once when there was a sample of every TOPIC.

import { need } from "../tools/web.mjs";

const { parseIDL } = need("@foxglove/omgidl-parser");
const { MessageReader } = need("@foxglove/omgidl-serialization");
const protocol = need("@foxglove/ws-protocol");

const [address, subprotocol, seconds, ...awaited] = process.argv.slice(2);
const socket = new WebSocket(address, [subprotocol]);
const client = new protocol.FoxgloveClient({ ws: socket });
const met = { protocol: "", server: null, channels: 0, topics: {}, errors: [], last: {} };
const types = new Map(); // by schema text
const readers = new Map(); // by subscription
let first = true;

function end() {
  met.protocol = socket.protocol;
  console.log(JSON.stringify(met, (_, value) => (typeof value === "bigint" ? value.toString() : value)));
  process.exit(0);
}

client.on("error", (error) => (met.errors.push(`${error.message ?? error}`), end()));
client.on("close", (event) => (met.errors.push(`closed: ${event.code}`), end()));
client.on("status", (status) => met.errors.push(status.message));
client.on("serverInfo", (info) => (met.server = info));
client.on("advertise", (channels) => {
  for (const channel of channels) {
    met.channels += 1;
    if (channel.encoding === "json" && channel.schemaEncoding === "jsonschema") {
      const { properties } = JSON.parse(channel.schema);
      const readMessage = (data) => {
        const message = JSON.parse(new TextDecoder().decode(data));
        if (Object.keys(message).some((name) => !(name in properties))) throw new Error(JSON.stringify(message));
        return message;
      };
      readers.set(client.subscribe(channel.id), { topic: channel.topic, reader: { readMessage } });
      continue;
    }
    if (channel.encoding !== "cdr" || channel.schemaEncoding !== "omgidl")
      met.errors.push(`${channel.topic}: ${channel.encoding}, ${channel.schemaEncoding}`);
    if (!types.has(channel.schema)) types.set(channel.schema, parseIDL(channel.schema));
    const reader = new MessageReader(channel.schemaName, types.get(channel.schema));
    readers.set(client.subscribe(channel.id), { topic: channel.topic, reader });
  }
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const { topic, reader } = readers.get(subscriptionId);
  try {
    const sample = reader.readMessage(data);
    met.topics[topic] = (met.topics[topic] ?? 0) + 1;
    if (sample.time !== undefined) met.last[topic] = sample.time;
    if (timestamp <= 0n) met.errors.push(`${topic}: timestamp ${timestamp}`);
  } catch (error) {
    met.errors.push(`${topic}: ${error.message}`);
  }
  if (first && awaited.every((name) => met.topics[name])) {
    first = false;
    // It only looks on: what it says is answered with an error, and nothing else.
    socket.send(JSON.stringify({ op: "order", topic: "ExerciseCommand", sample: { action: "EXERCISE_STOP" } }));
    setTimeout(end, 500);
  }
});
setTimeout(end, 1000 * Number(seconds));
