import { useState } from "react";
import { start } from "../actions/job";
import { useSnapshot } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { t } from "../words/words";
import { isChecked, seen, unchecked } from "./contact";

interface TouchedProps {
  /** The program is made: it may be started once the probe was seen to work. */
  isMade: boolean;
  /** Number of the probe's input. */
  input: number;
}

/** The check of the probe, and Start behind it. */
export function Touched({ isMade, input }: TouchedProps) {
  const io = useSnapshot("io");
  const isClosed = io?.inputs.find(({ number }) => number === input)?.on ?? false;
  const [contact, setContact] = useState(unchecked);
  if (contact.isClosed !== isClosed) setContact(seen(contact, isClosed));
  return (
    <section className="probe-check" aria-label={t("Check of the probe")}>
      <p role="status" data-checked={isChecked(contact)}>
        {words(contact, input)}
      </p>
      {isMade && isChecked(contact) && (
        <ActionButton action={start} look="go">
          {t("Start probing")}
        </ActionButton>
      )}
    </section>
  );
}

function words(
  contact: { readonly isClosed: boolean; readonly wasClosed: boolean },
  input: number,
): string {
  if (contact.isClosed) return t("Input {0} is closed: take the plate away from the tool.", input);
  if (!contact.wasClosed)
    return t(
      "Touch the plate or the probe by hand: its input {0} has to close before anything moves.",
      input,
    );
  return t("The probe works.");
}
