// Looks on as Foxglove does, with its own client library: subscribes to every channel, decodes what comes with the
// schema that was advertised, and prints what it met as JSON.
//
// usage: node station/web/tools/ts.mjs station/web/tests/foxglove.ts ws://HOST:PORT/foxglove?token=TOKEN SUBPROTOCOL
//            SECONDS TOPIC...
// Ends after SECONDS at the latest, and at once when there was a sample of every TOPIC.

import { type IDLMessageDefinition, parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { FoxgloveClient, type ServerInfo, type SubscriptionId } from "@foxglove/ws-protocol";
import WebSocket from "ws";

interface Reader {
  topic: string;
  read: (data: ArrayBufferView) => Record<string, unknown>;
}

const [address, subprotocol, seconds, ...awaited] = process.argv.slice(2);
if (!address || !subprotocol || !seconds) throw new Error("usage: foxglove.ts ADDRESS SUBPROTOCOL SECONDS TOPIC...");
const socket = new WebSocket(address, [subprotocol]);
const client = new FoxgloveClient({ ws: socket });
const met: {
  protocol: string;
  server?: ServerInfo;
  channels: number;
  times: number;
  topics: Record<string, number>;
  errors: string[];
  last: Record<string, unknown>;
} = {
  protocol: "",
  channels: 0,
  times: 0,
  topics: {},
  errors: [],
  last: {},
};
const types = new Map<string, IDLMessageDefinition[]>(); // by schema text
const readers = new Map<SubscriptionId, Reader>();
let first = true;

function end(): void {
  met.protocol = socket.protocol;
  console.log(JSON.stringify(met, (_, value: unknown) => (typeof value === "bigint" ? value.toString() : value)));
  process.exit(0);
}
function failed(why: string): void {
  met.errors.push(why);
  end();
}

function jsonReader(schema: string): Reader["read"] {
  const { properties } = JSON.parse(schema) as { properties: object };
  return (data) => {
    const message = JSON.parse(new TextDecoder().decode(data)) as Record<string, unknown>;
    if (Object.keys(message).some((name) => !(name in properties))) throw new Error(JSON.stringify(message));
    return message;
  };
}

function cdrReader(schema: string, type: string): Reader["read"] {
  if (!types.has(schema)) types.set(schema, parseIDL(schema));
  const reader = new MessageReader<Record<string, unknown>>(type, types.get(schema)!);
  return (data) => reader.readMessage(data);
}

client.on("error", (error) => failed(error.message));
client.on("close", (event) => failed(`closed: ${event.code}`));
client.on("status", (status) => met.errors.push(status.message));
client.on("time", () => (met.times += 1));
client.on("serverInfo", (info) => (met.server = info));
client.on("advertise", (channels) => {
  for (const { id, topic, encoding, schema, schemaEncoding, schemaName } of channels) {
    met.channels += 1;
    const isJson = encoding === "json" && schemaEncoding === "jsonschema";
    if (!isJson && (encoding !== "cdr" || schemaEncoding !== "omgidl"))
      met.errors.push(`${topic}: ${encoding}, ${schemaEncoding}`);
    readers.set(client.subscribe(id), { topic, read: isJson ? jsonReader(schema) : cdrReader(schema, schemaName) });
  }
});
client.on("message", ({ subscriptionId, data }) => {
  const { topic, read } = readers.get(subscriptionId)!;
  try {
    const sample = read(data);
    met.topics[topic] = (met.topics[topic] ?? 0) + 1;
    if (sample.time !== undefined) met.last[topic] = sample.time;
  } catch (why) {
    met.errors.push(`${topic}: ${(why as Error).message}`);
  }
  if (first && awaited.every((name) => met.topics[name])) {
    first = false;
    // It only looks on: what it says is answered with an error, and nothing else.
    socket.send(JSON.stringify({ op: "order", topic: "ExerciseCommand", sample: { action: "EXERCISE_STOP" } }));
    setTimeout(end, 500);
  }
});
setTimeout(end, 1000 * Number(seconds));
