import type { World } from "../actions/action";

/** Interval at which the machine is looked at, and how long a written setting may take, milliseconds. */
const everyMs = 50;
const patienceMs = 8000;

/** Waits until the machine has done what it was asked for and stands again; tells whether it does. */
export async function whenIdleAgain({ link }: World): Promise<boolean> {
  const end = Date.now() + patienceMs;
  while (Date.now() < end) {
    if (link.shown.get().snapshot?.machine.state === "idle") return true;
    await new Promise((resolve) => setTimeout(resolve, everyMs));
  }
  return false;
}
