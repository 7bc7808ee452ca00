import { useContext, useSyncExternalStore } from "react";
import type { Asked, Units } from "../wire/messages";
import { askedWords } from "../words/asked";
import { serverWords } from "../words/server";
import { HandsContext } from "./context";
import { inUnits } from "./inUnits";

/** A page that is not let in yet hears nothing of the machine. */
const unwatched = () => () => {};

/** The unit in which a person reads lengths at this page. */
function useUnits(): Units | undefined {
  const shown = useContext(HandsContext)?.link.shown;
  const read = () => shown?.get().snapshot?.units;
  return useSyncExternalStore(shown?.watch ?? unwatched, read, read);
}

/** Puts sentences of the server into the language and the unit of the page. */
export function useWords(): (text: string) => string {
  const units = useUnits();
  return (text) => inUnits(serverWords(text), units);
}

/** Kinds of questions whose words are the program's own: their lengths too stay as they were written. */
const ofPrograms = ["input", "msgbox", "pause"];

/** A question in the language and the unit of the page. */
export function useAsked(asked: Asked): Asked {
  const units = useUnits();
  const told = askedWords(asked);
  return ofPrograms.includes(asked.kind) ? told : { ...told, text: inUnits(told.text, units) };
}
