import { expect, it } from "vitest";
import { crc32, crc32Of } from "./crc32";

const bytes = (text: string) => new TextEncoder().encode(text);

it("is CRC-32: the check value of the catalogues, at once and in pieces", () => {
  expect(crc32(bytes("123456789"))).toBe(0xcbf43926);
  expect(crc32(bytes("6789"), crc32(bytes("12345")))).toBe(0xcbf43926);
  expect(crc32(bytes(""))).toBe(0);
});

it("of a file is that of its bytes, however many pieces it is read in", async () => {
  const all = Uint8Array.from({ length: (2 << 20) + 17 }, (_, n) => (n * 31) >> 3);
  expect(await crc32Of(new Blob([all]))).toBe(crc32(all));
});
