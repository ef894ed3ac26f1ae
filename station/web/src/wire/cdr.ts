// Reads CDR (XCDR version 1, as our @final types travel) from the payload of a DDS sample.

export class CdrReader {
  private readonly view: DataView;
  private readonly little: boolean;
  private at = 4; // behind the encapsulation header, from which alignment counts

  /** payload: with its 4-byte header. Throws RangeError where it ends too early. */
  constructor(payload: DataView) {
    this.view = payload;
    const kind = payload.getUint16(0);
    if (kind > 1) throw new RangeError(`CDR representation ${kind} is not plain CDR`);
    this.little = kind === 1;
  }

  private next(size: number): number {
    this.at += -(this.at - 4) & (size - 1);
    const at = this.at;
    this.at += size;
    return at;
  }

  u8(): number {
    return this.view.getUint8(this.at++);
  }
  bool(): boolean {
    return this.u8() !== 0;
  }
  i32(): number {
    return this.view.getInt32(this.next(4), this.little);
  }
  u32(): number {
    return this.view.getUint32(this.next(4), this.little);
  }
  i64(): number {
    return Number(this.view.getBigInt64(this.next(8), this.little));
  }
  u64(): number {
    return Number(this.view.getBigUint64(this.next(8), this.little));
  }
  hash(): bigint {
    return this.view.getBigUint64(this.next(8), this.little);
  }
  f32(): number {
    return this.view.getFloat32(this.next(4), this.little);
  }
  f64(): number {
    return this.view.getFloat64(this.next(8), this.little);
  }

  string(): string {
    const length = this.u32(); // with its closing zero
    const text = new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, Math.max(0, length - 1));
    this.at += length;
    return new TextDecoder().decode(text);
  }

  /** A sequence of structs of `each` floats, one behind the other. */
  f32s(each: number): Float32Array {
    const count = this.count(4 * each) * each;
    const values = new Float32Array(count);
    for (let i = 0; i < count; ++i) values[i] = this.view.getFloat32(this.at + 4 * i, this.little);
    this.at += 4 * count;
    return values;
  }
  u32s(): Uint32Array {
    const count = this.count(4);
    const values = new Uint32Array(count);
    for (let i = 0; i < count; ++i) values[i] = this.view.getUint32(this.at + 4 * i, this.little);
    this.at += 4 * count;
    return values;
  }
  u8s(): Uint8Array {
    const count = this.count(1);
    const values = new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, count).slice();
    this.at += count;
    return values;
  }

  list<T>(read: () => T): T[] {
    const count = this.count(1);
    const values: T[] = [];
    for (let i = 0; i < count; ++i) values.push(read());
    return values;
  }

  private count(size: number): number {
    const count = this.u32();
    if (count * size > this.view.byteLength - this.at) throw new RangeError(`a sequence of ${count} ends too early`);
    return count;
  }
}
