import { useState } from "react";
import { appear, setAppear, sheetsAppear } from "../command/preferences";
import { Choice } from "../ui/Choice";

/** Chooses when fill-in sheets appear while a command is typed. */
export function SheetsAppearChoice() {
  const [when, setWhen] = useState(appear);
  return (
    <Choice
      label="Fill-in sheets appear"
      options={sheetsAppear}
      value={when}
      onChange={(next) => {
        setAppear(next);
        setWhen(next);
      }}
    />
  );
}
