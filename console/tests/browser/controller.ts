/** Pretended controllers, for tests. */

import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { until } from "./workshop";

const examples = resolve(import.meta.dirname, "../../../target/debug/examples");

/** One that moves in real time, and tells its port in its first line. */
export class Pretended {
  private readonly child: ChildProcess;
  private readonly lines: string[] = [];
  private said = "";
  private cable = "";

  constructor(program: string, words: string[]) {
    this.child = spawn(resolve(examples, program), words);
    this.child.stdout?.on("data", (data: Buffer) => {
      const [last = "", ...before] = (this.said + data.toString()).split("\n").reverse();
      this.said = last;
      this.lines.push(...before.reverse());
    });
  }

  /**
   * Its port. A pseudo terminal has a name of its own, which nothing has once it is unplugged: the system gives the
   * name that it had to the next one, at which a server that waits for this one would try.
   */
  async port(): Promise<string> {
    const told = await this.line();
    if (!told.startsWith("/dev/")) return told;
    this.cable = mkdtempSync(join(tmpdir(), "kerf-port-"));
    const port = join(this.cable, "tty");
    symlinkSync(told, port);
    return port;
  }

  async line(): Promise<string> {
    await until(async () => this.lines.length > 0, "the controller says something");
    return this.lines.shift() ?? "";
  }

  /** Its place, mm, and the speed of its spindle, revolutions a minute; nothing where that is off. */
  async look(): Promise<{ place: number[]; rpm: number | null; waitsForTool: boolean }> {
    this.child.stdin?.write("where\n");
    const line = await this.line();
    const place = line.split(" ")[0]?.split(",").map(Number) ?? [];
    const rpm = /spindle Some\(([\d.]+)\)/.exec(line)?.[1];
    const waitsForTool = line.endsWith("waits for a tool");
    return { place, rpm: rpm === undefined ? null : Number(rpm), waitsForTool };
  }

  /** Works it by a line of its own. */
  work(line: string): void {
    this.child.stdin?.write(`${line}\n`);
  }

  unplug(): void {
    if (this.cable) rmSync(this.cable, { recursive: true, force: true });
    this.child.kill();
  }
}

/** One of the grbl family on a pseudo terminal, with settings (`22=1`), of grblHAL by the word `hal`: `pins P` closes its probe, `bore X Y RADIUS` lays a thing around it. */
export class Controller extends Pretended {
  constructor(...words: string[]) {
    super("grbl", words);
  }

  /** A value of its settings. */
  async setting(number: number): Promise<number> {
    this.work(`setting ${number}`);
    return Number(await this.line());
  }

  /** Somebody at a pendant sends it a line. */
  says(line: string): void {
    this.work(`pendant ${line}`);
  }
}

/** LinuxCNC behind its bridge: `estop`, `pause`, `resume` and `panel LINE` are done at its panel. */
export class LinuxCnc extends Pretended {
  constructor(...words: string[]) {
    super("linuxcnc", words);
  }
}
