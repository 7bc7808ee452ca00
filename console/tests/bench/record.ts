/** Tells figures, and writes them into docs/benchmarks.md where RECORD=1 asks for it. */

import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { cpus, loadavg, release } from "node:os";
import { resolve } from "node:path";

export interface Figure {
  readonly input: string;
  readonly what: string;
  readonly value: number;
  readonly unit: "ms" | "MB";
  /** The most it may be. */
  readonly goal?: number;
}

const file = resolve(import.meta.dirname, "../../../docs/benchmarks.md");

const text = ({ value, unit }: Figure): string =>
  `${value < 20 && unit === "ms" ? value.toFixed(1) : Math.round(value)} ${unit}`;

const verdict = ({ value, unit, goal }: Figure): string =>
  goal === undefined ? "" : `≤ ${goal} ${unit}: ${value <= goal ? "met" : "missed"}`;

const row = (figure: Figure): string =>
  `| ${figure.input} | ${figure.what} | ${text(figure)} | ${verdict(figure)} |`;

function heading(): string {
  const commit = execFileSync("git", ["rev-parse", "--short", "HEAD"], { encoding: "utf8" }).trim();
  const [day] = new Date().toISOString().split("T");
  const model = cpus()[0]?.model ?? "an unknown processor";
  const load = (loadavg()[0] ?? 0).toFixed(2);
  return (
    `Measured ${day} at commit ${commit}, on ${model}, ${cpus().length} cores, Linux ${release()}, ` +
    `headless chromium that draws with the processor, at a load of ${load}. Command: \`make bench\`.`
  );
}

/** Prints the figures of a section; `section` is the word in its marks. */
export function tell(section: string, figures: readonly Figure[]): void {
  const table = ["| input | what | | goal |", "|---|---|---|---|", ...figures.map(row)].join("\n");
  console.log(table);
  if (!process.env.RECORD) return;
  const [from, to] = [
    `<!-- make bench RECORD=1 writes ${section} from here -->`,
    `<!-- ${section} to here -->`,
  ];
  const before = readFileSync(file, "utf8");
  const [start, end] = [before.indexOf(from), before.indexOf(to)];
  if (start < 0 || end < start) throw new Error(`docs/benchmarks.md has no place for ${section}`);
  const middle = `${from}\n\n${heading()}\n\n${table}\n\n`;
  writeFileSync(file, before.slice(0, start) + middle + before.slice(end));
}
