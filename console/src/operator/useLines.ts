import { useEffect, useRef, useState } from "react";
import { getJson } from "../link/http";

/** Lines that are asked for at once. */
const page = 400;

/** Lines of the open file, fetched by pages as they come into sight. */
export function useLines(
  name: string,
  hash: string,
  from: number,
  to: number,
): ReadonlyMap<number, string> {
  const [lines, setLines] = useState<ReadonlyMap<number, string>>(new Map());
  const asked = useRef(new Set<number>());
  // biome-ignore lint/correctness/useExhaustiveDependencies: another file has other lines
  useEffect(() => {
    asked.current = new Set();
    setLines(new Map());
  }, [name, hash]);
  useEffect(() => {
    const wanted = asked.current;
    const first = Math.floor(Math.max(from - 1, 0) / page);
    const last = Math.floor(Math.max(to - 1, 0) / page);
    for (let n = first; n <= last; n += 1) {
      if (wanted.has(n)) continue;
      wanted.add(n);
      const start = n * page;
      void fetchLines(hash, start + 1, page).then((texts) => {
        if (wanted !== asked.current) return;
        setLines((now) => new Map([...now, ...texts.map((t, k) => [start + 1 + k, t] as const)]));
      });
    }
  }, [hash, from, to]);
  return lines;
}

const fetchLines = (hash: string, from: number, count: number): Promise<string[]> =>
  getJson<string[]>(`/api/opened/${hash}/lines?from=${from}&count=${count}`).catch(() => []);
