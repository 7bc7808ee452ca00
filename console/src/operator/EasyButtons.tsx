import { type Action, asking } from "../actions/action";
import { openFiles, openKeypad, openTools } from "../actions/go";
import { singleStep, start } from "../actions/job";
import { home, moveMode, preview, zeroAxis, zeroXY } from "../actions/machine";
import { useShown } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import { FaceSwitch } from "./FaceSwitch";
import "./easy-buttons.css";

/** A button of the EASY face: every one does what a command does. */
interface Easy {
  readonly action: Action;
  readonly words: string;
  /** The command of OpenSBP that does the same. */
  readonly command: string;
}

const [, , zeroZ] = zeroAxis;

/** Buttons that lead to a sheet or a screen of their own. */
const openSettings: Action = {
  id: "easy.settings",
  title: t("Settings"),
  section: "go",
  run: ({ screen }) => screen.go("/settings"),
};

const buttons: readonly Easy[] = [
  { action: openKeypad, words: "Move tool", command: "SK" },
  { action: asking(zeroXY), words: "Zero X Y", command: "Z2" },
  ...(zeroZ ? [{ action: asking(zeroZ), words: "Zero Z", command: "ZZ" }] : []),
  { action: home, words: "Work zero", command: "JH" },
  { action: openFiles, words: "Choose file", command: "FP" },
  { action: start, words: "Cut part", command: "FP" },
  { action: preview, words: "Preview", command: "SP" },
  { action: openTools, words: "Tools", command: "TD … TU" },
  { action: singleStep, words: "Single step", command: "FG" },
  { action: openSettings, words: "Settings", command: "VD" },
];

/** The EASY face: buttons, no commands. */
export function EasyButtons() {
  const previews = useShown((shown) => shown.snapshot?.machine.mode === "preview");
  const back = { action: moveMode, words: "Cut mode", command: "SM" };
  return (
    <nav className="easy" aria-label={t("EASY")}>
      {buttons
        .map((easy) => (easy.action === preview && previews ? back : easy))
        .map(({ action, words, command }) => (
          <ActionButton key={action.id} action={action} className="easy-button">
            {t(words)}
            <small>{command}</small>
          </ActionButton>
        ))}
      <FaceSwitch />
    </nav>
  );
}
