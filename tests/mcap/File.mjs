import { open } from "node:fs/promises";
import { decompress } from "fzstd";

export const decompressHandlers = {
  zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))),
};

/// A file as the MCAP library wants it.
export class File {
  static async open(path) {
    const handle = await open(path);
    return new File(handle, (await handle.stat()).size);
  }
  constructor(handle, length) {
    this.handle = handle;
    this.length = BigInt(length);
  }
  async size() {
    return this.length;
  }
  async read(offset, size) {
    const bytes = new Uint8Array(Number(size));
    const { bytesRead } = await this.handle.read(bytes, 0, bytes.length, Number(offset));
    if (bytesRead !== bytes.length) throw new Error(`only ${bytesRead} bytes at ${offset}`);
    return bytes;
  }
  async close() {
    await this.handle.close();
  }
}

export function check(condition, what) {
  if (!condition) throw new Error(what);
}
