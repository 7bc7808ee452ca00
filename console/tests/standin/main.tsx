/** The console on a stand-in for the link: `?state=` chooses what is shown. */

import "@fontsource-variable/inter/wght.css";
import "@fontsource-variable/jetbrains-mono/wght.css";
import "../../src/theme/tokens.css";
import "../../src/theme/base.css";
import { createRoot } from "react-dom/client";
import { App } from "../../src/app/App";
import { createScreen } from "../../src/app/screen";
import { createStore } from "../../src/app/store";
import type { Link } from "../../src/link/link";
import type { Shown } from "../../src/link/shown";
import { answer } from "./server";
import { firstSnapshot } from "./snapshot";
import { states } from "./states";

window.fetch = (address) => answer(String(address));

const chosen = new URLSearchParams(location.search).get("state") ?? "";
const link: Link = {
  shown: createStore<Shown>({
    status: "open",
    who: { client: 1, role: "owner", device: "" },
    snapshot: { ...firstSnapshot, ...states[chosen] },
    roundTripMs: 3,
    aheadMs: 0,
    waitsFor: null,
  }),
  ask: async () => ({ id: 0, problem: null, notes: [] }),
  close: () => undefined,
};

const page = document.getElementById("page");
if (page) createRoot(page).render(<App hands={{ link, screen: createScreen() }} />);
