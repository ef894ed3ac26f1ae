// CDR as our writers make it, read back: alignment from behind the header, either byte order, strings, sequences.

import assert from "node:assert/strict";
import { test } from "node:test";

import { CdrReader } from "../../src/wire/cdr";

/** A payload of little-endian CDR: its header and these bytes. */
const payload = (bytes: number[], kind = 1): DataView =>
  new DataView(Uint8Array.from([0, kind, 0, 0, ...bytes]).buffer);
const single = (value: number): number[] => [...new Uint8Array(Float32Array.of(value).buffer)];

test("a figure of 4 or 8 bytes begins at a multiple of them, counted from behind the header", () => {
  const reader = new CdrReader(payload([7, 0, 0, 0, 1, 2, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 240, 63]));
  assert.equal(reader.u8(), 7);
  assert.equal(reader.u32(), 0x201);
  assert.equal(reader.u8(), 9);
  assert.equal(reader.f64(), 1);
});

test("the header says the order of the bytes", () => {
  assert.equal(new CdrReader(payload([0, 0, 1, 2], 0)).u32(), 0x102);
  assert.equal(new CdrReader(payload([2, 1, 0, 0], 1)).u32(), 0x102);
});

test("signs, halves and hashes come through whole", () => {
  assert.equal(new CdrReader(payload([255, 255, 255, 255])).i32(), -1);
  assert.equal(new CdrReader(payload(Array<number>(8).fill(255))).i64(), -1);
  assert.equal(new CdrReader(payload(Array<number>(8).fill(255))).hash(), 2n ** 64n - 1n);
  assert.equal(new CdrReader(payload(single(-2.5))).f32(), -2.5);
  assert.equal(new CdrReader(payload([0])).bool(), false);
  assert.equal(new CdrReader(payload([1])).bool(), true);
});

test("a string ends before its closing zero, is UTF-8, and what follows is aligned", () => {
  const reader = new CdrReader(
    payload([4, 0, 0, 0, 0xc3, 0xbc, 97, 0, 0, 0, 0, 0, 5, 0, 0, 0].slice(0, 8).concat([6, 0, 0, 0])),
  );
  assert.equal(reader.string(), "\u00fca");
  assert.equal(reader.u32(), 6);
  const odd = new CdrReader(payload([2, 0, 0, 0, 98, 0, 0, 0, 5, 0, 0, 0]));
  assert.equal(odd.string(), "b");
  assert.equal(odd.u32(), 5);
  assert.equal(new CdrReader(payload([1, 0, 0, 0, 0])).string(), "");
});

test("points are read as x, y, z, x, y, z, and lists one by one", () => {
  const points = new CdrReader(payload([2, 0, 0, 0, ...[1, 2, 3, 4, 5, 6].flatMap(single), 8, 0, 0, 0]));
  assert.deepEqual([...points.f32s(3)], [1, 2, 3, 4, 5, 6]);
  assert.equal(points.u32(), 8);
  const list = new CdrReader(payload([3, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]));
  assert.deepEqual(
    list.list(() => list.u32()),
    [1, 2, 3],
  );
  const octets = new CdrReader(payload([2, 0, 0, 0, 9, 8, 0, 0, 4, 0, 0, 0]));
  assert.deepEqual([...octets.u8s()], [9, 8]);
  assert.equal(octets.u32(), 4);
});

test("what ends too early is refused, and a length that lies makes no room for itself", () => {
  assert.throws(() => new CdrReader(payload([1, 2])).u32(), RangeError);
  assert.throws(() => new CdrReader(payload([255, 255, 255, 127])).f32s(3), /a sequence of 2147483647 ends too early/);
  assert.throws(() => new CdrReader(payload([2, 0, 0, 0, 1, 0, 0, 0])).u32s(), RangeError);
  assert.throws(() => new CdrReader(payload([9, 0, 0, 0, 98, 0])).string(), RangeError);
});

test("another representation than plain CDR is refused", () => {
  assert.throws(() => new CdrReader(payload([0, 0, 0, 0], 3)), /CDR representation 3/);
});
