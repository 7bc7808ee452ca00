import { lazy, Suspense } from "react";
import { OperatorScreen } from "../operator/OperatorScreen";
import "./app.css";
import { StepBar } from "../debugger/StepBar";
import { HandConsole } from "../handconsole/HandConsole";
import { HelpScreen } from "../help/HelpScreen";
import { otherVersion } from "../link/version";
import { MessageWindow } from "../operator/MessageWindow";
import { PauseCard } from "../operator/PauseCard";
import { SettingsScreen } from "../settings/SettingsScreen";
import { CalculatorSheet } from "../tools/CalculatorSheet";
import { Asking, covers } from "./Asking";
import { ComingScreen } from "./ComingScreen";
import { type Hands, HandsContext, useScreen, useShown, useSnapshot } from "./context";
import { DropFiles } from "./DropFiles";
import { FirstVisit } from "./FirstVisit";
import { FollowedFace } from "./FollowedFace";
import { Guard } from "./Guard";
import { Keys } from "./Keys";
import { LostLink } from "./LostLink";
import { Notices } from "./Notices";
import { Notifications } from "./Notifications";
import { OpenSheet } from "./OpenSheet";
import { OtherVersion } from "./OtherVersion";
import { PairScreen } from "./PairScreen";
import { type Route, shownIn } from "./routes";
import { Sounds } from "./Sounds";
import { StartedUp } from "./StartedUp";
import { Together } from "./Together";
import { TopStrip } from "./TopStrip";

/** The strip with STOP, one screen, and what lies over it; the strip is never covered. */
export function App({ hands }: { hands: Hands }) {
  return (
    <HandsContext value={hands}>
      <Keys />
      <Guard>
        <Together />
      </Guard>
      <TopStrip />
      <Guard>
        <OfThisVersion />
      </Guard>
      <Guard>
        <Notices />
        <Sounds />
        <Notifications />
      </Guard>
    </HandsContext>
  );
}

/** The editor is large and fetched when it is wanted. */
const EditScreen = lazy(async () => ({
  default: (await import("../editor/EditScreen")).EditScreen,
}));

const DrawScreen = lazy(async () => ({
  default: (await import("../draw/DrawScreen")).DrawScreen,
}));

function OfThisVersion() {
  const other = useShown(otherVersion);
  if (other === undefined) return <Body />;
  return (
    <div className="body">
      <main className="screen">
        <OtherVersion kerf={other} />
      </main>
    </div>
  );
}

function Body() {
  const drawingOnly = useSnapshot("drawingOnly") ?? false;
  const route = shownIn(useScreen("route"), drawingOnly);
  const sheet = useScreen("sheet");
  const asked = useShown((shown) => shown.snapshot?.asked);
  const calculator = useScreen("calculator");
  const handConsole = useScreen("handConsole");
  const covered = sheet !== null || calculator !== null || (asked ? covers(asked) : false);
  return (
    <div className="body">
      <main className="screen" inert={covered}>
        <Guard about={route}>
          <Suspense fallback={null}>
            <RouteScreen route={route} />
          </Suspense>
        </Guard>
      </main>
      <Guard>
        <MessageWindow />
        <PauseCard />
        <FollowedFace />
        <StartedUp />
        <FirstVisit />
      </Guard>
      <Guard about={sheet?.kind}>{sheet && <OpenSheet sheet={sheet} />}</Guard>
      <Guard about={asked?.number}>{asked && <Asking asked={asked} />}</Guard>
      <Guard>
        <StepBar />
      </Guard>
      <Guard about={calculator?.field}>
        {calculator && <CalculatorSheet field={calculator.field} />}
      </Guard>
      <Guard>{handConsole && <HandConsole />}</Guard>
      <Guard>
        <DropFiles />
      </Guard>
      <LostLink />
      <PairScreen />
    </div>
  );
}

function RouteScreen({ route }: { route: Route }) {
  switch (route) {
    case "/":
      return <OperatorScreen />;
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
