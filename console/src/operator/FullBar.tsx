import { CommandLine } from "../command/CommandLine";
import { CommandMenus } from "../command/CommandMenus";
import { FaceSwitch } from "./FaceSwitch";
import "./full-bar.css";

/** The FULL face: menus and the command line. */
export function FullBar() {
  return (
    <div className="full">
      <div className="full-top">
        <CommandMenus />
        <FaceSwitch />
      </div>
      <CommandLine />
    </div>
  );
}
