/** Asks the server and tells the person what it refused. */

import { drawingWords } from "../app/drawingWords";
import { leaseOf, type Shown } from "../link/shown";
import type { Act, Reply } from "../wire/messages";
import type { World } from "./action";

/** Asks; a refusal becomes a notice. Tells whether it was done. */
export async function ask(world: World, act: Act): Promise<boolean> {
  const { problem } = await world.link.ask(act);
  if (problem) world.screen.tell(isOfDrawing(act) ? drawingWords(problem.text) : problem.text);
  return problem === null;
}

const isOfDrawing = (act: Act): boolean => act.do === "draw" || act.do === "machine";

/** An act of the driver: everything that carries the number of the lease. */
type Driven = Extract<Act, { lease: number }>;
type WithoutLease<A> = A extends Driven ? Omit<A, "lease"> : never;

/** Asks as the driver; takes the lease before when nobody drives. */
export async function drive(world: World, act: WithoutLease<Driven>): Promise<boolean> {
  const lease = await leased(world);
  return lease !== undefined && ask(world, { ...act, lease } as Driven);
}

/** The number of this page's lease; asks for one when nobody drives. */
export async function leased(world: World): Promise<number | undefined> {
  const held = leaseOf(world.link.shown.get());
  if (held !== undefined) return held;
  const { problem }: Reply = await world.link.ask({ do: "takeLease", force: false });
  if (problem) {
    world.screen.tell(problem.text);
    return undefined;
  }
  return told(world, leaseOf);
}

/** Longest time that the server may take to tell of what it granted, milliseconds. */
const patienceMs = 1000;

/** Waits until the server tells something; a reply may overtake the change it is about. */
function told<T>(world: World, read: (shown: Shown) => T | undefined): Promise<T | undefined> {
  const { shown } = world.link;
  return new Promise((resolve) => {
    const look = () => {
      const found = read(shown.get());
      if (found === undefined) return;
      end(found);
    };
    const end = (found: T | undefined) => {
      clearTimeout(timer);
      unwatch();
      resolve(found);
    };
    const unwatch = shown.watch(look);
    const timer = setTimeout(() => end(undefined), patienceMs);
    look();
  });
}
