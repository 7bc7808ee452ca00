/** Carries a typed line out: what the page does itself, and what the machine does. */

import type { World } from "../actions/action";
import { drive } from "../actions/ask";
import { openCalculator, openKeypad } from "../actions/go";
import { evaluate, isExpression, resultText } from "../app/expression";
import type { Sheet } from "../app/screen";
import { getJson } from "../link/http";
import type { Values } from "../wire/messages";
import { lastFile, runsFile } from "./lastFile";
import { argumentsOf, lettersOf } from "./line";

/** Commands that open something on the page. */
const opens: Record<string, Sheet> = {
  MN: { kind: "nudge" },
  SI: { kind: "scratch" },
  UV: { kind: "values", which: "settings" },
  UL: { kind: "values", which: "variables" },
  UD: { kind: "values", which: "diagnostics" },
};

/** Commands that open a page of the help. */
const explains = /^H[A-Z]$/;

export function execute(world: World, text: string): void {
  const letters = lettersOf(text) ?? "";
  const given = argumentsOf(text);
  const sheet = given.length === 0 ? opens[letters] : undefined;
  if (sheet) {
    world.screen.open(sheet);
    // The page shows it; the machine keeps it in its problem log.
    if (letters === "UD") carryOut(world, letters, given);
  } else if (letters === "UU" && given.length === 0) openCalculator.run(world);
  else if (letters === "SK" && given.length === 0) openKeypad.run(world);
  else if (explains.test(letters)) world.screen.explain(letters);
  else if (letters === "FN") world.screen.edit("");
  else if (letters === "FE") void edit(world, given[0]);
  else if (runsFile(letters) && given.length === 0) void offerLast(world, letters);
  else carryOut(world, text, given);
}

/** FP and FG without a name: the sheet with the file that was last, which Enter runs; else the files there are. */
async function offerLast(world: World, letters: string): Promise<void> {
  const name = await lastFile(world);
  if (name) world.screen.open({ kind: "command", letters, given: [name] });
  else world.screen.open({ kind: "files" });
}

/** Opens a file in the editor: without a name the one that ran or was open last, else an empty page. */
async function edit(world: World, name: string | undefined): Promise<void> {
  const { opened, folder } = world.shown.snapshot ?? {};
  if (name) return world.screen.edit(folder?.name ? `${folder.name}/${name}` : name);
  const { partFile } = await getJson<Values>("/api/values");
  world.screen.edit(partFile || opened?.name || "");
}

function carryOut(world: World, text: string, given: readonly string[]): void {
  const result = calculated(given);
  if (result) world.screen.tell(result);
  void drive(world, { do: "command", line: text });
}

/** `12+11/16 = 12.6875` for each parameter that was calculated. */
function calculated(given: readonly string[]): string {
  const results = given
    .filter(isExpression)
    .map((text) => `${text} = ${resultText(evaluate(text) ?? 0)}`);
  return results.join(", ");
}
