import { useContext, useSyncExternalStore } from "react";
import type { Asked, Units } from "../wire/messages";
import { askedWords, isOfProgram } from "../words/asked";
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

/** A question in the language and the unit of the page; lengths that a program wrote stay as they are. */
export function useAsked(asked: Asked): Asked {
  const units = useUnits();
  const told = askedWords(asked);
  return isOfProgram(asked) ? told : { ...told, text: inUnits(told.text, units) };
}
