import { useHands } from "../app/context";
import { CommandLine } from "../command/CommandLine";
import { CommandMenus } from "../command/CommandMenus";
import { RecorderMark } from "../tools/RecorderSheet";
import { t } from "../words/words";
import { FaceSwitch } from "./FaceSwitch";
import "./full-bar.css";

/** The FULL face: menus and the command line. */
export function FullBar() {
  const { screen } = useHands();
  return (
    <div className="full">
      <div className="full-top">
        <CommandMenus />
        <button
          type="button"
          className="full-recorder"
          title={t("Recorded commands")}
          onClick={() => screen.open({ kind: "recorder" })}
        >
          <RecorderMark /> {t("Recorder")}
        </button>
        <FaceSwitch />
      </div>
      <CommandLine />
    </div>
  );
}
