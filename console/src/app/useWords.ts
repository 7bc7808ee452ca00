import { serverWords } from "../words/server";
import { useSnapshot } from "./context";
import { inUnits } from "./inUnits";

/** Puts sentences of the server into the language and the unit of the page. */
export function useWords(): (text: string) => string {
  const units = useSnapshot("units");
  return (text) => inUnits(serverWords(text), units);
}
