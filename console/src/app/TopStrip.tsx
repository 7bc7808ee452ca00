import { disarm, hold } from "../actions/machine";
import { otherVersion } from "../link/version";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { ArmButton } from "./ArmButton";
import { useShown, useSnapshot } from "./context";
import { Guard } from "./Guard";
import { HoldButton } from "./HoldButton";
import { LeaseChip } from "./LeaseChip";
import { ModeChip } from "./ModeChip";
import { Navigation } from "./Navigation";
import { SpaceTypes } from "./SpaceTypes";
import { StateWord } from "./StateWord";
import { StopButton } from "./StopButton";
import "./top-strip.css";

/**
 * On every screen, above every dialog: what the machine is doing, hold, STOP.
 *
 * What fails leaves STOP where it is. Libraries that hide the page behind an overlay leave a "top layer" alone.
 */
export function TopStrip() {
  const other = useShown(otherVersion);
  return other === undefined ? <WholeStrip /> : <StopsOnly />;
}

/** All that is left to a page of another version than the server's. */
function StopsOnly() {
  return (
    <header className="strip" data-react-aria-top-layer="true">
      <div className="strip-end">
        <Guard>
          <ActionButton action={disarm} size="small">
            Disarm
          </ActionButton>
          <ActionButton action={hold} look="hold" className="hold-button" />
        </Guard>
        <StopButton />
      </div>
    </header>
  );
}

function WholeStrip() {
  const staysOn = useSnapshot("setup")?.outputsStayOn ?? false;
  const drawingOnly = useSnapshot("drawingOnly") ?? false;
  return (
    <header className="strip" data-react-aria-top-layer="true">
      <Guard instead={<LoadAgain />}>
        <Navigation />
        {drawingOnly ? (
          <p className="strip-words">{t("Drawings only: the machine is left alone")}</p>
        ) : (
          <>
            <ModeChip />
            <StateWord />
            {staysOn && <p className="strip-words">{t("Outputs stay on after STOP")}</p>}
            <ArmButton />
          </>
        )}
      </Guard>
      <div className="strip-end">
        <Guard instead={<LoadAgain />}>
          <LeaseChip />
          <HoldButton />
        </Guard>
        <StopButton />
        <SpaceTypes />
      </div>
    </header>
  );
}

function LoadAgain() {
  return (
    <Button size="small" onPress={() => location.reload()}>
      This part failed: load the page again
    </Button>
  );
}
