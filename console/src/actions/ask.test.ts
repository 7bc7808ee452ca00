import { expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { createStore } from "../app/store";
import type { Link } from "../link/link";
import type { Shown } from "../link/shown";
import type { Act } from "../wire/messages";
import type { World } from "./action";
import { drive } from "./ask";

/** A world whose server grants the lease, telling so after its reply. */
function world(problem: "takeLease" | null = null) {
  const asked: Act[] = [];
  const said: string[] = [];
  const shown = createStore<Shown>({
    status: "open",
    who: { client: 4, role: "operator", device: "" },
    snapshot: firstSnapshot,
    roundTripMs: 1,
    aheadMs: 0,
    waitsFor: null,
  });
  const grant = () =>
    shown.update((now) => ({
      ...now,
      snapshot: { ...firstSnapshot, lease: { number: 9, client: 4, device: "" } },
    }));
  const link = {
    shown,
    close: () => undefined,
    ask: async (act: Act) => {
      asked.push(act);
      if (act.do === problem) {
        return { id: 0, problem: { why: "lease", text: "somebody else drives" }, notes: [] };
      }
      if (act.do === "takeLease") setTimeout(grant, 5);
      return { id: 0, problem: null, notes: [] };
    },
  } as Link;
  const screen = { tell: (text: string) => said.push(text) } as unknown as World["screen"];
  return { asked, said, world: { shown: shown.get(), link, screen } satisfies World };
}

it("takes the lease before it drives, and waits until it is told its number", async () => {
  const { asked, world: here } = world();
  expect(await drive(here, { do: "arm" })).toBe(true);
  expect(asked).toEqual([
    { do: "takeLease", force: false },
    { do: "arm", lease: 9 },
  ]);
});

it("does not take the lease twice", async () => {
  const { asked, world: here } = world();
  await drive(here, { do: "arm" });
  await drive(here, { do: "command", line: "MX,1" });
  expect(asked.map((act) => act.do)).toEqual(["takeLease", "arm", "command"]);
});

it("says why when somebody else drives, and asks nothing more", async () => {
  const { asked, said, world: here } = world("takeLease");
  expect(await drive(here, { do: "arm" })).toBe(false);
  expect(said).toEqual(["somebody else drives"]);
  expect(asked).toHaveLength(1);
});
