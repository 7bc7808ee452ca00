import { useContext, useSyncExternalStore } from "react";
import { serverWords } from "../words/server";
import { HandsContext } from "./context";
import { inUnits } from "./inUnits";

/** A page that is not let in yet hears nothing of the machine. */
const unwatched = () => () => {};

/** Puts sentences of the server into the language and the unit of the page. */
export function useWords(): (text: string) => string {
  const shown = useContext(HandsContext)?.link.shown;
  const read = () => shown?.get().snapshot?.units;
  const units = useSyncExternalStore(shown?.watch ?? unwatched, read, read);
  return (text) => serverWords(inUnits(text, units));
}
