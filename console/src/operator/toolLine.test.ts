import { expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import type { Call, CurrentRun } from "../wire/messages";
import { filesOfTool } from "./toolLine";

/** The files round the tool, which makes a move of this file and line, while these are open for the reader. */
function files(toolFile: string, line: number, calls: Call[]): string[] {
  const job = { ended: null, toolFile, calls } as unknown as CurrentRun;
  const told = { job, asked: null, motion: { ...firstSnapshot.motion, line } };
  return filesOfTool(told).map((place) => `${place.file} ${place.line}`);
}

it("lists each open file with its line, the last with that of the tool", () => {
  const nested = [
    { file: "a.sbp", line: 3 },
    { file: "b.sbp", line: 9 },
  ];
  expect(files("b.sbp", 7, nested)).toEqual(["a.sbp 3", "b.sbp 7"]);
  expect(files("a.sbp", 2, nested)).toEqual(["a.sbp 2"]);
});

it("gives no line to a file that is read further than the tool is", () => {
  expect(files("b.sbp", 7, [{ file: "a.sbp", line: 5 }])).toEqual(["a.sbp 0", "b.sbp 7"]);
});

it("lists nothing while no program runs", () => {
  expect(filesOfTool({ ...firstSnapshot, job: null })).toEqual([]);
});
