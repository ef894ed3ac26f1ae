// Opens MCAP files with the readers that Foxglove and Lichtblick are built on, decodes every message of every
// topic with the IDL of the file, and prints counts and checked figures as JSON.
//
// usage: node station/web/tools/ts.mjs tests/readers/read.ts FILE.mcap...

import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { type McapTypes, McapIndexedReader } from "@mcap/core";
import { decompress as unzstd } from "fzstd";
import lz4 from "lz4js";
import { type FileHandle, open } from "node:fs/promises";

interface TopicFigures {
  messages: number;
  type: string;
  last_time?: unknown;
  last_tick?: number;
  last_nodes?: number;
  last_text?: unknown;
}

const decompressHandlers: McapTypes.DecompressHandlers = {
  zstd: (bytes) => unzstd(bytes),
  lz4: (bytes) => lz4.decompress(bytes),
};

/** A file as @mcap/core reads it. */
const readable = (path: string, file: FileHandle): McapTypes.IReadable => ({
  size: async () => BigInt((await file.stat()).size),
  read: async (offset, size) => {
    const bytes = new Uint8Array(Number(size));
    const { bytesRead } = await file.read(bytes, 0, Number(size), Number(offset));
    if (bytesRead !== Number(size)) throw new Error(`${path} ends too early`);
    return bytes;
  },
});

const topics: Record<string, TopicFigures> = {};
const attachments: string[] = [];
const metadata: Record<string, Record<string, string>> = {};
let counted = 0;
for (const path of process.argv.slice(2)) {
  const file = await open(path);
  const reader = await McapIndexedReader.Initialize({ readable: readable(path, file), decompressHandlers });
  const readers = new Map<number, MessageReader>();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId)!;
    if (schema.encoding !== "omgidl" || channel.messageEncoding !== "cdr")
      throw new Error(`${channel.topic}: ${schema.encoding}, ${channel.messageEncoding}`);
    const types = parseIDL(new TextDecoder().decode(schema.data));
    // The version of the wire is a module inside the module: part of every name.
    if (!/^windlass::v[0-9]+::[A-Z][A-Za-z]*$/.test(schema.name))
      throw new Error(`${channel.topic}: type ${schema.name}`);
    topics[channel.topic] = { ...(topics[channel.topic] ?? { messages: 0 }), type: schema.name };
    readers.set(channel.id, new MessageReader(schema.name, types));
  }
  for await (const message of reader.readMessages()) {
    const figures = topics[reader.channelsById.get(message.channelId)!.topic]!;
    const value: { time?: unknown; tick?: unknown; nodes?: unknown[]; text?: unknown } = readers
      .get(message.channelId)!
      .readMessage(message.data);
    ++figures.messages;
    if (value.time !== undefined) figures.last_time = value.time;
    if (value.tick !== undefined) figures.last_tick = Number(value.tick);
    if (value.nodes !== undefined) figures.last_nodes = value.nodes.length;
    if (value.text !== undefined) figures.last_text = value.text;
  }
  counted += Number(reader.statistics!.messageCount);
  for await (const one of reader.readAttachments()) attachments.push(one.name);
  for await (const one of reader.readMetadata())
    metadata[one.name] = { ...metadata[one.name], ...Object.fromEntries(one.metadata) };
  await file.close();
}
console.log(JSON.stringify({ topics, attachments, metadata, counted }));
