import { expect, it } from "vitest";
import { nothingShown } from "./shown";
import { otherVersion, version } from "./version";

const told = (kerf: string) => ({ ...nothingShown, snapshot: { kerf } }) as never;

it("is that of the workspace, and told from others", () => {
  expect(version).toMatch(/^\d+\.\d+\.\d+/);
  expect(otherVersion(nothingShown)).toBeUndefined();
  expect(otherVersion(told(version))).toBeUndefined();
  expect(otherVersion(told("0.0.1"))).toBe("0.0.1");
});
