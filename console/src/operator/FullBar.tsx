import { FaceSwitch } from "./FaceSwitch";

/** The FULL face: menus and the command line. */
export function FullBar() {
  return (
    <div className="full">
      <FaceSwitch />
    </div>
  );
}
