import type { Action } from "../actions/action";
import { openFiles, openKeypad } from "../actions/go";
import { singleStep, start } from "../actions/job";
import { home, zeroAxis, zeroXY } from "../actions/machine";
import { ActionButton } from "../ui/ActionButton";
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

const buttons: readonly Easy[] = [
  { action: openKeypad, words: "Move tool", command: "SK" },
  { action: zeroXY, words: "Zero X Y", command: "Z2" },
  ...(zeroZ ? [{ action: zeroZ, words: "Zero Z", command: "ZZ" }] : []),
  { action: home, words: "Home", command: "JH" },
  { action: openFiles, words: "Choose file", command: "FP" },
  { action: start, words: "Cut part", command: "FP" },
  { action: singleStep, words: "Single step", command: "FG" },
];

/** The EASY face: buttons, no commands. */
export function EasyButtons() {
  return (
    <nav className="easy" aria-label="EASY">
      {buttons.map(({ action, words, command }) => (
        <ActionButton key={action.id} action={action} className="easy-button">
          {words}
          <small>{command}</small>
        </ActionButton>
      ))}
      <FaceSwitch />
    </nav>
  );
}
