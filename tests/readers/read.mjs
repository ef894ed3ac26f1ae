// Opens MCAP files with the readers that Foxglove and Lichtblick are built on, decodes every message of every
// topic with the IDL of the file, and prints counts and checked figures as JSON.
//
// usage: node read.mjs FILE.mcap...

import { McapIndexedReader } from "@mcap/core";
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { decompress as unzstd } from "fzstd";
import lz4 from "lz4js";
import { open } from "node:fs/promises";

const decompressHandlers = {
  zstd: (bytes) => unzstd(bytes),
  lz4: (bytes) => lz4.decompress(bytes),
};

/** A file as @mcap/core reads it. */
async function readable(path) {
  const file = await open(path);
  return {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const bytes = new Uint8Array(Number(size));
      const { bytesRead } = await file.read(bytes, 0, Number(size), Number(offset));
      if (bytesRead !== Number(size)) throw new Error(`${path} ends too early`);
      return bytes;
    },
    close: () => file.close(),
  };
}

const result = { topics: {}, attachments: [], metadata: {} };
for (const path of process.argv.slice(2)) {
  const file = await readable(path);
  const reader = await McapIndexedReader.Initialize({ readable: file, decompressHandlers });
  const readers = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    if (schema.encoding !== "omgidl" || channel.messageEncoding !== "cdr")
      throw new Error(`${channel.topic}: ${schema.encoding}, ${channel.messageEncoding}`);
    const types = parseIDL(new TextDecoder().decode(schema.data));
    // The version of the wire is a module inside the module: part of every name.
    if (!/^windlass::v[0-9]+::[A-Z][A-Za-z]*$/.test(schema.name))
      throw new Error(`${channel.topic}: type ${schema.name}`);
    (result.topics[channel.topic] ??= { messages: 0 }).type = schema.name;
    readers.set(channel.id, new MessageReader(schema.name, types));
  }
  for await (const message of reader.readMessages()) {
    const { topic } = reader.channelsById.get(message.channelId);
    const value = readers.get(message.channelId).readMessage(message.data);
    const figures = result.topics[topic];
    ++figures.messages;
    if (value.time !== undefined) figures.last_time = value.time;
    if (value.tick !== undefined) figures.last_tick = Number(value.tick);
    if (value.nodes !== undefined) figures.last_nodes = value.nodes.length;
    if (value.text !== undefined) figures.last_text = value.text;
  }
  for (const messages of [reader.statistics]) result.counted = (result.counted ?? 0) + Number(messages.messageCount);
  for await (const one of reader.readAttachments()) result.attachments.push(one.name);
  for await (const one of reader.readMetadata())
    result.metadata[one.name] = { ...result.metadata[one.name], ...Object.fromEntries(one.metadata) };
  await file.close();
}
console.log(JSON.stringify(result));
