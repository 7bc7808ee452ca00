import { type LengthUnit, millimetres } from "../units/quantity";
import { useSnapshot } from "./context";

/** The unit of lengths on this page. */
export const useLengthUnit = (): LengthUnit => useSnapshot("units") ?? millimetres;
