import { useHands, useScreen } from "../app/context";
import type { Face } from "../app/screen";
import { Choice } from "../ui/Choice";

const faces: readonly { value: Face; words: string }[] = [
  { value: "easy", words: "EASY" },
  { value: "full", words: "FULL" },
];

/** Buttons only, or everything. */
export function FaceSwitch() {
  const { screen } = useHands();
  const face = useScreen("face");
  return <Choice label="Face" options={faces} value={face} onChange={screen.face} />;
}
