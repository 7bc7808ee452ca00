/** The checksum of a file that is sent: CRC-32, as in Ethernet and zip. */

const polynomial = 0xedb88320;

/** The checksum of each byte alone. */
const ofByte = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit += 1) rest = rest & 1 ? polynomial ^ (rest >>> 1) : rest >>> 1;
  return rest;
});

/** The checksum of bytes, behind others that have this one. */
export function crc32(bytes: Uint8Array, before = 0): number {
  let sum = ~before;
  for (const byte of bytes) sum = (ofByte[(sum ^ byte) & 0xff] ?? 0) ^ (sum >>> 8);
  return ~sum >>> 0;
}

/** So many bytes are read at a time: STOP is heard between them. */
const piece = 1 << 20;

/** The checksum of a file. */
export async function crc32Of(file: Blob): Promise<number> {
  let sum = 0;
  for (let at = 0; at < file.size; at += piece) {
    const bytes = await file.slice(at, at + piece).arrayBuffer();
    sum = crc32(new Uint8Array(bytes), sum);
  }
  return sum;
}
