/** A pretended controller of the grbl family, for tests. */

import { type ChildProcess, spawn } from "node:child_process";
import { resolve } from "node:path";
import { until } from "./workshop";

const pretended = resolve(import.meta.dirname, "../../../target/debug/examples/grbl");

/** One on a pseudo terminal, which moves in real time. */
export class Controller {
  private readonly child: ChildProcess;
  private readonly lines: string[] = [];
  private said = "";

  constructor(...settings: string[]) {
    this.child = spawn(pretended, settings);
    this.child.stdout?.on("data", (data: Buffer) => {
      const [last = "", ...before] = (this.said + data.toString()).split("\n").reverse();
      this.said = last;
      this.lines.push(...before.reverse());
    });
  }

  async line(): Promise<string> {
    await until(async () => this.lines.length > 0, "the controller says something");
    return this.lines.shift() ?? "";
  }

  /** Its place, mm, and the speed of its spindle, revolutions a minute; nothing where that is off. */
  async look(): Promise<{ place: number[]; rpm: number | null }> {
    this.child.stdin?.write("where\n");
    const line = await this.line();
    const place = line.split(" ")[0]?.split(",").map(Number) ?? [];
    const rpm = /spindle Some\(([\d.]+)\)/.exec(line)?.[1];
    return { place, rpm: rpm === undefined ? null : Number(rpm) };
  }

  /** Somebody at a pendant sends it a line. */
  says(line: string): void {
    this.child.stdin?.write(`pendant ${line}\n`);
  }

  /** Works it by a line of its own: `pins P` closes its probe, `bore X Y RADIUS` lays a thing around it. */
  work(line: string): void {
    this.child.stdin?.write(`${line}\n`);
  }

  unplug(): void {
    this.child.kill();
  }
}
