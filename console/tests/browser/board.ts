/** A pretended board with step queues, for tests. */

import { type ChildProcess, spawn } from "node:child_process";
import { resolve } from "node:path";
import { until } from "./workshop";

const pretended = resolve(import.meta.dirname, "../../../target/debug/examples/klipper");

/** One on a pseudo terminal, which makes its steps in real time. */
export class Board {
  private readonly child: ChildProcess;
  private readonly lines: string[] = [];
  private said = "";

  constructor() {
    this.child = spawn(pretended, ["0.5"]);
    this.child.stdout?.on("data", (data: Buffer) => {
      const [last = "", ...before] = (this.said + data.toString()).split("\n").reverse();
      this.said = last;
      this.lines.push(...before.reverse());
    });
  }

  async line(): Promise<string> {
    await until(async () => this.lines.length > 0, "the board says something");
    return this.lines.shift() ?? "";
  }

  /** Counts of its motors. */
  async counts(): Promise<number[]> {
    this.work("where");
    const counts = /counts \[([^\]]*)\]/.exec(await this.line())?.[1] ?? "";
    return counts.split(",").filter(Boolean).map(Number);
  }

  /** Works it by a line of its own: `pin N 1` drives a pin. */
  work(line: string): void {
    this.child.stdin?.write(`${line}\n`);
  }

  unplug(): void {
    this.child.kill();
  }
}
