/** Drawings of many shapes, as tests open them. */

/** So many circles that lie apart, as a DXF. */
export function circles(number: number): string {
  const circle = (_: unknown, n: number) =>
    `0\nCIRCLE\n8\n0\n10\n${(n % 500) * 3}\n20\n${Math.floor(n / 500) * 3}\n40\n1\n`;
  const all = Array.from({ length: number }, circle).join("");
  return `0\nSECTION\n2\nENTITIES\n${all}0\nENDSEC\n0\nEOF\n`;
}
