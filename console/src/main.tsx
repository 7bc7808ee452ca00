import "@fontsource-variable/inter/wght.css";
import "@fontsource-variable/jetbrains-mono/wght.css";
import "./theme/tokens.css";
import "./theme/base.css";
import "./ui/families.css";
import { StrictMode } from "react";
import { flushSync } from "react-dom";
import { createRoot } from "react-dom/client";
import { App } from "./app/App";
import { createScreen } from "./app/screen";
import { openLink, socketAddress } from "./link/link";
import { keepRecent } from "./operator/recent";
import { tellsListsTheirPlace } from "./ui/scrolled";
import { language } from "./words/words";

document.documentElement.lang = language;

const hands = { link: openLink(socketAddress(location)), screen: createScreen() };

tellsListsTheirPlace(document);
keepRecent(hands.link.shown);

// How far this page has followed the server, for whoever looks at it from outside: compare `revision` of
// /api/state.
hands.link.shown.watch(() => {
  document.documentElement.dataset.revision = `${hands.link.shown.get().snapshot?.revision ?? ""}`;
});

const page = document.getElementById("page");
if (page) {
  const root = createRoot(page);
  // Shown before the browser tells that the page is loaded, so that STOP is heard from the first moment.
  flushSync(() =>
    root.render(
      <StrictMode>
        <App hands={hands} />
      </StrictMode>,
    ),
  );
}
