/** A pretended board with step queues, for tests. */

import { Pretended } from "./controller";

/** One on a pseudo terminal, which makes its steps in real time. */
export class Board extends Pretended {
  constructor() {
    super("klipper", ["0.5"]);
  }

  /** Counts of its motors. */
  async counts(): Promise<number[]> {
    this.work("where");
    const counts = /counts \[([^\]]*)\]/.exec(await this.line())?.[1] ?? "";
    return counts.split(",").filter(Boolean).map(Number);
  }
}
