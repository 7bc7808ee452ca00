import { lazy, Suspense } from "react";
import { OperatorScreen } from "../operator/OperatorScreen";
import "./app.css";
import { HelpScreen } from "../help/HelpScreen";
import { MessageWindow } from "../operator/MessageWindow";
import { PauseCard } from "../operator/PauseCard";
import { SettingsScreen } from "../settings/SettingsScreen";
import { CalculatorSheet } from "../tools/CalculatorSheet";
import { Asking, covers } from "./Asking";
import { ComingScreen } from "./ComingScreen";
import { type Hands, HandsContext, useScreen, useShown, useSnapshot } from "./context";
import { FollowedFace } from "./FollowedFace";
import { Keys } from "./Keys";
import { LostLink } from "./LostLink";
import { Notices } from "./Notices";
import { OpenSheet } from "./OpenSheet";
import { PairScreen } from "./PairScreen";
import { shownIn } from "./routes";
import { Sounds } from "./Sounds";
import { StartedUp } from "./StartedUp";
import { TopStrip } from "./TopStrip";

/** The strip with STOP, one screen, and what lies over it; the strip is never covered. */
export function App({ hands }: { hands: Hands }) {
  return (
    <HandsContext value={hands}>
      <Keys />
      <TopStrip />
      <Body />
      <Notices />
      <Sounds />
    </HandsContext>
  );
}

/** The editor is large and fetched when it is wanted. */
const EditScreen = lazy(async () => ({
  default: (await import("../editor/EditScreen")).EditScreen,
}));

const JobScreen = lazy(async () => ({
  default: (await import("../job/JobScreen")).JobScreen,
}));

const DrawScreen = lazy(async () => ({
  default: (await import("../draw/DrawScreen")).DrawScreen,
}));

function Body() {
  const sheet = useScreen("sheet");
  const asked = useShown((shown) => shown.snapshot?.asked);
  const calculator = useScreen("calculator");
  const covered = sheet !== null || calculator !== null || (asked ? covers(asked) : false);
  return (
    <div className="body">
      <main className="screen" inert={covered}>
        <Suspense fallback={null}>
          <Route />
        </Suspense>
      </main>
      <MessageWindow />
      <PauseCard />
      <FollowedFace />
      <StartedUp />
      {sheet && <OpenSheet sheet={sheet} />}
      {asked && <Asking asked={asked} />}
      {calculator && <CalculatorSheet field={calculator.field} />}
      <LostLink />
      <PairScreen />
    </div>
  );
}

function Route() {
  const drawingOnly = useSnapshot("drawingOnly") ?? false;
  const route = shownIn(useScreen("route"), drawingOnly);
  switch (route) {
    case "/":
      return <OperatorScreen />;
    case "/job":
      return <JobScreen />;
    case "/edit":
      return <EditScreen />;
    case "/draw":
      return <DrawScreen />;
    case "/settings":
      return <SettingsScreen />;
    case "/help":
      return <HelpScreen />;
    default:
      return <ComingScreen route={route} />;
  }
}
